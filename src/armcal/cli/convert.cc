// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/workflow/conversion.h"

namespace armcal::cli {
namespace {

struct ConvertFlags {
  std::string input;
  std::optional<std::string> output;
  std::optional<std::string> from;
  std::optional<std::string> chain;
  std::string to = "arm";
  bool csv = false;
  TableFlags table;
};

int run_convert(const ConvertFlags& flags, const Context& context) {
  if (flags.output) check_may_write(*flags.output, context.overwrite);
  InputFiles files(context.monitor);
  ConversionRequest request;
  request.input = flags.input;
  if (flags.from) request.from = arm_format(*flags.from);
  request.chain = flags.chain;
  request.to = arm_format(flags.to).value();
  request.as_csv = flags.csv || (flags.output && flags.output->ends_with(".csv"));
  const bool is_table = request.to == ArmFormat::dh_classic || request.to == ArmFormat::dh_modified;
  if (request.as_csv && !is_table && (flags.csv || request.to != ArmFormat::csv_line)) {
    throw std::invalid_argument(
        fmt::format("{} is for D-H tables, not for --to {}\n  help: give --to dh-classic or --to "
                    "dh-modified, or another output name",
                    flags.csv ? "--csv" : "an output name *.csv", flags.to));
  }
  std::string text = convert(files, request, flags.table.options());
  Json json;
  json["format"] = flags.to;
  json["text"] = text;
  if (flags.output) {
    context.save(*flags.output, text, files.records());
    text.clear();
  }
  context.emit(files.records(), files.diagnostics(), json, text);
  return kDone;
}

}  // namespace

Command convert_command() {
  const auto flags = std::make_shared<ConvertFlags>();
  Command command;
  command.name = "convert";
  command.brief =
      "arm files from and to URDF and D-H tables, with the same poses; C and CSV for firmware";
  command.description =
      "Reads an arm file, a robot description (*.urdf), a D-H file (*.dh.toml) or a spreadsheet\n"
      "theta_deg,d_mm,a_mm,alpha_deg (then --from tells the convention). Writes each of them, and "
      "for "
      "firmware a C header\n"
      "that computes the tip, or one line of all parameters. What the target cannot say is warned "
      "of.";
  command.arguments = joined(
      {{"INPUT", "description of an arm; - for standard input", &flags->input},
       {"--to", "format to write", &flags->to, "FORMAT", NumberRange::any, arm_format_names()},
       {"--from",
        "convention of a D-H table; a spreadsheet does not tell its own",
        &flags->from,
        "FORMAT",
        NumberRange::any,
        {"dh-classic", "dh-modified"}},
       {"--chain", "links of a URDF between which the arm lies", &flags->chain, "BASE:TIP"},
       {"--csv", "write a D-H table as a spreadsheet (also by an output name *.csv)", &flags->csv},
       {"-o,--output", "write here instead of to standard output", &flags->output, "FILE"}},
      {{"--map", "our column names by those of the file: theta_deg=Theta,d_mm=D", &flags->table.map,
        "OURS=THEIRS"}});
  command.examples = {
      "armcal convert examples/arms/puma-560.arm.toml --to dh-classic --csv",
      "armcal convert examples/arms/romer-infinite-2.0.arm.toml --to dh-modified -o romer.dh.toml",
      "armcal convert examples/urdf/ur10.urdf -o ur10.arm.toml",
      "armcal convert examples/arms/gao-2018.arm.toml --to urdf -o gao.urdf",
      "armcal convert examples/arms/romer-infinite-2.0.arm.toml --to c-header -o arm.h",
      "armcal convert examples/dh/panda-modified.csv --from dh-modified -o panda.arm.toml"};
  command.run = [flags](const Context& context) { return run_convert(*flags, context); };
  return command;
}

}  // namespace armcal::cli
