// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/curved_fit.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/small_least_squares.h"

namespace armcal {
namespace {

// The unknowns as one vector: apex (N), inward (N), curvature; N the dimension. All in units of the
// extent.
struct Surface {
  Eigen::VectorXd apex;
  Eigen::VectorXd inward;
  double curvature = 0.0;

  static Surface unpack(const Eigen::VectorXd& x) {
    const Eigen::Index n = (x.size() - 1) / 2;
    return {x.head(n), x.segment(n, n), x(2 * n)};
  }
  [[nodiscard]] Eigen::VectorXd pack() const {
    Eigen::VectorXd x(2 * apex.size() + 1);
    x << apex, inward, curvature;
    return x;
  }
};

// Unit vectors perpendicular to `inward`, one per column.
Eigen::MatrixXd tangents(const Eigen::VectorXd& inward) {
  const Eigen::Index n = inward.size();
  if (n == 2) return Eigen::Vector2d(-inward(1), inward(0));
  const Eigen::Vector3d axis = inward;
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  Eigen::Matrix<double, 3, 2> pair;
  pair.col(0) = axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
  pair.col(1) = axis.cross(pair.col(0));
  return pair;
}

// Algebraic start: Taubin's fit (IEEE PAMI 13 (1991) 1115-1138) by singular values (Chernov,
// Circular and linear regression, 2010, sec. 5.10), in any dimension. Unbiased enough for small
// arcs, exact for exact data.
Surface algebraic_start(const Eigen::MatrixXd& points) {
  const Eigen::Index n = points.rows();
  const Eigen::VectorXd squared = points.colwise().squaredNorm();
  const double mean = squared.mean();
  Eigen::MatrixXd design(points.cols(), n + 1);
  design.col(0) = (squared.array() - mean) / (2.0 * std::sqrt(mean));
  design.rightCols(n) = points.transpose();
  const auto svd = singular_value_decomposition(design);
  const Eigen::VectorXd solution = svd.v.col(svd.v.cols() - 1);
  // a |p|^2 + b.p + c = 0, scaled to |b|^2 - 4 a c = 1.
  double a = solution(0) / (2.0 * std::sqrt(mean));
  Eigen::VectorXd b = solution.tail(n);
  double c = -mean * a;
  const double scale = std::sqrt(b.squaredNorm() - 4.0 * a * c);
  a /= scale;
  b /= scale;
  c /= scale;

  Surface surface;
  surface.curvature = 2.0 * a;
  const double gradient = b.norm();
  surface.inward = gradient > 0.0 ? Eigen::VectorXd(-b / gradient) : Eigen::VectorXd::Unit(n, 0);
  // Where the centre is the mean itself every point of the surface is as good an apex as any other.
  const double distance = 2.0 * c / (1.0 + std::sqrt(std::max(0.0, 1.0 + 4.0 * a * c)));
  surface.apex = distance * surface.inward;
  return surface;
}

// The same surface described from its point nearest to the origin (the centroid of the points): a
// long iteration can have carried the apex away from the points, which costs digits.
Surface with_nearest_apex(const Surface& surface) {
  const Eigen::VectorXd v = -surface.apex;
  const Eigen::VectorXd outward = surface.curvature * v - surface.inward;
  const double length = outward.norm();
  if (length < 0.5)
    return surface;  // the origin is near the centre: no nearest point worth the name
  const double along = v.dot(surface.inward);
  const double distance = (surface.curvature * v.squaredNorm() - 2.0 * along) / (1.0 + length);
  return {-distance * outward / length, -outward / length, surface.curvature};
}

struct Linearisation {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd
      jacobian;  // columns: tilts of inward about the apex, shift along inward, curvature
};

Linearisation linearise(const Eigen::MatrixXd& points, const Surface& surface) {
  const Eigen::Index n = points.rows();
  const Eigen::MatrixXd basis = tangents(surface.inward);
  Linearisation at{Eigen::VectorXd(points.cols()), Eigen::MatrixXd(points.cols(), n + 1)};
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::VectorXd v = points.col(i) - surface.apex;
    const double along = v.dot(surface.inward);
    const SurfaceDistance d = surface_distance(v.squaredNorm(), along, surface.curvature);
    at.residuals(i) = d.distance;
    at.jacobian.row(i).head(n - 1) = d.by_along * (basis.transpose() * v).transpose();
    at.jacobian(i, n - 1) = -2.0 * d.by_squared * along - d.by_along;
    at.jacobian(i, n) = d.by_curvature;
  }
  return at;
}

// Do the points show no curvature beyond their scatter? They do not when (a) they are not clearly
// thicker than the residuals of the curved fit, and (b) their heights over the best flat do not
// follow the square of their distance within it (Student's t below 2). Only both together: a full
// sphere fails (b), a flat cap (a). Points on a ring in a plane are the trap that this closes: any
// sphere through the ring fits them, and the covariance at the one that was found looks harmless.
bool is_flat_within_scatter(const Eigen::MatrixXd& points, double sum_of_squares,
                            const std::optional<double>& u_point) {
  const Eigen::Index n = points.rows();
  const Eigen::Index degrees_of_freedom = points.cols() - n - 1;
  if (degrees_of_freedom < 1 && !u_point) return false;
  const auto svd = singular_value_decomposition(points.transpose());
  const Eigen::VectorXd heights = svd.u.col(n - 1) * svd.values(n - 1);
  constexpr double kClearlyThicker = 10.0;  // in squares: three times the scatter
  if (heights.squaredNorm() > kClearlyThicker * sum_of_squares &&
      (!u_point || heights.squaredNorm() > kClearlyThicker * static_cast<double>(points.cols()) *
                                               *u_point * *u_point)) {
    return false;
  }
  // What is left of the squared distances within the flat beside a constant and a slope.
  const Eigen::MatrixXd within = svd.u.leftCols(n - 1);
  Eigen::VectorXd bow = (within * svd.values.head(n - 1).asDiagonal()).rowwise().squaredNorm();
  bow.array() -= bow.mean();
  bow -= within * (within.transpose() * bow);
  const double length = bow.norm();
  if (!(length > 0.0)) return true;
  const double curvature_part = bow.dot(heights) / length;
  const double rest = heights.squaredNorm() - curvature_part * curvature_part;
  const double u =
      u_point ? *u_point : std::sqrt(std::max(0.0, rest) / static_cast<double>(degrees_of_freedom));
  return std::abs(curvature_part) < 2.0 * u;
}

Eigen::VectorXd moved_surface(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  Surface surface = Surface::unpack(x);
  const Eigen::Index n = surface.apex.size();
  surface.apex += step(n - 1) * surface.inward;
  surface.inward = (surface.inward + tangents(surface.inward) * step.head(n - 1)).normalized();
  surface.curvature += step(n);
  return surface.pack();
}

}  // namespace

