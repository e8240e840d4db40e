// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/rank_analysis.h"

#include <limits>

#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {

RankAnalysis analyse_rank(const Eigen::MatrixXd& jacobian, const std::vector<int>& preference,
                          double tolerance) {
  ARMCAL_INVARIANT(static_cast<Eigen::Index>(preference.size()) == jacobian.cols());
  const Eigen::Index m = jacobian.rows();
  const Eigen::Index n = jacobian.cols();
  const Eigen::VectorXd lengths = jacobian.colwise().norm();

  RankAnalysis analysis;
  Eigen::MatrixXd q(m, n);                          // orthonormal basis of the kept columns
  Eigen::MatrixXd r = Eigen::MatrixXd::Zero(n, n);  // kept columns (scaled) = q * r
  for (const int column : preference) {
    const double length = lengths(column);
    if (!(length > std::numeric_limits<double>::min())) {
      analysis.unseen.push_back(column);
      continue;
    }
    const Eigen::Index k = analysis.rank;
    const auto basis = q.leftCols(k);
    Eigen::VectorXd rest = jacobian.col(column) / length;
    Eigen::VectorXd parts = basis.transpose() * rest;
    rest -= basis * parts;
    // Once is not enough: the first pass loses as many digits as the column is dependent.
    const Eigen::VectorXd correction = basis.transpose() * rest;
    rest -= basis * correction;
    parts += correction;
    const double height = rest.norm();
    if (k < m && height > tolerance) {
      q.col(k) = rest / height;
      r.col(k).head(k) = parts;
      r(k, k) = height;
      analysis.basis.push_back(column);
      ++analysis.rank;
      continue;
    }
    DependentColumn dependent;
    dependent.column = column;
    dependent.weights = r.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(parts) * length;
    for (Eigen::Index i = 0; i < k; ++i) {
      dependent.weights(i) /= lengths(analysis.basis[static_cast<std::size_t>(i)]);
    }
    analysis.dependent.push_back(std::move(dependent));
  }
  // A column that became dependent early has no weight on basis columns that came later.
  for (DependentColumn& dependent : analysis.dependent) {
    const Eigen::Index known = dependent.weights.size();
    dependent.weights.conservativeResize(analysis.rank);
    dependent.weights.tail(analysis.rank - known).setZero();
  }
  if (analysis.rank > 0) {
    const Eigen::Index k = analysis.rank;
    analysis.singular_values = singular_value_decomposition(r.topLeftCorner(k, k)).values;
    analysis.condition_number = analysis.singular_values(0) / analysis.singular_values(k - 1);
  }
  return analysis;
}

}  // namespace armcal
