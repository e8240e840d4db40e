// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/redundant_fit.h"

#include <fmt/format.h>

#include <Eigen/SVD>

#include "armcal/core/diagnostics.h"
#include "armcal/identification/estimation_problem.h"

namespace armcal {
namespace {

// Of the Jacobian with columns of unit length; rounding keeps it from being infinite.
double scaled_condition_number(const Eigen::MatrixXd& r) {
  Eigen::MatrixXd scaled = r;
  for (auto column : scaled.colwise()) {
    const double length = column.norm();
    if (length > 0.0) column /= length;
  }
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues();
  return singular(0) / singular(singular.size() - 1);
}

}  // namespace

std::vector<int> written_parameters(const ArmModel& arm) {
  const ParameterTable table(arm);
  std::vector<int> written;
  for (int i = 0; i < table.size(); ++i) {
    const bool is_idle_beta = table[i].kind == ParameterKind::beta && table[i].nominal == 0.0;
    if (table[i].harmonic == 0 && !is_idle_beta) written.push_back(i);
  }
  return written;
}

FoundArm redundant_fit(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                       const Monitor& monitor) {
  Unknowns unknowns(nominal, written_parameters(nominal));
  std::vector<std::unique_ptr<Residual>> residuals;
  for (const ObservationGroup& group : groups) {
    for (auto& residual : residuals_of(group, false, unknowns))
      residuals.push_back(std::move(residual));
  }
  Eigen::VectorXd x = unknowns.start();
  const ArmAt at{nominal, TipRows(nominal, unknowns.columns())};
  std::vector<const Residual*> pointers;
  for (const bool lengths : {false, true}) {  // lengths start from points that others give
    for (const auto& residual : residuals) {
      if ((residual->group().kind == ReferenceKind::length) != lengths) continue;
      if (const auto problem = residual->start(at, unknowns, x)) throw NumericalError(*problem);
      pointers.push_back(residual.get());
    }
  }
  const EstimationProblem problem(pointers, unknowns, {});
  LeastSquaresOptions options;
  options.residual_resolution = problem.residual_resolution();
  options.monitor = monitor;
  const LeastSquaresSolution solution = solve_least_squares(problem, x, options);
  if (solution.termination == Termination::not_finite)
    throw NumericalError("the readings cannot be computed on the nominal arm");
  FoundArm found;
  found.arm = unknowns.arm_at(solution.x);
  found.free = unknowns.free();
  found.condition_number = scaled_condition_number(triangular_factor(problem, solution.x));
  found.remark =
      fmt::format("{} after {} iterations", to_string(solution.termination), solution.iterations);
  return found;
}

}  // namespace armcal
