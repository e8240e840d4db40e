// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A flat surface (a surface plate), touched with a ball tip.
struct FlatSurface {
  std::string name = "plane";
  double size_mm = 400.0;
  int placements = 2;
  int points = 25;  ///< each placement
  double u_mm = 0.005;
};

/// Kind plane (planes NAME-1 ..). The probe pushes against the surface. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const FlatSurface& surface);

}  // namespace armcal
