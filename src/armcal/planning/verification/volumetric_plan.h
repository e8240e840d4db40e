// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ASME B89.4.22, volumetric length: twenty placements of two bars, ten each, that differ from each
/// other in place and direction as much as some dozen random ones allow.
/// theory/verification_plan.md eq. (6). @throws ImpossiblePlan with the reason
[[nodiscard]] PlannedTest plan_volumetric_length(const PlanningCircumstances& with);

/// The bars that are taken where none are wished: round lengths of about 60 and 120 % of the reach,
/// mm.
[[nodiscard]] std::array<double, 2> usual_bars(double reach_mm);

}  // namespace armcal
