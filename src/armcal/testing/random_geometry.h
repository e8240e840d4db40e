// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "armcal/core/random.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal::testing {

inline Eigen::Vector3d random_normal_vector(RandomStream& random, double sigma = 1.0) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

inline Eigen::Vector3d random_direction(RandomStream& random) {
  return random_normal_vector(random).normalized();
}

inline RigidTransform random_transform(RandomStream& random, double size_mm) {
  return {rotation_from_vector(random.uniform(0.0, 3.1) * random_direction(random)),
          size_mm * random_normal_vector(random)};
}

inline std::vector<Eigen::Vector3d> with_noise(std::vector<Eigen::Vector3d> points, double sigma_mm,
                                               RandomStream& random) {
  for (Eigen::Vector3d& p : points) p += random_normal_vector(random, sigma_mm);
  return points;
}

/// What the largest coordinate loses where it is rounded to a double.
inline double rounding_of(const std::vector<Eigen::Vector3d>& points) {
  double largest = 0.0;
  for (const Eigen::Vector3d& p : points) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  return std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace armcal::testing
