// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/comparison/method.h"
#include "armcal/comparison/population_search.h"
#include "armcal/core/units.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

struct PopulationFitOptions {
  PopulationMethod method = PopulationMethod::differential_evolution;
  /// Search in every written parameter, as papers do, or only in those that the readings tell
  /// apart.
  bool redundant = false;
  double half_length_mm = 1.0;  ///< of the box about the nominal arm
  double half_angle_rad = radians_from_degrees(0.2);
  std::int64_t evaluations = 200000;
  std::uint64_t seed = 1;
};

/// An arm by a search without derivatives, on the objective of least squares. States no
/// uncertainties.
/// @throws NumericalError where it cannot: built without pagmo2, or readings that cannot be placed
[[nodiscard]] FoundArm population_fit(const ArmModel& nominal,
                                      std::span<const ObservationGroup> groups,
                                      const PopulationFitOptions& options, const Monitor& monitor);

}  // namespace armcal
