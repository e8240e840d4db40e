// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace armcal {

/// How far each observation of a least-squares problem is checked by the others.
struct Reliability {
  Eigen::VectorXd redundancy;  ///< Baarda's redundancy number, 0 (by nothing) to 1
  /// Correlation of its test with the most similar other one, 0 to 1.
  Eigen::VectorXd closest;
  /// Smallest error, in standard uncertainties of the observation, that the test finds with 80 %
  /// probability; infinite where nothing checks it.
  Eigen::VectorXd detectable;
  /// Smallest error that is found and, of all observations, named, with 99.9 % probability.
  Eigen::VectorXd nameable;
};

/// Significance of the test of one observation, and the probabilities that the two sizes stand for.
inline constexpr double kTestSignificance = 0.001;
inline constexpr double kDetectionPower = 0.80;
inline constexpr double kNamingPower = 0.999;

/// theory/complete_symmetric_point.md eq. (9)-(11).
/// @param whitened  chosen rows of the design over their uncertainties
/// @param covariance  inverse of whitened^T whitened
[[nodiscard]] Reliability reliability(const Eigen::MatrixXd& whitened,
                                      const Eigen::MatrixXd& covariance);

}  // namespace armcal
