// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A device that realises calibrated positions along a straight line, set up in several directions
/// (Kovac and Klein 2002).
struct StraightLine {
  std::string name = "line";
  double length_mm = 800.0;
  int positions = 5;   ///< evenly along it
  int directions = 6;  ///< placements, each in another direction
  int postures = 2;    ///< at each position
  double u_mm = 0.005;
};

/// Kind artefact (features P1 ..; placements NAME-1 ..). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const StraightLine& line);

}  // namespace armcal
