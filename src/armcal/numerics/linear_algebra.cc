// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <limits>

namespace armcal {

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

RankedSolution shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                 double tolerance) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(tolerance);
  decomposition.compute(a);
  return {decomposition.solve(b), decomposition.rank()};
}

void triangularise(Eigen::Ref<Eigen::MatrixXd> a) {
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> in_place(a);
  a.triangularView<Eigen::StrictlyLower>().setZero();
}

std::optional<CholeskyFactor> cholesky_factor(const Eigen::MatrixXd& a) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  return CholeskyFactor{cholesky.matrixLLT(), 1.0 / cholesky.rcond()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
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
