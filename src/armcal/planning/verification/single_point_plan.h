// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ASME B89.4.22, single-point articulation: a seat in the near (below 20 % of the reach), middle
/// (20 to 80 %) and far zone (above 80 %), each with ten articulations that differ as much as can
/// be. @throws ImpossiblePlan with the reason for every zone that has no place
[[nodiscard]] PlannedTest plan_single_point_articulation(const PlanningCircumstances& with);

}  // namespace armcal
