// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace armcal {

struct EnclosingSphere {
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0.0;
  /// Indices of the one to four points that hold it: it is also the smallest sphere about them.
  std::vector<int> support;
};

/// The smallest sphere that contains all points.
///
/// Exact but for rounding: of the same optimisation problem in at most four points the solution is
/// found by trying every subset; the point farthest outside then joins and the search is repeated
/// (each step enlarges the sphere, so it ends). Any points will do: one, equal, on a line, in a
/// plane, thousands. Accuracy: 1e-9 mm against all subsets of up to four points.
/// @throws std::invalid_argument without points, or where a coordinate is not finite
[[nodiscard]] EnclosingSphere smallest_enclosing_sphere(std::span<const Eigen::Vector3d> points_mm);

}  // namespace armcal
