// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/linear_algebra.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <limits>

namespace armcal {

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

std::optional<Eigen::MatrixXd> inverse_factor(const Eigen::MatrixXd& a) {
  const Eigen::Index n = a.cols();
  if (n == 0 || a.rows() < n || !a.allFinite()) return std::nullopt;
  const Eigen::VectorXd scales = column_scales(a);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a * scales.cwiseInverse().asDiagonal());
  const Eigen::VectorXd diagonal = qr.matrixR().diagonal().head(n).cwiseAbs();
  const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(n);
  if (!(diagonal.minCoeff() > rounding * diagonal.maxCoeff())) return std::nullopt;
  const Eigen::MatrixXd inverse_r =
      qr.matrixR().topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(
          Eigen::MatrixXd::Identity(n, n));
  return scales.cwiseInverse().asDiagonal() * (qr.colsPermutation() * inverse_r);
}

SingularValueDecomposition singular_value_decomposition(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::VectorXd column_scales(const Eigen::MatrixXd& a) {
  Eigen::VectorXd scales = a.colwise().norm();
  for (double& s : scales) {
    if (!(s > 0.0)) s = 1.0;
  }
  return scales;
}

}  // namespace armcal
