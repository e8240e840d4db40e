// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/coverage.h"

#include "armcal/identification/estimation_problem.h"
#include "armcal/numerics/distributions.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {

Coverage coverage_of(const CheckRows& check, const Unknowns& fitted, const Eigen::MatrixXd& factor,
                     double widening) {
  const Unknowns unknowns = check.unknowns.with_free(fitted.free());
  const Eigen::VectorXd x = unknowns.state_from(check.unknowns, check.x);
  std::vector<const Residual*> residuals;
  for (const auto& residual : check.residuals) residuals.push_back(residual.get());
  const EstimationProblem problem(residuals, unknowns, {});
  // The unknowns of the fit come first among those of the held-out rows.
  Eigen::MatrixXd of_all = Eigen::MatrixXd::Zero(unknowns.step_size(), factor.cols());
  of_all.topRows(factor.rows()) = factor;

  Coverage coverage;
  const auto at = problem.at(x);
  for (int b = 0; b < problem.block_count(); ++b) {
    const auto shape = problem.shape(b);
    const auto columns = static_cast<Eigen::Index>(shape.columns.size());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows =
        Eigen::MatrixXd::Zero(shape.rows, columns + 1);
    at->fill(b, {shape.rows, columns, columns + 1, rows.data()});
    Eigen::MatrixXd own(columns, factor.cols());
    for (Eigen::Index c = 0; c < columns; ++c)
      own.row(c) = of_all.row(shape.columns[static_cast<std::size_t>(c)]);
    const Eigen::MatrixXd spread =
        rows.leftCols(columns) * own;  // of predictions, in units of a reading's scatter
    const Eigen::Index size = shape.rows_per_observation;
    for (Eigen::Index first = 0; first < shape.rows; first += size) {
      const auto part = spread.middleRows(first, size);
      const Eigen::MatrixXd covariance =
          Eigen::MatrixXd::Identity(size, size) + part * part.transpose();
      const Eigen::VectorXd r = rows.col(columns).segment(first, size) / widening;
      const double square = r.dot(shortest_solution(covariance, r));
      coverage.inside += square <= chi_squared_quantile(0.95, static_cast<double>(size));
      ++coverage.count;
    }
  }
  return coverage;
}

}  // namespace armcal
