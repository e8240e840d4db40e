// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {

/// What stands around an arm, kept simple: its own column and the bench that it is bolted to.
/// Heights are along the first axis, from the origin of the first joint (the shoulder).
struct Surroundings {
  double column_radius_mm = 0.0;   ///< cylinder about the first axis; 0: none
  double column_top_mm = 0.0;      ///< it reaches from the bench to here
  std::optional<double> bench_mm;  ///< height of the bench; usually negative
};

/// What a posture runs into, in words: "the tip is 12.3 mm below the bench", "joint 4 is inside the
/// column"; nothing where it is free. Looks at the links beyond the elbow (from joint 3 on) as
/// straight lines from origin to origin, and at the tip.
[[nodiscard]] std::optional<std::string> collision(const ForwardKinematics& kinematics,
                                                   std::span<const double> encoder_rad,
                                                   const Surroundings& surroundings);

/// Which joint limit a posture breaks, in words: "joint 2 at 95.0 deg is beyond its limit of 90
/// deg"; nothing where it keeps to all.
[[nodiscard]] std::optional<std::string> broken_limit(const ArmModel& arm,
                                                      std::span<const double> encoder_rad);

}  // namespace armcal
