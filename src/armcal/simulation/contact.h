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

/// Is the feature reached in more ways than one, as far as some dozen tries tell?
[[nodiscard]] bool is_within_reach(Laboratory& laboratory, const Feature& feature);

/// Takes `count` readings with the tip in a seat that holds it at the feature, but for its
/// repeatability, and puts them into the columns first .. of the group.
void take_in_seat(Laboratory& laboratory, const Feature& seat, const std::string& what, int count,
                  double u_mm, ObservationGroup& group, Eigen::Index first);

}  // namespace armcal
