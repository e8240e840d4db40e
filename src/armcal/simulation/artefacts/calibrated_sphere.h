// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// The surface of a sphere of known diameter, touched from outside with a ball tip.
struct CalibratedSphere {
  std::string name = "sphere";
  double diameter_mm = 25.4;
  double tip_radius_mm = 3.0;
  int placements = 2;
  int points = 25;       ///< on the half of the sphere away from its stem, each placement
  double u_mm = 0.005;   ///< along the normal
  bool is_known = true;  ///< false: the diameter is left to the calibration
};

/// Kind sphere (spheres NAME-1 ..). The probe pushes against the surface. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const CalibratedSphere& sphere);

}  // namespace armcal
