// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/reliability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armcal/numerics/distributions.h"

namespace armcal {

Reliability reliability(const Eigen::MatrixXd& whitened, const Eigen::MatrixXd& covariance) {
  static const double critical = normal_quantile(1.0 - kTestSignificance / 2.0);
  static const double detected = critical + normal_quantile(kDetectionPower);
  static const double sure = normal_quantile(kNamingPower);
  // Less than this share of an observation is checked: nothing but rounding stands behind it.
  constexpr double kUnchecked = 1e-9;
  const Eigen::Index m = whitened.rows();
  const Eigen::MatrixXd cofactor =
      Eigen::MatrixXd::Identity(m, m) - whitened * covariance * whitened.transpose();
  Reliability result;
  result.redundancy = cofactor.diagonal().cwiseMax(0.0).cwiseMin(1.0);
  result.closest = Eigen::VectorXd::Zero(m);
  const Eigen::VectorXd root = result.redundancy.cwiseSqrt();
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (result.redundancy(i) < kUnchecked || result.redundancy(j) < kUnchecked) continue;
      const double correlation = std::min(1.0, std::abs(cofactor(i, j)) / (root(i) * root(j)));
      result.closest(i) = std::max(result.closest(i), correlation);
      result.closest(j) = std::max(result.closest(j), correlation);
    }
  }
  const double nothing = std::numeric_limits<double>::infinity();
  result.detectable = Eigen::VectorXd::Constant(m, nothing);
  result.nameable = Eigen::VectorXd::Constant(m, nothing);
  for (Eigen::Index i = 0; i < m; ++i) {
    if (result.redundancy(i) < kUnchecked) continue;
    result.detectable(i) = detected / root(i);
    const double told_apart = sure * std::sqrt(2.0 / (1.0 - result.closest(i)));
    result.nameable(i) = std::max(critical + sure, told_apart) / root(i);
  }
  return result;
}

}  // namespace armcal
