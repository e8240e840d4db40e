// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A reference machine that follows the tip while one joint after the other turns alone, the rest
/// locked at home: what circle-point analysis needs (identification/circle_points.h). Of some
/// hundred free postures that one is home whose worst joint has the largest arc.
struct JointArcs {
  std::string name = "arcs";
  int points = 10;                                ///< on the arc of each joint, evenly spaced
  double span_rad = radians_from_degrees(270.0);  ///< of an arc, less where something is in the way
  double u_mm = 0.003;                            ///< standard uncertainty of each coordinate
};

/// Kind reference_points, `joint` the one that turns. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory, const JointArcs& arcs);

}  // namespace armcal
