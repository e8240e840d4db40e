// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/population_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "armcal/comparison/objective.h"
#include "armcal/comparison/redundant_fit.h"
#include "armcal/core/diagnostics.h"

namespace armcal {
namespace {

std::vector<int> determined_parameters(const ArmModel& nominal,
                                       std::span<const ObservationGroup> groups) {
  const Calibration look = identifiability(nominal, groups, {});
  if (!look.ok()) throw NumericalError(look.detail);
  std::vector<int> determined;
  for (std::size_t i = 0; i < look.parameters.size(); ++i) {
    if (look.parameters[i].status == ParameterStatus::free)
      determined.push_back(static_cast<int>(i));
  }
  return determined;
}

Eigen::VectorXd half_widths(const ArmModel& nominal, const std::vector<int>& parameters,
                            const PopulationFitOptions& options) {
  const ParameterTable table(nominal);
  Eigen::VectorXd widths(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool is_length = table[parameters[i]].unit == ParameterUnit::mm;
    widths(static_cast<Eigen::Index>(i)) =
        is_length ? options.half_length_mm : options.half_angle_rad;
  }
  return widths;
}

}  // namespace

FoundArm population_fit(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                        const PopulationFitOptions& options, const Monitor& monitor) {
  if (!has_population_search()) {
    throw NumericalError("armcal was built without pagmo2 (Debian: libpagmo-dev)");
  }
  const std::vector<int> parameters =
      options.redundant ? written_parameters(nominal) : determined_parameters(nominal, groups);
  try {
    const ArmObjective objective(nominal, groups, parameters);
    const PopulationSearch search = search_population(
        options.method, [&](const Eigen::VectorXd& values) { return objective(values); },
        objective.start(), half_widths(nominal, parameters, options),
        {.evaluations = options.evaluations, .seed = options.seed, .monitor = monitor});
    FoundArm found;
    found.arm = objective.arm(search.best);
    found.free = parameters;
    found.remark = fmt::format("{} parameters, {} arms tried, chi-squared {:.4g}",
                               parameters.size(), search.evaluations, search.objective);
    return found;
  } catch (const std::invalid_argument& reason) {
    throw NumericalError(reason.what());
  }
}

}  // namespace armcal
