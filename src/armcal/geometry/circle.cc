// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/circle.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "armcal/geometry/curved_fit.h"
#include "armcal/geometry/rigid_transform.h"
#include "armcal/geometry/scatter.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/small_least_squares.h"

namespace armcal {
namespace {

// A circle in space: its apex, the unit vectors to its centre and along its axis, its curvature.
struct SpatialCircle {
  Eigen::Vector3d apex;
  Eigen::Vector3d inward;
  Eigen::Vector3d axis;
  double curvature = 0.0;

  static SpatialCircle unpack(const Eigen::VectorXd& x) {
    return {x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x(9)};
  }
  [[nodiscard]] Eigen::VectorXd pack() const {
    Eigen::VectorXd x(10);
    x << apex, inward, axis, curvature;
    return x;
  }
};

// Local coordinates: rotation of the circle about `inward`, `across` and `axis` through the apex,
// shift along `inward` and `axis`, curvature. theory/fits.md eq. (11)-(13).
constexpr Eigen::Index kUnknowns = 6;

Eigen::VectorXd moved_circle(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  SpatialCircle circle = SpatialCircle::unpack(x);
  const Eigen::Vector3d across = circle.inward.cross(circle.axis);
  const Eigen::Matrix3d turn =
      rotation_from_vector(step(0) * circle.inward + step(1) * across + step(2) * circle.axis);
  circle.apex += step(3) * circle.inward + step(4) * circle.axis;
  circle.inward = (turn * circle.inward).normalized();
  circle.axis = turn * circle.axis;
  circle.axis = (circle.axis - circle.inward * circle.inward.dot(circle.axis)).normalized();
  circle.curvature += step(5);
  return circle.pack();
}

// Rows: the radial residual of every point, then the axial one of every point.
void linearise(const Eigen::Matrix3Xd& points, const SpatialCircle& circle,
               Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) {
  const Eigen::Index count = points.cols();
  const Eigen::Vector3d across_axis = circle.inward.cross(circle.axis);
  residuals.resize(2 * count);
  jacobian.setZero(2 * count, kUnknowns);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d v = points.col(i) - circle.apex;
    const double along = v.dot(circle.inward);
    const double across = v.dot(across_axis);
    const double height = v.dot(circle.axis);
    const SurfaceDistance d =
        surface_distance(along * along + across * across, along, circle.curvature);
    residuals(i) = d.distance;
    residuals(count + i) = height;
    jacobian.row(i) << -2.0 * height * across * d.by_squared,
        height * (d.by_along + 2.0 * along * d.by_squared), -across * d.by_along,
        -2.0 * along * d.by_squared - d.by_along, 0.0, d.by_curvature;
    jacobian.row(count + i) << across, -along, 0.0, 0.0, -1.0, 0.0;
  }
}

// Derivatives of centre (3), axis (3) and radius by the local coordinates.
Eigen::MatrixXd derivatives_by_local(const SpatialCircle& circle) {
  const double radius = 1.0 / circle.curvature;
  const Eigen::Vector3d across = circle.inward.cross(circle.axis);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(7, kUnknowns);
  result.block<3, 1>(0, 1) = radius * circle.axis;
  result.block<3, 1>(0, 2) = -radius * across;
  result.block<3, 1>(0, 3) = circle.inward;
  result.block<3, 1>(0, 4) = circle.axis;
  result.block<3, 1>(0, 5) = -radius * radius * circle.inward;
  result.block<3, 1>(3, 0) = across;
  result.block<3, 1>(3, 1) = -circle.inward;
  result(6, 5) = -radius * radius;
  return result;
}

// The circle that best fits the points projected onto their least-squares plane.
SpatialCircle plane_first(const Scatter& scatter, const FitOptions& options, FitStatus& status) {
  const auto plane = scatter.directions.leftCols<2>();
  const CurvedFit flat =
      fit_curved(plane.transpose() * scatter.points_mm, scatter.resolution_mm, options);
  status = flat.status;
  if (status != FitStatus::converged) return {};
  return {plane * flat.apex, plane * flat.inward, scatter.directions.col(2), flat.curvature};
}

// All six unknowns together, from the plane-first circle; lengths in units of the extent.
SpatialCircle orthogonal(const Scatter& scatter, const SpatialCircle& start, int max_iterations,
                         FitStatus& status) {
  const double extent = scatter.extent_mm;
  const Eigen::Matrix3Xd points = scatter.points_mm / extent;
  SmallProblem problem;
  problem.residual_resolution =
      4.0 * std::max(scatter.resolution_mm / extent, std::numeric_limits<double>::epsilon());
  problem.move = moved_circle;
  problem.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    linearise(points, SpatialCircle::unpack(x), r, J);
  };
  const SpatialCircle scaled{start.apex / extent, start.inward, start.axis,
                             start.curvature * extent};
  const SmallSolution solution = solve_small_least_squares(problem, scaled.pack(), max_iterations);
  SpatialCircle circle = SpatialCircle::unpack(solution.x);
  if (!solution.ok()) {
    status = FitStatus::no_convergence;
  } else if (std::abs(circle.curvature) / 2.0 <= problem.residual_resolution) {
    status = FitStatus::radius_unbounded;
  }
  if (circle.curvature < 0.0) {
    circle.curvature = -circle.curvature;
    circle.inward = -circle.inward;
  }
  circle.apex *= extent;
  circle.curvature /= extent;
  return circle;
}

