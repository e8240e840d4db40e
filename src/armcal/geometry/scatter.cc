// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/scatter.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "armcal/geometry/rigid_transform.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {

Scatter scatter_of(std::span<const Eigen::Vector3d> points) {
  Scatter scatter;
  const auto count = static_cast<Eigen::Index>(points.size());
  // The mean of differences from the first point: sums of large coordinates would round.
  const Eigen::Vector3d origin = points.front();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double largest = 0.0;
  for (const Eigen::Vector3d& point : points) {
    mean += (point - origin) / static_cast<double>(count);
    largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
  }
  scatter.centroid_mm = origin + mean;
  scatter.points_mm.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    scatter.points_mm.col(i) = points[static_cast<std::size_t>(i)] - scatter.centroid_mm;
  }
  scatter.extent_mm = std::sqrt(scatter.points_mm.colwise().squaredNorm().maxCoeff());
  scatter.resolution_mm = std::numeric_limits<double>::epsilon() * largest;

  const auto svd = singular_value_decomposition(scatter.points_mm.transpose());
  scatter.singular_values_mm.setZero();
  scatter.singular_values_mm.head(svd.values.size()) = svd.values;
  const Eigen::Index known = svd.v.cols();
  scatter.directions.leftCols(known) = svd.v;
  if (known == 1) {
    const auto [first, second] = perpendicular_pair(scatter.directions.col(0));
    scatter.directions.col(1) = first;
    scatter.directions.col(2) = second;
  } else {
    scatter.directions.col(2) = scatter.directions.col(0).cross(scatter.directions.col(1));
  }
  // Rounding moves each coordinate by half a unit; the singular values by the root of the sum of
  // squares.
  const double rounding = 2.0 * scatter.resolution_mm * std::sqrt(static_cast<double>(count));
  for (const double value : scatter.singular_values_mm) {
    if (value > rounding) ++scatter.dimension;
  }
  return scatter;
}

std::optional<FitStatus> reason_to_refuse(std::span<const Eigen::Vector3d> points,
                                          std::size_t least_count) {
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) return FitStatus::not_finite;
  }
  if (points.size() < least_count) return FitStatus::too_few_points;
  return std::nullopt;
}

std::optional<FitStatus> reason_to_refuse(const Scatter& scatter, int least_dimension) {
  if (scatter.dimension >= least_dimension) return std::nullopt;
  switch (scatter.dimension) {
    case 0:
      return FitStatus::points_coincide;
    case 1:
      return FitStatus::points_are_collinear;
    default:
      return FitStatus::points_are_coplanar;
  }
}

std::optional<double> residual_variance(double sum_of_squares, Eigen::Index degrees_of_freedom,
                                        const FitOptions& options) {
  if (options.u_point_mm) return *options.u_point_mm * *options.u_point_mm;
  if (degrees_of_freedom <= 0) return std::nullopt;
  return sum_of_squares / static_cast<double>(degrees_of_freedom);
}

}  // namespace armcal
