// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A laser tracker with a target of six degrees of freedom at the tip, turned on the last joint as
/// it was mounted.
struct PoseTracker {
  std::string name = "pose-tracker";
  int count = 60;
  double distance_mm = 3000.0;                     ///< from the first axis of the arm
  double u_mm = 0.015;                             ///< of each coordinate of the position
  double u_turn_rad = radians_from_degrees(0.01);  ///< of the turn about each axis
};

/// Kind reference_poses. `lever_mm` is the distance at which a turn weighs as much as a position:
/// u_mm over u_turn_rad, where both are given. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const PoseTracker& tracker);

}  // namespace armcal
