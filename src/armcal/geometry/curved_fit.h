// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

// What circle and sphere fits share. Both are described by a point of the surface (the apex), the
// unit vector from there to the centre, and the curvature 1/radius. Unlike centre and radius these
// stay finite and well conditioned when a cap or arc is nearly flat: theory/fits.md eq. (5)-(9).

/// Signed distance of a point from the surface, and its derivatives, as functions of
///   squared = |v|^2 and along = v . inward,  v = point - apex, and of the curvature.
/// Free of cancellation from a full sphere down to curvature 0, where the surface is a plane.
struct SurfaceDistance {
  double distance = 0.0;
  double by_squared = 0.0;
  double by_along = 0.0;
  double by_curvature = 0.0;
};
[[nodiscard]] SurfaceDistance surface_distance(double squared, double along, double curvature);

/// Least-squares circle (points with 2 rows) or sphere (3 rows), orthogonal distances.
struct CurvedFit {
  FitStatus status = FitStatus::no_convergence;
  Eigen::VectorXd apex;
  Eigen::VectorXd inward;  ///< unit, from the apex to the centre
  double curvature = 0.0;  ///< 1/mm, not negative
  Eigen::VectorXd residuals_mm;
  /// Derivatives of the residuals by the local parameters (mm, mm/mm, ..), and of centre and radius
  /// by the same: the covariance of (centre, radius) is variance * T (J^T J)^-1 T^T.
  Eigen::MatrixXd J_residuals_local;
  Eigen::MatrixXd J_center_radius_local;

  [[nodiscard]] Eigen::VectorXd center_mm() const { return apex + inward / curvature; }
  [[nodiscard]] double radius_mm() const { return 1.0 / curvature; }
};

/// @param points_mm  2 or 3 rows, one column per point, measured from (about) their centroid; of
/// full
///                   dimension and at least rows + 1 of them
/// @param resolution_mm  rounding of the coordinates
/// @return status `radius_unbounded` where the points show no curvature beyond their scatter,
/// theory/fits.md
///         eq. (10)
[[nodiscard]] CurvedFit fit_curved(const Eigen::MatrixXd& points_mm, double resolution_mm,
                                   const FitOptions& options);

/// True where the covariance of (centre.., radius) says that the points leave the centre free: its
/// standard uncertainty in some direction exceeds half the radius, so that the 95 % interval of the
/// curvature includes zero, the straight line or plane.
[[nodiscard]] bool is_unbounded(const Eigen::MatrixXd& covariance_center, double radius_mm);

}  // namespace armcal
