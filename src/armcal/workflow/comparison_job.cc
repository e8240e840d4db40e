// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/comparison_job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "armcal/observations/check_split.h"
#include "armcal/workflow/calibration_job.h"
#include "armcal/workflow/simulation_job.h"

namespace armcal {
namespace {

Eigen::Index held_out_rows(const std::vector<ObservationGroup>& groups) {
  Eigen::Index count = 0;
  for (const ObservationGroup& group : groups)
    count += std::count(group.is_check.begin(), group.is_check.end(), true);
  return count;
}

}  // namespace

Scenario scenario_to_compare(InputFiles& files, const std::string& name_or_path) {
  if (auto built_in = scenario_named(name_or_path)) return std::move(*built_in);
  if (!name_or_path.ends_with(".toml")) {
    throw std::invalid_argument(
        fmt::format("no scenario is called \"{}\"; built in: {}; or name a file, *.scenario.toml",
                    name_or_path, fmt::join(scenario_names(), ", ")));
  }
  const LoadedScenario loaded = load_scenario(files, name_or_path);
  if (loaded.truth) {
    throw std::invalid_argument(
        fmt::format("{}: the arms to compare on are drawn: leave out \"truth\"", name_or_path));
  }
  return {.name = name_or_path,
          .title = loaded.scenario.name,
          .nominal = loaded.nominal,
          .errors = loaded.scenario.errors,
          .surroundings = loaded.scenario.surroundings};
}

SessionComparison run_session_comparison(InputFiles& files, const std::string& path,
                                         const SessionComparisonOptions& options) {
  LoadedSession loaded = load_session(files, path);
  const bool split_here = held_out_rows(loaded.groups) == 0;
  if (split_here) {
    hold_out(loaded.groups, kSplitForComparison, loaded.session.estimate.check_seed);
  }
  if (held_out_rows(loaded.groups) == 0) {
    throw NumericalError(loaded.session.file + ": too few rows to hold some out to judge by");
  }
  SessionComparison comparison =
      compare_on_session(loaded.arm, loaded.groups, loaded.options, options);
  comparison.split_here = split_here;
  return comparison;
}

}  // namespace armcal
