// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

struct SphereFit : FitSummary {
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0.0;
};

/// Least-squares sphere (orthogonal distances).
///
/// Method: theory/fits.md eq. (5)-(10). Accuracy: NIST L2 reference spheres to 1e-9 mm; caps of 1
/// deg and centres 1e6 mm away to what the rounding of the coordinates allows. Residuals are
/// positive outside; form_mm is largest minus smallest distance from the centre. covariance_of: x y
/// z of the centre, radius.
/// @param points  at least 4, not coplanar (status `points_are_coplanar` otherwise), mm
[[nodiscard]] SphereFit fit_sphere(std::span<const Eigen::Vector3d> points,
                                   const FitOptions& options = {});

}  // namespace armcal
