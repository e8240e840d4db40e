// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/registration.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

#include "armcal/geometry/scatter.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

std::optional<FitStatus> reason_to_refuse_pairs(std::span<const Eigen::Vector3d> source,
                                                std::span<const Eigen::Vector3d> target) {
  if (const auto reason = reason_to_refuse(source, 3)) return reason;
  return reason_to_refuse(target, 3);
}

void attach_covariance(Registration& fit, std::span<const Eigen::Vector3d> source,
                       const RegistrationOptions& options) {
  const Eigen::Index unknowns = options.estimate_scale ? 7 : 6;
  fit.covariance_of = {"rotation_x", "rotation_y", "rotation_z", "x", "y", "z"};
  if (options.estimate_scale) fit.covariance_of.emplace_back("scale");
  const auto variance =
      residual_variance(fit.residuals_mm.squaredNorm(), fit.degrees_of_freedom, options);
  if (!variance) return;
  Eigen::MatrixXd jacobian(3 * fit.count, unknowns);
  for (Eigen::Index i = 0; i < fit.count; ++i) {
    const Eigen::Vector3d turned =
        fit.target_from_source.rotation * source[static_cast<std::size_t>(i)];
    jacobian.block<3, 3>(3 * i, 0) = -skew(fit.scale * turned);
    jacobian.block<3, 3>(3 * i, 3).setIdentity();
    if (options.estimate_scale) jacobian.block<3, 1>(3 * i, 6) = turned;
  }
  if (const auto factor = inverse_factor(jacobian)) {
    fit.covariance = *variance * *factor * factor->transpose();
  }
}

// Of u * v^T: 1 for a rotation, -1 for a reflection.
double handedness(const SingularValueDecomposition& svd) {
  return (svd.u * svd.v.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
}

// Sums of squares with the best rotation and with the best reflection, each with its best scale.
bool mirror_fits_better(const Scatter& from, const Scatter& onto, const Eigen::VectorXd& values) {
  const auto left_over = [&](double sign) {
    const double gain = values(0) + values(1) + sign * values(2);
    return onto.points_mm.squaredNorm() - gain * gain / from.points_mm.squaredNorm();
  };
  // Points of one plane have no handedness: theirs is rounding.
  return values(2) > 1e-9 * values(0) && left_over(1.0) < 0.01 * left_over(-1.0);
}

}  // namespace

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const auto svd = singular_value_decomposition(matrix);
  return svd.u * Eigen::Vector3d(1.0, 1.0, handedness(svd)).asDiagonal() * svd.v.transpose();
}

Registration register_points(std::span<const Eigen::Vector3d> source,
                             std::span<const Eigen::Vector3d> target,
                             const RegistrationOptions& options) {
  if (source.size() != target.size()) {
    throw std::invalid_argument("register_points: " + std::to_string(source.size()) +
                                " source points but " + std::to_string(target.size()) +
                                " target points");
  }
  Registration fit;
  fit.count = static_cast<Eigen::Index>(source.size());
  fit.degrees_of_freedom = 3 * fit.count - (options.estimate_scale ? 7 : 6);
  if (const auto reason = reason_to_refuse_pairs(source, target)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter from = scatter_of(source);
  const Scatter onto = scatter_of(target);
  for (const Scatter* scatter : {&from, &onto}) {
    if (const auto reason = reason_to_refuse(*scatter, 2)) {
      fit.status = *reason;
      return fit;
    }
  }
  const auto svd = singular_value_decomposition(onto.points_mm * from.points_mm.transpose());
  const double sign = handedness(svd);
  const Eigen::Vector3d signs(1.0, 1.0, sign);
  fit.looks_mirrored = sign < 0.0 && mirror_fits_better(from, onto, svd.values);
  // Rotations about the third direction cost the sum of the two smaller values (the third with its
  // sign): where that vanishes the rotation is free.
  if (svd.values(1) + sign * svd.values(2) <= 1e-12 * svd.values(0)) {
    fit.status = FitStatus::ambiguous;
    return fit;
  }
  fit.status = FitStatus::converged;
  RigidTransform& transform = fit.target_from_source;
  transform.rotation = svd.u * signs.asDiagonal() * svd.v.transpose();
  if (options.estimate_scale) {
    fit.scale = svd.values.dot(signs) / from.points_mm.squaredNorm();
  }
  transform.translation_mm = onto.centroid_mm - fit.scale * (transform.rotation * from.centroid_mm);

  fit.residual_vectors_mm = onto.points_mm - fit.scale * transform.rotation * from.points_mm;
  fit.residuals_mm = fit.residual_vectors_mm.colwise().norm();
  fit.rms_mm = std::sqrt(fit.residuals_mm.squaredNorm() / static_cast<double>(fit.count));
  fit.form_mm = fit.residuals_mm.maxCoeff();
  attach_covariance(fit, source, options);
  return fit;
}

}  // namespace armcal
