// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/planning/verification/sphere_pattern.h"
#include "armcal/planning/verification/touch_search.h"

namespace armcal {

/// One articulation: five points of a sphere with the stylus pointing one way.
struct Articulation {
  std::vector<Touch> touches;
  std::vector<Eigen::VectorXd> postures_rad;  ///< as `touches`
  Eigen::Vector3d stylus;                     ///< where it points, at the first point
  double elbow_mm = 0.0;                      ///< out of the plane through the tip; > 0: left
};

/// The stylus may turn by so much between the points of an articulation (15 deg).
inline constexpr double kSteadyCosine = 0.9659258262890683;

/// Articulations in which a sphere can be probed, of so many random starts.
/// @param pole  away from the sphere's stem; the stylus comes from its side
[[nodiscard]] std::vector<Articulation> articulations_at(const TouchSearch& search,
                                                         const SphereToProbe& sphere,
                                                         const Eigen::Vector3d& pole, int starts,
                                                         RandomStream& random);

/// `count` of the candidates: of the pairs with the elbow on either side the most different one
/// (without such a pair the first candidate), then each time the one farthest, in joint space, from
/// all chosen before. @param candidates  at least `count`, and this at least 2
[[nodiscard]] std::vector<Articulation> choose_articulations(std::vector<Articulation> candidates,
                                                             std::size_t count);

/// Distance, in joint space, of the two that are nearest to each other.
[[nodiscard]] double least_distance_rad(const std::vector<Articulation>& articulations);

}  // namespace armcal
