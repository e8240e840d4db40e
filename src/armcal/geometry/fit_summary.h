// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// How a fit ended. Only `converged` is a result; everything else says why the points cannot give
/// one.
enum class FitStatus {
  converged,
  too_few_points,
  not_finite,            ///< a coordinate is NaN or infinite
  points_coincide,       ///< to the rounding of their coordinates
  points_are_collinear,  ///< to the rounding of their coordinates
  points_are_coplanar,   ///< to the rounding of their coordinates
  radius_unbounded,  ///< the points leave the centre free: its standard uncertainty exceeds half
                     ///< the radius
  ambiguous,         ///< more than one rotation fits equally well (registration)
  no_convergence,
};

/// The name of the status as written in JSON, such as `points_are_collinear`.
[[nodiscard]] std::string_view to_string(FitStatus status);

/// The same in words for a person: "the points lie on one line".
[[nodiscard]] std::string_view explain(FitStatus status);

struct FitOptions {
  /// Standard uncertainty of each coordinate. Given: the covariance follows from it. Not given:
  /// from the scatter of the points about the fitted element (GUM type A).
  std::optional<double> u_point_mm;
  int max_iterations = 100;
};

/// What every fit reports beside its element.
struct FitSummary {
  FitStatus status = FitStatus::too_few_points;
  Eigen::Index count = 0;               ///< points
  Eigen::Index degrees_of_freedom = 0;  ///< scalar residuals minus unknowns
  double rms_mm = 0.0;                  ///< root mean square of the orthogonal distances
  double form_mm = 0.0;          ///< largest minus smallest signed deviation, see each element
  Eigen::VectorXd residuals_mm;  ///< orthogonal distance of each point, signed where a side exists
  /// Covariance of the quantities named in `covariance_of` (mm^2, mm, 1), to first order. Empty
  /// when there are no degrees of freedom and no u_point_mm.
  std::optional<Eigen::MatrixXd> covariance;
  std::vector<std::string> covariance_of;

  [[nodiscard]] bool ok() const { return status == FitStatus::converged; }
  /// Standard uncertainty of a quantity named in `covariance_of`; nothing without a covariance.
  [[nodiscard]] std::optional<double> standard_uncertainty(std::string_view quantity) const;
};

}  // namespace armcal
