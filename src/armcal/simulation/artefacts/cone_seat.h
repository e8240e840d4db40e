// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// One cone or kinematic seat that holds the centre of the probe, in many postures.
struct ConeSeat {
  std::string name = "cone";
  int seats = 1;        ///< equal cones at different places, nothing known of their distances
  int postures = 60;    ///< in each
  double u_mm = 0.005;  ///< repeatability of the seat, each coordinate
};

/// Kind fixed_point (points NAME-1 ..). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory, const ConeSeat& cone);

}  // namespace armcal
