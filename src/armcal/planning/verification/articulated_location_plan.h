// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/planning/verification/touch_plan.h"

namespace armcal {

/// ISO 10360-12:2016, articulated location: five points on one sphere in five articulations, elbow
/// left and right among them, otherwise as different as can be; within each the stylus points one
/// way. @throws ImpossiblePlan with the reason
[[nodiscard]] PlannedTest plan_articulated_location(const PlanningCircumstances& with);

}  // namespace armcal
