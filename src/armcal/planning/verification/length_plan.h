// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ISO 10360-12:2016, unidirectional lengths: five from one end of a gauge, three times, in seven
/// positions: along the axes of the base frame and its four diagonals, apart from each other.
/// @throws ImpossiblePlan with the reason for every direction that has no place
[[nodiscard]] PlannedTest plan_length_uni(const PlanningCircumstances& with);

/// The lengths that are taken where none are wished: fifths of the shortest round length of at
/// least 66 % of the reach, mm.
[[nodiscard]] std::vector<double> usual_lengths(double reach_mm);

}  // namespace armcal
