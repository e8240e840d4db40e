// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/simulation/laboratory.h"
#include "armcal/simulation/placement.h"

namespace armcal {

/// Takes one reading with the tip on a feature of the base frame, in a posture that chance picks.
/// Where a surface is touched the arm stands on its free side and pushes against it, and the tip is
/// there with the push on.
/// @param what  names the feature in the message: "plate-2: S3"
/// @throws Impossible where no posture is found
[[nodiscard]] TakenReading take_on(Laboratory& laboratory, const Feature& feature,
                                   const std::string& what);

/// Is a point of the base frame so far from the shoulder that no posture gets there?
[[nodiscard]] bool is_beyond_reach(const VirtualArm& arm, const Eigen::Vector3d& point_mm);

/// Is the feature reached in more ways than one, as far as some dozen tries tell?
[[nodiscard]] bool is_within_reach(Laboratory& laboratory, const Feature& feature);

/// Takes `count` readings in different postures, one per column, with the tip in a seat that holds
/// it at the feature, but for its repeatability (each coordinate).
/// @throws Impossible where so many postures are not found
[[nodiscard]] Eigen::MatrixXd take_in_seat(Laboratory& laboratory, const Feature& seat,
                                           const std::string& what, int count, double u_mm);

}  // namespace armcal
