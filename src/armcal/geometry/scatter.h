// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "armcal/geometry/fit_summary.h"

namespace armcal {

/// A cloud of points about its mean, with its principal directions: the start of every fit.
/// Distances are taken from the mean, so a cloud a kilometre from the origin loses nothing but the
/// rounding of its own coordinates.
struct Scatter {
  Eigen::Vector3d centroid_mm;
  Eigen::Matrix3Xd points_mm;  ///< from the centroid
  double extent_mm = 0.0;      ///< largest distance from the centroid
  double resolution_mm = 0.0;  ///< rounding of the coordinates as given
  Eigen::Matrix3d directions;  ///< columns: principal directions, widest first, right-handed
  Eigen::Vector3d singular_values_mm;  ///< root of the sum of squares along each
  int dimension = 0;                   ///< 0 coincide, 1 line, 2 plane, 3 space: beyond rounding
};

[[nodiscard]] Scatter scatter_of(std::span<const Eigen::Vector3d> points);

/// The reason to refuse the points at once, if there is one: too few, not finite, or of too small a
/// dimension (1 for a line, 2 for a plane or circle, 3 for a sphere).
[[nodiscard]] std::optional<FitStatus> reason_to_refuse(std::span<const Eigen::Vector3d> points,
                                                        std::size_t least_count);
[[nodiscard]] std::optional<FitStatus> reason_to_refuse(const Scatter& scatter,
                                                        int least_dimension);

/// Variance of one residual: from the stated uncertainty, else from the scatter; nothing without
/// either.
[[nodiscard]] std::optional<double> residual_variance(double sum_of_squares,
                                                      Eigen::Index degrees_of_freedom,
                                                      const FitOptions& options);

}  // namespace armcal
