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

void check_order_of_report(const ReportFlags& flags, const Context& context) {
  const ReportOrder& order = context.report_order;
  if (order.html) {
    throw std::invalid_argument("report writes to the file that -o names, not --report");
  }
  if (!flags.extract && !flags.output && !order.pdf) {
    throw std::invalid_argument("nothing to write: say -o FILE.html, --pdf FILE.pdf or --extract");
  }
  if (!flags.extract) {
    if (context.json && flags.output == "-") {
      throw std::invalid_argument(
          "-o -: the page and the object of --json cannot both go to standard output\n  help: name "
          "a file: -o FILE.html");
    }
    return;
  }
  if (order.pdf) {
    throw std::invalid_argument("--extract gives the numbers back and prints no PDF");
  }
  if (order.language || order.details_file) {
    throw std::invalid_argument(
        "--extract gives the numbers back as they are: no --lang, no --details");
  }
}

int extract(const ReportFlags& flags, const Context& context, const std::string& document,
            InputFiles& files) {
  context.warn(files.diagnostics());
  if (flags.output) {
    context.save(*flags.output, document, files.records());
  } else {
    context.out << document;
  }
  return kDone;
}

int run_report(const ReportFlags& flags, const Context& context) {
  check_order_of_report(flags, context);
  for (const auto& path : {flags.output, context.report_order.pdf}) {
    if (path) check_may_write(*path, context.overwrite);
  }
  InputFiles files(context.monitor);
  const SavedResult saved = load_saved_result(files, flags.result);
  if (flags.extract) return extract(flags, context, saved.document, files);

  const bool to_standard_output = flags.output == "-";
  ReportOrder order = context.report_order;
  if (!to_standard_output) order.html = flags.output;
  if (!order.language) order.language = saved.language.value_or("en");
  const bool keeps_details = !order.details_file;
  ReportWriter writer(order, context.overwrite, context.monitor,
                      keeps_details ? kept_details(files, saved) : ReportDetails());
  files.diagnostics().append(writer.diagnostics());
  writer.make(saved.document, flags.result, files.records());
  writer.print();
  writer.write_page();
  if (to_standard_output) {
    context.warn(files.diagnostics());
    context.out << writer.page();
    return kDone;
  }
  Json json;
  std::string text;
  for (const std::string& path : writer.paths()) text += fmt::format("{}\n", path);
  json["reports"] = writer.paths();
  json["language"] = *order.language;
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
