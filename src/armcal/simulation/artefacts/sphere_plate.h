// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A plate that carries spheres in a square pattern, put down in some places (Furutani, Shimojima,
/// Takamasu 2004).
struct SpherePlate {
  std::string name = "plate";
  int rows = 3;
  int columns = 3;
  double pitch_mm = 120.0;
  int placements = 4;
  int postures = 2;  ///< on each sphere of each placement
  double u_mm = 0.005;
};

/// Kind artefact (features S1 .., row by row; placements NAME-1 ..). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const SpherePlate& plate);

}  // namespace armcal
