// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

struct PlaneFit : FitSummary {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< the centroid, in the plane
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< unit; its largest component is positive
};

/// Least-squares plane (orthogonal distances).
///
/// Method: theory/fits.md eq. (2), by singular values of the centred points. Accuracy: NIST L2
/// reference planes to 1e-9 mm and 1e-10. Residuals are positive on the side of the normal; form_mm
/// is the flatness, largest minus smallest residual. covariance_of: x y z of the point, then of the
/// normal.
/// @param points  at least 3, not collinear (status `points_are_collinear` otherwise), mm
[[nodiscard]] PlaneFit fit_plane(std::span<const Eigen::Vector3d> points,
                                 const FitOptions& options = {});

}  // namespace armcal
