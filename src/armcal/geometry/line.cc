// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/line.h"

#include <cmath>

#include "armcal/geometry/rigid_transform.h"
#include "armcal/geometry/scatter.h"

namespace armcal {

LineFit fit_line(std::span<const Eigen::Vector3d> points, const FitOptions& options) {
  LineFit fit;
  fit.count = static_cast<Eigen::Index>(points.size());
  fit.degrees_of_freedom = 2 * fit.count - 4;
  if (const auto reason = reason_to_refuse(points, 2)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter scatter = scatter_of(points);
  if (const auto reason = reason_to_refuse(scatter, 1)) {
    fit.status = *reason;
    return fit;
  }
  fit.status = FitStatus::converged;
  fit.point_mm = scatter.centroid_mm;
  fit.direction = with_largest_component_positive(scatter.directions.col(0));

  const auto [first, second] = perpendicular_pair(fit.direction);
  const Eigen::VectorXd along = scatter.points_mm.transpose() * fit.direction;
  const Eigen::VectorXd across = scatter.points_mm.transpose() * first;
  const Eigen::VectorXd sideways = scatter.points_mm.transpose() * second;
  fit.residuals_mm = (across.array().square() + sideways.array().square()).sqrt();
  fit.rms_mm = std::sqrt(fit.residuals_mm.squaredNorm() / static_cast<double>(fit.count));
  fit.form_mm = 2.0 * fit.residuals_mm.maxCoeff();

  fit.covariance_of = {"x", "y", "z", "direction_x", "direction_y", "direction_z"};
  const auto variance =
      residual_variance(fit.residuals_mm.squaredNorm(), fit.degrees_of_freedom, options);
  if (variance) {
    // Two perpendicular straight-line fits with the same design: offset and slope against `along`.
    const double u2_offset = *variance / static_cast<double>(fit.count);
    const double u2_slope = *variance / along.squaredNorm();
    const Eigen::Matrix3d transverse = first * first.transpose() + second * second.transpose();
    fit.covariance = Eigen::MatrixXd::Zero(6, 6);
    fit.covariance->topLeftCorner<3, 3>() = u2_offset * transverse;
    fit.covariance->bottomRightCorner<3, 3>() = u2_slope * transverse;
  }
  return fit;
}

}  // namespace armcal
