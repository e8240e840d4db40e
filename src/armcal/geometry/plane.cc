// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/plane.h"

#include <cmath>

#include "armcal/geometry/rigid_transform.h"
#include "armcal/geometry/scatter.h"

namespace armcal {

PlaneFit fit_plane(std::span<const Eigen::Vector3d> points, const FitOptions& options) {
  PlaneFit fit;
  fit.count = static_cast<Eigen::Index>(points.size());
  fit.degrees_of_freedom = fit.count - 3;
  if (const auto reason = reason_to_refuse(points, 3)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter scatter = scatter_of(points);
  if (const auto reason = reason_to_refuse(scatter, 2)) {
    fit.status = *reason;
    return fit;
  }
  fit.status = FitStatus::converged;
  fit.point_mm = scatter.centroid_mm;
  fit.normal = with_largest_component_positive(scatter.directions.col(2));
  fit.residuals_mm = scatter.points_mm.transpose() * fit.normal;
  fit.rms_mm = std::sqrt(fit.residuals_mm.squaredNorm() / static_cast<double>(fit.count));
  fit.form_mm = fit.residuals_mm.maxCoeff() - fit.residuals_mm.minCoeff();

  fit.covariance_of = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  const auto variance =
      residual_variance(fit.residuals_mm.squaredNorm(), fit.degrees_of_freedom, options);
  if (variance) {
    // About the centroid and along the principal directions, offset and both tilts are
    // uncorrelated.
    const Eigen::Vector3d wide = scatter.directions.col(0);
    const Eigen::Vector3d narrow = scatter.directions.col(1);
    const Eigen::Vector3d values = scatter.singular_values_mm;
    fit.covariance = Eigen::MatrixXd::Zero(6, 6);
    fit.covariance->topLeftCorner<3, 3>() =
        *variance / static_cast<double>(fit.count) * fit.normal * fit.normal.transpose();
    fit.covariance->bottomRightCorner<3, 3>() =
        *variance * (wide * wide.transpose() / (values(0) * values(0)) +
                     narrow * narrow.transpose() / (values(1) * values(1)));
  }
  return fit;
}

}  // namespace armcal