void summarise(CircleFit& fit) {
  fit.residuals_mm =
      (fit.radial_residuals_mm.array().square() + fit.axial_residuals_mm.array().square()).sqrt();
  fit.rms_mm = std::sqrt(fit.residuals_mm.squaredNorm() / static_cast<double>(fit.count));
  fit.form_mm = fit.radial_residuals_mm.maxCoeff() - fit.radial_residuals_mm.minCoeff();
}

// Covariance of the quantities whose derivatives by the local coordinates are `J_result_local`; a
// centre that stays free within it ends the fit.
void attach_covariance(CircleFit& fit, const Eigen::MatrixXd& J_residuals_local,
                       const Eigen::MatrixXd& J_result_local, Eigen::Index center_size,
                       const FitOptions& options) {
  const auto variance =
      residual_variance(fit.residuals_mm.squaredNorm(), fit.degrees_of_freedom, options);
  if (!variance) return;
  const auto factor = inverse_factor(J_residuals_local);
  if (!factor) {
    fit.status = FitStatus::radius_unbounded;
    return;
  }
  const Eigen::MatrixXd rows = J_result_local * *factor;
  fit.covariance = *variance * rows * rows.transpose();
  if (is_unbounded(fit.covariance->topLeftCorner(center_size, center_size), fit.radius_mm)) {
    fit.status = FitStatus::radius_unbounded;
  }
}

}  // namespace

CircleFit fit_circle(std::span<const Eigen::Vector3d> points, const CircleFitOptions& options) {
  CircleFit fit;
  fit.count = static_cast<Eigen::Index>(points.size());
  fit.degrees_of_freedom = 2 * fit.count - kUnknowns;
  if (const auto reason = reason_to_refuse(points, 3)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter scatter = scatter_of(points);
  if (const auto reason = reason_to_refuse(scatter, 2)) {
    fit.status = *reason;
    return fit;
  }
  SpatialCircle circle = plane_first(scatter, options, fit.status);
  if (fit.ok() && options.method == CircleMethod::orthogonal) {
    circle = orthogonal(scatter, circle, options.max_iterations, fit.status);
  }
  if (!fit.ok()) return fit;
  circle.axis = with_largest_component_positive(circle.axis);

  fit.radius_mm = 1.0 / circle.curvature;
  fit.center_mm = scatter.centroid_mm + circle.apex + fit.radius_mm * circle.inward;
  fit.normal = circle.axis;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  linearise(scatter.points_mm, circle, residuals, jacobian);
  fit.radial_residuals_mm = residuals.head(fit.count);
  fit.axial_residuals_mm = residuals.tail(fit.count);
  summarise(fit);
  fit.covariance_of = {"x", "y", "z", "normal_x", "normal_y", "normal_z", "radius"};
  attach_covariance(fit, jacobian, derivatives_by_local(circle), 3, options);
  return fit;
}

CircleFit fit_circle(std::span<const Eigen::Vector2d> points, const FitOptions& options) {
  CircleFit fit;
  fit.count = static_cast<Eigen::Index>(points.size());
  fit.degrees_of_freedom = fit.count - 3;
  std::vector<Eigen::Vector3d> in_space;
  in_space.reserve(points.size());
  for (const Eigen::Vector2d& p : points) in_space.emplace_back(p.x(), p.y(), 0.0);
  if (const auto reason = reason_to_refuse(in_space, 3)) {
    fit.status = *reason;
    return fit;
  }
  const Scatter scatter = scatter_of(in_space);
  if (const auto reason = reason_to_refuse(scatter, 2)) {
    fit.status = *reason;
    return fit;
  }
  const CurvedFit flat = fit_curved(scatter.points_mm.topRows<2>(), scatter.resolution_mm, options);
  fit.status = flat.status;
  if (!fit.ok()) return fit;
  fit.radius_mm = flat.radius_mm();
  fit.center_mm.head<2>() = scatter.centroid_mm.head<2>() + flat.center_mm();
  fit.radial_residuals_mm = flat.residuals_mm;
  fit.axial_residuals_mm = Eigen::VectorXd::Zero(fit.count);
  summarise(fit);
  fit.covariance_of = {"x", "y", "radius"};
  attach_covariance(fit, flat.J_residuals_local, flat.J_center_radius_local, 2, options);
  return fit;
}

}  // namespace armcal
