// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {

/// What stands around an arm, kept simple: its own column and the bench that it is bolted to.
/// Heights are along the first axis, from the origin of the first joint.
struct Surroundings {
  double column_radius_mm = 0.0;   ///< cylinder about the first axis; 0: none
  double column_top_mm = 0.0;      ///< it reaches from the bench to here
  std::optional<double> bench_mm;  ///< height of the bench; usually negative
};

/// What a posture runs into, in words: "the tip is 12.3 mm below the bench", "the link from joint 4
/// to joint 5 passes 8.1 mm from the first axis, inside the column of radius 60.0 mm"; nothing
/// where it is free.
///
/// Links are straight lines from origin to origin. Looked at are the elbow, all joints and links
/// beyond it, and the tip; the elbow is the first joint that is more than a quarter of the whole
/// way to the tip away from the second joint, along the links. What is before it (a shoulder of
/// several joints, the upper arm) begins at the column and would always run into it.
[[nodiscard]] std::optional<std::string> collision(const ForwardKinematics& kinematics,
                                                   std::span<const double> encoder_rad,
                                                   const Surroundings& surroundings);

/// Which joint limit a posture breaks, in words: "joint 2 at 95.0 deg is beyond its limit of 90.0
/// deg"; nothing where it keeps to all. A reading that is not a number breaks every limit.
[[nodiscard]] std::optional<std::string> broken_limit(const ArmModel& arm,
                                                      std::span<const double> encoder_rad);

}  // namespace armcal
