// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/report/fit_report.h"
#include "armcal/workflow/registration_job.h"

namespace armcal::cli {
namespace {

struct RegisterFlags {
  std::string first;
  std::string second;
  bool scale = false;
  std::optional<double> u_mm;
  TableFlags table;
};

constexpr const char* kMirrored = "the points look mirrored: is one axis reversed in one file?";

int run_register(const RegisterFlags& flags, const Context& context) {
  InputFiles files(context.monitor);
  const PointPairs pairs =
      read_point_pairs(files, flags.first, flags.second, flags.table.options());
  const Registration fit =
      register_points(pairs.first_mm, pairs.second_mm, {{.u_point_mm = flags.u_mm}, flags.scale});
  if (!fit.ok()) {
    throw NumericalError(fmt::format("{} and {}: no transform: {}{}", flags.first, flags.second,
                                     explain(fit.status),
                                     fit.looks_mirrored ? fmt::format("; {}", kMirrored) : ""));
  }
  if (fit.looks_mirrored) {
    files.diagnostics().warning({flags.second, 0, 0}, kMirrored,
                                "a reflection would fit better, but no arm makes one");
  }
  Json json = json_result(fit);
  json["paired_by"] = pairs.by_name ? "point" : "order";
  context.emit(files.records(), files.diagnostics(), json, text_result(fit));
  return kDone;
}

}  // namespace

Command register_command() {
  const auto flags = std::make_shared<RegisterFlags>();
  Command command;
  command.name = "register";
  command.brief = "rigid transform between paired points";
  command.description =
      "Finds rotation and translation (with --scale also a scale) that carry the points of A.csv "
      "to those of B.csv, in the\n"
      "least-squares sense: paired by the column point where both have one, else row by row. Never "
      "a "
      "reflection.";
  command.arguments =
      joined({{"A.csv", "points x_mm,y_mm,z_mm", &flags->first},
              {"B.csv", "the same points in the other frame", &flags->second},
              {"--scale", "estimate a common scale too", &flags->scale},
              {"--u", "standard uncertainty of each coordinate of B, mm; else from the scatter",
               &flags->u_mm, "MM", NumberRange::positive}},
             flags->table.for_points());
  command.examples = {
      "armcal register examples/points/frame-a.csv examples/points/frame-b.csv",
      "armcal register examples/points/frame-a.csv examples/points/frame-b.csv --scale --json"};
  command.run = [flags](const Context& context) { return run_register(*flags, context); };
  return command;
}

}  // namespace armcal::cli
