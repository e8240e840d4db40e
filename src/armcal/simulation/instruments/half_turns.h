// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// Half turns of single joints, the others locked, in postures at random; an instrument measures
/// the distance between the two places of the tip. The joint is turned until its encoder shows half
/// a turn more, so the reading before the turn says both.
struct HalfTurns {
  std::string name = "half-turns";
  int count = 40;
  std::vector<int> joints;  ///< one after the other, from 1; empty: all whose stops leave room, but
                            ///< for the last, whose half turns see little of the arm
  double u_mm = 0.005;      ///< of a distance
};

/// Kind reversal. @throws Impossible where a joint has no posture for a half turn
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const HalfTurns& half_turns);

/// Circles of the tip about single joints, in postures at random; an instrument measures their
/// radii.
struct CircleRadii {
  std::string name = "circles";
  int count = 40;
  std::vector<int> joints;  ///< one after the other, from 1; empty: all whose stops leave room
  double arc_rad = radians_from_degrees(120.0);  ///< half of it to each side of the posture
  double u_mm = 0.005;                           ///< of a radius
};

/// Kind circle_radius. @throws Impossible where a joint has no posture for such an arc
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const CircleRadii& circles);

}  // namespace armcal
