// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

struct LineFit : FitSummary {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< the centroid, on the line
  Eigen::Vector3d direction =
      Eigen::Vector3d::UnitX();  ///< unit; its largest component is positive
};

/// Least-squares line through points in space (orthogonal distances).
///
/// Method: theory/fits.md eq. (3), by singular values of the centred points. Accuracy: NIST L2
/// reference lines to 1e-9 mm and 1e-11. form_mm is the diameter of the smallest cylinder about the
/// fitted line that holds all points. covariance_of: x y z of the point, then of the direction.
/// @param points  at least 2, not coincident (status `points_coincide` otherwise), mm
[[nodiscard]] LineFit fit_line(std::span<const Eigen::Vector3d> points,
                               const FitOptions& options = {});

}  // namespace armcal
