// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/random.h"
#include "armcal/planning/verification/sphere_pattern.h"
#include "armcal/planning/verification/touch_search.h"
#include "armcal/planning/verification_plan.h"

namespace armcal {

/// What every test is planned with.
struct PlanningCircumstances {
  const TouchSearch& search;
  const VerificationPlanWishes& wishes;  ///< defaults filled in
  double reach_mm = 0.0;

  /// Part of the reach that a point is away from the origin of the first joint.
  [[nodiscard]] double share_of_reach(const Eigen::Vector3d& point_mm) const {
    return (point_mm - search.origin_mm()).norm() / reach_mm;
  }
  /// A sphere as wished, nowhere yet.
  [[nodiscard]] SphereToProbe sphere_at(const Eigen::Vector3d& centre_mm) const {
    return {centre_mm, 0.5 * wishes.sphere_diameter_mm, 0.5 * wishes.tip_diameter_mm};
  }
};

/// Adds a row with a posture for its touch that differs as much as some candidates allow from those
/// of all rows before it. @throws ImpossiblePlan where no posture is found
void add_touch(const TouchSearch& search, PlannedTest& test, PlannedTouch row,
               RandomStream& random);

/// "480 mm (33 % of the reach)"
[[nodiscard]] std::string distance_text(const PlanningCircumstances& with,
                                        const Eigen::Vector3d& point_mm);

}  // namespace armcal
