// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/report/fit_report.h"
#include "armcal/workflow/input_files.h"

namespace armcal::cli {
namespace {

struct Flags {
  std::string first;
  std::string second;
  bool scale = false;
  std::optional<double> u_mm;
  TableFlags table;
};

int run_register(const Flags& flags, const Context& context) {
  InputFiles files(context.monitor);
  const auto first = files.points(flags.first, flags.table.options());
  const auto second = files.points(flags.second, flags.table.options());
  files.require_good();
  if (first->points_mm.size() != second->points_mm.size()) {
    files.diagnostics().error({flags.second, 0, 0},
                              fmt::format("has {} points, {} has {}", second->points_mm.size(),
                                          flags.first, first->points_mm.size()),
                              "points are paired by their order: row 1 with row 1, and so on");
    files.require_good();
  }
  const Registration fit = register_points(first->points_mm, second->points_mm,
                                           {{.u_point_mm = flags.u_mm}, flags.scale});
  if (!fit.ok()) {
    throw NumericalError(
        fmt::format("{} and {}: no transform: {}", flags.first, flags.second, explain(fit.status)));
  }
  context.emit(files.records(), files.diagnostics(), json_result(fit), text_result(fit));
  return kDone;
}

}  // namespace

Command register_command() {
  const auto flags = std::make_shared<Flags>();
  Command command;
  command.name = "register";
  command.brief = "rigid transform between paired points";
  command.description =
      "Finds rotation and translation (with --scale also a scale) that carry the points of A.csv "
      "to those of B.csv, row by\n"
      "row, in the least-squares sense. Never a reflection.";
  command.arguments =
      joined({{"A.csv", "points x_mm,y_mm,z_mm", &flags->first},
              {"B.csv", "the same points in the other frame", &flags->second},
              {"--scale", "estimate a common scale too", &flags->scale},
              {"--u", "standard uncertainty of each coordinate of B, mm; else from the scatter",
               &flags->u_mm, "MM"}},
             flags->table.for_points());
  command.examples = {
      "armcal register examples/points/frame-a.csv examples/points/frame-b.csv",
      "armcal register examples/points/frame-a.csv examples/points/frame-b.csv --scale --json"};
  command.run = [flags](const Context& context) { return run_register(*flags, context); };
  return command;
}

}  // namespace armcal::cli
