// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/extended_precision.h"

#include <Eigen/QR>

namespace armcal::testing {

ExtendedSolution solve_in_extended_precision(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index n = a.cols();
  const LongMatrix long_a = a.cast<long double>();
  const Eigen::HouseholderQR<LongMatrix> qr(long_a);
  const LongMatrix x = qr.solve(b.cast<long double>());
  const LongMatrix inverse_r =
      qr.matrixQR().topRows(n).triangularView<Eigen::Upper>().solve(LongMatrix::Identity(n, n));
  return {x.cast<double>(), inverse_r.rowwise().norm().cast<double>()};
}

}  // namespace armcal::testing
