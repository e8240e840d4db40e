// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/sphere.h"

#include <cmath>

#include "armcal/geometry/curved_fit.h"
#include "armcal/geometry/scatter.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {

SphereFit fit_sphere(std::span<const Eigen::Vector3d> points, const FitOptions& options) {
  SphereFit fit;
  fit.count = static_cast<Eigen::Index>(points.size());
  fit.degrees_of_freedom = fit.count - 4;
  if (const auto reason = reason_to_refuse(points, 4)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter scatter = scatter_of(points);
  if (const auto reason = reason_to_refuse(scatter, 3)) {
    fit.status = *reason;
    return fit;
  }
  const CurvedFit curved = fit_curved(scatter.points_mm, scatter.resolution_mm, options);
  fit.status = curved.status;
  if (!fit.ok()) return fit;

  fit.center_mm = scatter.centroid_mm + Eigen::Vector3d(curved.center_mm());
  fit.radius_mm = curved.radius_mm();
  fit.residuals_mm = curved.residuals_mm;
  fit.rms_mm = std::sqrt(fit.residuals_mm.squaredNorm() / static_cast<double>(fit.count));
  fit.form_mm = fit.residuals_mm.maxCoeff() - fit.residuals_mm.minCoeff();

  fit.covariance_of = {"x", "y", "z", "radius"};
  const auto variance =
      residual_variance(fit.residuals_mm.squaredNorm(), fit.degrees_of_freedom, options);
  if (!variance) return fit;
  const auto factor = inverse_factor(curved.J_residuals_local);
  if (!factor) {
    fit.status = FitStatus::radius_unbounded;
    return fit;
  }
  const Eigen::MatrixXd rows = curved.J_center_radius_local * *factor;
  fit.covariance = *variance * rows * rows.transpose();
  if (is_unbounded(fit.covariance->topLeftCorner<3, 3>(), fit.radius_mm)) {
    fit.status = FitStatus::radius_unbounded;
  }
  return fit;
}

}  // namespace armcal
