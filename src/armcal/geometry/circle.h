// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

struct CircleFit : FitSummary {
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit; its largest component is positive
  double radius_mm = 0.0;
  Eigen::VectorXd radial_residuals_mm;  ///< in the plane of the circle, positive outside
  Eigen::VectorXd axial_residuals_mm;   ///< out of that plane, positive on the side of the normal
};

enum class CircleMethod {
  orthogonal,   ///< plane, centre and radius together: least sum of squared distances to the circle
  plane_first,  ///< the least-squares plane, then the circle of the points projected onto it (NIST,
                ///< ASME B89.4.10); the usual answer of measuring software
};

struct CircleFitOptions : FitOptions {
  CircleMethod method = CircleMethod::orthogonal;
};

/// Least-squares circle through points in space.
///
/// Method: theory/fits.md eq. (5)-(9), (11)-(13). Accuracy: NIST L2 reference circles
/// (`plane_first`) to 1e-9 mm; arcs of 1 deg and centres 1e6 mm away to what the rounding of the
/// coordinates allows. residuals_mm are distances to the circle in space; form_mm is the roundness,
/// largest minus smallest radial residual. covariance_of: x y z of the centre, x y z of the normal,
/// radius.
/// @param points  at least 3, not collinear (status `points_are_collinear` otherwise), mm
[[nodiscard]] CircleFit fit_circle(std::span<const Eigen::Vector3d> points,
                                   const CircleFitOptions& options = {});

/// The same in the plane: centre (x, y, 0), normal (0, 0, 1), axial residuals 0.
/// covariance_of: x y of the centre, radius.
[[nodiscard]] CircleFit fit_circle(std::span<const Eigen::Vector2d> points,
                                   const FitOptions& options = {});

}  // namespace armcal
