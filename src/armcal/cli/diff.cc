// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"
#include "armcal/workflow/prediction_job.h"

namespace armcal::cli {
namespace {

struct DiffFlags {
  std::string before;
  std::string after;
};

// By more than three times its uncertainty, or at all where neither calibration estimated it. What
// only one of them estimated differs by convention.
bool has_changed(const ParameterChange& change) {
  constexpr double kNotable = 3.0;
  return !change.held_in_one && std::abs(change.ratio) > kNotable;
}

Json json_of_changes(const DiffFlags& flags, const std::vector<ParameterChange>& changes) {
  Json json;
  json["before"] = flags.before;
  json["after"] = flags.after;
  json["changes"] = Json::array();
  for (const ParameterChange& each : changes) {
    json["changes"].push_back({{"name", each.name},
                               {"unit", to_string(each.unit)},
                               {"before", each.before},
                               {"after", each.after},
                               {"change", each.after - each.before},
                               {"u", each.u},
                               {"ratio", json_number(each.ratio)},
                               {"held_in_one", each.held_in_one},
                               {"changed", has_changed(each)}});
  }
  return json;
}

std::string text_of_changes(const std::vector<ParameterChange>& changes) {
  TextTable table({{"parameter", Align::left},
                   {"before"},
                   {"after"},
                   {"change"},
                   {"u"},
                   {"unit", Align::left},
                   {"change / u"},
                   {"", Align::left}});
  for (const ParameterChange& each : changes) {
    if (each.u == 0.0 && each.before == each.after) continue;
    const double factor = each.unit == ParameterUnit::mm ? 1.0 : degrees_from_radians(1.0);
    const int decimals = each.u > 0.0 ? decimals_for_uncertainty(factor * each.u) : 6;
    const bool is_finite = std::isfinite(each.ratio);
    const std::string remark = each.held_in_one    ? "held in one of them"
                               : has_changed(each) ? "changed"
                                                   : "";
    table.add_row({each.name, fixed(factor * each.before, decimals),
                   fixed(factor * each.after, decimals),
                   fixed(factor * (each.after - each.before), decimals),
                   fixed(factor * each.u, decimals), each.unit == ParameterUnit::mm ? "mm" : "deg",
                   is_finite ? fixed(each.ratio, 1) : "-", remark});
  }
  return "Change of every parameter, in units of its standard uncertainty\n" + table.text();
}

int run_diff(const DiffFlags& flags, const Context& context) {
  InputFiles files(context.monitor);
  const auto changes = changes_between(files, flags.before, flags.after);
  context.emit(files.records(), files.diagnostics(), json_of_changes(flags, changes),
               text_of_changes(changes));
  return kDone;
}

}  // namespace

Command diff_command() {
  const auto flags = std::make_shared<DiffFlags>();
  Command command;
  command.name = "diff";
  command.brief = "change of every parameter between two saved calibrations";
  command.description =
      "Reads two files of armcal calibrate --save of the same arm and shows each parameter's "
      "change in units of its\n"
      "standard uncertainty, both calibrations taken as independent.";
  command.arguments = {{"BEFORE", "saved calibration (JSON)", &flags->before},
                       {"AFTER", "saved calibration (JSON)", &flags->after}};
  command.examples = {
      "armcal diff examples/calibration/tracker.calibration.json "
      "examples/calibration/seats.calibration.json"};
  command.run = [flags](const Context& context) { return run_diff(*flags, context); };
  return command;
}

}  // namespace armcal::cli
