// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ISO 10360-12:2016, probing size and form: 25 points on a sphere in two positions, near (20 to 45
/// % of the reach) and far (65 to 90 %), in directions from the base that differ as much as some
/// places allow. theory/verification_plan.md eq. (5). @throws ImpossiblePlan with the reason
[[nodiscard]] PlannedTest plan_probing(const PlanningCircumstances& with);

}  // namespace armcal
