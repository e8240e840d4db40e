// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A laser tracker that looks at a reflector on the tip from some metres away.
struct LaserTracker {
  std::string name = "tracker";
  int count = 60;
  double distance_mm = 3000.0;  ///< from the first axis of the arm
  double u_distance_mm = 0.005;
  double u_angle_rad = radians_from_arcseconds(1.0);  ///< of each of the two angles
};

/// Kind reference_points; u_mm of a row is the root of the mean of its three variances.
/// @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const LaserTracker& tracker);

}  // namespace armcal
