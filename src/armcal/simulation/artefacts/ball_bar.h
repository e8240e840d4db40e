// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A bar with two spheres that a self-centring probe measures, in many placements.
struct BallBar {
  std::string name = "ball-bar";
  double length_mm = 500.0;
  int placements = 20;
  int postures = 2;  ///< on each sphere of each placement
  double u_mm = 0.005;
};

/// Kind artefact (features A, B; placements NAME-1 ..). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory, const BallBar& bar);

}  // namespace armcal
