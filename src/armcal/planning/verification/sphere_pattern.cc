// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/sphere_pattern.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "armcal/core/units.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {
namespace {

struct Ring {
  double from_pole_deg;
  int count;
  double turn_deg;
};

std::vector<Eigen::Vector3d> pattern(const Eigen::Vector3d& pole,
                                     std::initializer_list<Ring> rings) {
  const auto [first, second] = perpendicular_pair(pole);
  std::vector<Eigen::Vector3d> directions = {pole};
  for (const Ring& ring : rings) {
    const double polar = radians_from_degrees(ring.from_pole_deg);
    for (int i = 0; i < ring.count; ++i) {
      const double turn =
          radians_from_degrees(ring.turn_deg) + 2.0 * std::numbers::pi * i / ring.count;
      const Eigen::Vector3d across = std::cos(turn) * first + std::sin(turn) * second;
      directions.emplace_back(std::cos(polar) * pole + std::sin(polar) * across);
    }
  }
  return directions;
}

}  // namespace

std::vector<Eigen::Vector3d> pattern_of_25(const Eigen::Vector3d& pole) {
  return pattern(pole, {{22.5, 4, 0.0}, {45.0, 8, 22.5}, {67.5, 4, 45.0}, {90.0, 8, 67.5}});
}

std::vector<Eigen::Vector3d> pattern_of_9(const Eigen::Vector3d& pole) {
  return pattern(pole, {{45.0, 4, 0.0}, {90.0, 4, 45.0}});
}

std::vector<Eigen::Vector3d> pattern_of_5(const Eigen::Vector3d& pole) {
  return pattern(pole, {{60.0, 4, 0.0}});
}

}  // namespace armcal
