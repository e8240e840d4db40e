// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "armcal/cli/commands.h"
#include "armcal/workflow/report_job.h"

namespace armcal::cli {
namespace {

struct ReportFlags {
  std::string result;
  std::optional<std::string> output;
  bool extract = false;
};

int extract(const ReportFlags& flags, const Context& context, const std::string& document,
            const InputFiles& files) {
  if (context.report_order.pdf) {
    throw std::invalid_argument("--extract gives the numbers back and prints no PDF");
  }
  if (flags.output) {
    context.save(*flags.output, document, files.records());
  } else {
    context.out << document;
  }
  return kDone;
}

int run_report(const ReportFlags& flags, const Context& context) {
  if (context.report_order.html) {
    throw std::invalid_argument("report writes to the file that -o names, not --report");
  }
  if (!flags.extract && !flags.output && !context.report_order.pdf) {
    throw std::invalid_argument("nothing to write: say -o FILE.html, --pdf FILE.pdf or --extract");
  }
  for (const auto& path : {flags.output, context.report_order.pdf}) {
    if (path) check_may_write(*path, context.overwrite);
  }
  InputFiles files(context.monitor);
  SavedResult saved = load_saved_result(files, flags.result);
  if (flags.extract) return extract(flags, context, saved.document, files);

  ReportOrder order = context.report_order;
  order.html = flags.output;
  ReportWriter writer(order, context.overwrite, context.monitor, std::move(saved.details));
  writer.make(saved.document, flags.result, files.records());
  writer.print();
  writer.write_page();
  Json json;
  std::string text;
  for (const std::string& path : writer.paths()) text += fmt::format("{}\n", path);
  json["reports"] = writer.paths();
  json["language"] = order.language;
  context.emit(files.records(), files.diagnostics(), json, text);
  return kDone;
}

}  // namespace

Command report_command() {
  const auto flags = std::make_shared<ReportFlags>();
  Command command;
  command.name = "report";
  command.brief = "a saved result as a report of one HTML file, or on paper";
  command.description =
      "Takes what any command printed with --json or saved with --save, or a report, and makes a "
      "report of it: in\n"
      "another language, with other details (customer, item, references), as PDF. --extract gives "
      "the numbers of a\n"
      "report back as JSON, byte for byte. Every command makes the same report at once with "
      "--report FILE.";
  command.arguments = {
      {"RESULT", "result (JSON) or report (HTML)", &flags->result},
      {"-o,--output", "write the report here; with --extract, the JSON", &flags->output, "FILE"},
      {"--extract", "give the result document (JSON) of a report back", &flags->extract}};
  command.examples = {
      "armcal calibrate examples/calibration/tracker.session.toml --report calibration.html",
      "armcal report calibration.html -o calibration.zh.html --lang zh",
      "armcal report calibration.html --extract"};
  command.run = [flags](const Context& context) { return run_report(*flags, context); };
  return command;
}

}  // namespace armcal::cli