SurfaceDistance surface_distance(double squared, double along, double curvature) {
  // Distance from the centre in units of the radius; 0 at the centre, where no direction is
  // nearest.
  const double ratio =
      std::sqrt(std::max(0.0, 1.0 - 2.0 * curvature * along + curvature * curvature * squared));
  SurfaceDistance d;
  d.distance = (curvature * squared - 2.0 * along) / (1.0 + ratio);
  if (ratio == 0.0) return d;
  d.by_squared = curvature / (2.0 * ratio);
  d.by_along = -1.0 / ratio;
  // (1 + cos)/curvature^2 with cos = cosine between outward normal and inward axis; on the near
  // side the two terms cancel, so that side uses the form multiplied out.
  const double near_side = 1.0 - curvature * along;
  d.by_curvature = near_side > 0.0 ? (squared - along * along) / (ratio * (ratio + near_side))
                                   : (ratio - near_side) / (ratio * curvature * curvature);
  return d;
}

CurvedFit fit_curved(const Eigen::MatrixXd& points_mm, double resolution_mm,
                     const FitOptions& options) {
  const Eigen::Index n = points_mm.rows();
  ARMCAL_INVARIANT((n == 2 || n == 3) && points_mm.cols() > n);
  const double extent = std::sqrt(points_mm.colwise().squaredNorm().maxCoeff());
  const Eigen::MatrixXd points = points_mm / extent;

  SmallProblem problem;
  problem.residual_resolution =
      4.0 * std::max(resolution_mm / extent, std::numeric_limits<double>::epsilon());
  problem.move = moved_surface;
  problem.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                         Eigen::MatrixXd& jacobian) {
    Linearisation at = linearise(points, Surface::unpack(x));
    residuals = std::move(at.residuals);
    jacobian = std::move(at.jacobian);
  };

  CurvedFit fit;
  SmallSolution solution;
  solution.x = algebraic_start(points).pack();
  for (int round = 0; round < 2; ++round) {
    const Surface start = with_nearest_apex(Surface::unpack(solution.x));
    solution = solve_small_least_squares(problem, start.pack(), options.max_iterations);
    if (!solution.ok()) break;
  }
  const std::optional<double> u_point =
      options.u_point_mm ? std::optional(*options.u_point_mm / extent) : std::nullopt;
  // Where no radius is better than another, the iteration may also wander without end.
  const double sum_of_squares = solution.residuals.squaredNorm();
  if (is_flat_within_scatter(points, sum_of_squares, u_point)) {
    fit.status = FitStatus::radius_unbounded;
    return fit;
  }
  if (!solution.ok()) {
    fit.status = FitStatus::no_convergence;
    return fit;
  }
  Surface surface = Surface::unpack(solution.x);
  if (surface.curvature < 0.0) {
    surface.curvature = -surface.curvature;
    surface.inward = -surface.inward;
  }
  // A sagitta below the rounding of the coordinates is no curvature at all.
  if (surface.curvature / 2.0 <= problem.residual_resolution) {
    fit.status = FitStatus::radius_unbounded;
    return fit;
  }
  const Linearisation at = linearise(points, surface);
  fit.status = FitStatus::converged;
  fit.apex = surface.apex * extent;
  fit.inward = surface.inward;
  fit.curvature = surface.curvature / extent;
  fit.residuals_mm = at.residuals * extent;

  const double radius = fit.radius_mm();
  fit.J_residuals_local = at.jacobian;
  fit.J_residuals_local.leftCols(n - 1) *= extent;  // per rad
  fit.J_residuals_local.col(n) *= extent * extent;  // per 1/mm
  fit.J_center_radius_local = Eigen::MatrixXd::Zero(n + 1, n + 1);
  fit.J_center_radius_local.topLeftCorner(n, n - 1) = radius * tangents(fit.inward);
  fit.J_center_radius_local.block(0, n - 1, n, 1) = fit.inward;
  fit.J_center_radius_local.block(0, n, n, 1) = -radius * radius * fit.inward;
  fit.J_center_radius_local(n, n) = -radius * radius;
  return fit;
}

bool is_unbounded(const Eigen::MatrixXd& covariance_center, double radius_mm) {
  const double largest = singular_value_decomposition(covariance_center).values(0);
  return !(std::sqrt(largest) <= radius_mm / 2.0);
}

}  // namespace armcal
