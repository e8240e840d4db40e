// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ASME B89.4.22, effective diameter: nine points on a sphere in the middle of the volume (40 to
/// 70 % of the reach), three times. @throws ImpossiblePlan with the reason
[[nodiscard]] PlannedTest plan_effective_diameter(const PlanningCircumstances& with);

}  // namespace armcal
