// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <vector>

namespace armcal::testing {

// The smallest sphere about a few points, by trying every one: the judge of the one that is
// released. Textbook formulas for each number of points; nothing is shared.

inline double cover_radius(const Eigen::Vector3d& center,
                           const std::vector<Eigen::Vector3d>& points) {
  double radius = 0.0;
  for (const Eigen::Vector3d& point : points) radius = std::max(radius, (point - center).norm());
  return radius;
}

inline Eigen::Vector3d center_through(const std::vector<Eigen::Vector3d>& p) {
  if (p.size() == 1) return p[0];
  if (p.size() == 2) return 0.5 * (p[0] + p[1]);
  if (p.size() == 3) {
    const Eigen::Vector3d a = p[1] - p[0];
    const Eigen::Vector3d b = p[2] - p[0];
    const Eigen::Vector3d normal = a.cross(b);
    return p[0] + (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) /
                      (2.0 * normal.squaredNorm());
  }
  Eigen::Matrix3d edges;
  Eigen::Vector3d squares;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d edge = p[static_cast<std::size_t>(k + 1)] - p[0];
    edges.row(k) = 2.0 * edge.transpose();
    squares(k) = edge.squaredNorm();
  }
  return p[0] + edges.fullPivLu().solve(squares);
}

/// Every sphere through one to four of the points that contains all others: the smallest of them.
inline double radius_by_all_subsets(const std::vector<Eigen::Vector3d>& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < (1U << points.size()); ++subset) {
    std::vector<Eigen::Vector3d> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(points[i]);
    }
    if (chosen.size() > 4) continue;
    const Eigen::Vector3d center = center_through(chosen);
    if (!center.allFinite()) continue;
    const double radius = (chosen[0] - center).norm();
    const double slack = 1e-12 * (1.0 + radius);  // rounding of the centre
    if (cover_radius(center, points) <= radius + slack) smallest = std::min(smallest, radius);
  }
  return smallest;
}

}  // namespace armcal::testing
