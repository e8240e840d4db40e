// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace armcal::testing {

/// Points spread evenly over a sphere, in a spiral from its top (z) to `lowest` radii above its
/// centre: -1 for the whole sphere, 0 for the upper half.
inline std::vector<Eigen::Vector3d> points_on_sphere(const Eigen::Vector3d& center, double diameter,
                                                     int count, double lowest = -1.0) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (1.0 - lowest) * (i + 0.5) / count;
    const double ring = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d direction(ring * std::cos(golden_angle * i),
                                    ring * std::sin(golden_angle * i), z);
    points.push_back(center + 0.5 * diameter * direction);
  }
  return points;
}

}  // namespace armcal::testing
