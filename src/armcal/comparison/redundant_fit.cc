// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/redundant_fit.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "armcal/core/diagnostics.h"
#include "armcal/identification/estimation_problem.h"
#include "armcal/numerics/normal_equations.h"

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

// Readings with all written parameters unknown, placed on the nominal arm.
class Readings {
 public:
  Readings(const ArmModel& nominal, std::span<const ObservationGroup> groups)
      : unknowns(nominal, written_parameters(nominal)) {
    for (const ObservationGroup& group : groups) {
      for (auto& residual : residuals_of(group, false, unknowns))
        residuals_.push_back(std::move(residual));
    }
    start = unknowns.start();
    const ArmAt at{nominal, TipRows(nominal, unknowns.columns())};
    const std::string problems = start_all(residuals_, at, unknowns, start);
    if (!problems.empty()) throw NumericalError(problems);
    for (const auto& residual : residuals_) pointers_.push_back(residual.get());
    weigh_all(residuals_, unknowns, start);
  }

  [[nodiscard]] EstimationProblem problem() const { return {pointers_, unknowns, {}}; }

  Unknowns unknowns;
  Eigen::VectorXd start;

 private:
  std::vector<std::unique_ptr<Residual>> residuals_;
  std::vector<const Residual*> pointers_;
};

// One step of Gauss and Newton with the inverse of the normal equations.
Eigen::VectorXd plain_step(const NormalEquations& equations) {
  const Eigen::Index n = equations.gram.rows() - 1;
  const Eigen::MatrixXd normal = equations.gram.topLeftCorner(n, n).selfadjointView<Eigen::Lower>();
  return -(normal.inverse() * equations.gradient().transpose());
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
  const Readings readings(nominal, groups);
  const EstimationProblem problem = readings.problem();
  LeastSquaresOptions options;
  options.residual_resolution = problem.residual_resolution();
  options.monitor = monitor;
  const LeastSquaresSolution solution = solve_least_squares(problem, readings.start, options);
  if (solution.termination == Termination::not_finite)
    throw NumericalError("the readings cannot be computed on the nominal arm");
  FoundArm found;
  found.arm = readings.unknowns.arm_at(solution.x);
  found.free = readings.unknowns.free();
  found.condition_number = scaled_condition_number(triangular_factor(problem, solution.x));
  found.remark =
      fmt::format("{} after {} iterations", to_string(solution.termination), solution.iterations);
  return found;
}

FoundArm plain_gauss_newton(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                            const Monitor& monitor) {
  constexpr int kSteps = 20;
  const Readings readings(nominal, groups);
  const EstimationProblem problem = readings.problem();
  const BlockPlan plan = plan_blocks(problem);
  const PassOptions pass{{}, 1, monitor};
  NormalEquationsBuilder builder(problem, plan, pass);
  Eigen::VectorXd x = readings.start;
  for (int i = 1; i <= kSteps; ++i) {
    NormalEquations equations;
    builder.build(x, equations);
    if (equations.finite()) x = problem.moved(x, plain_step(equations));
    if (!equations.finite() || !x.allFinite())
      throw NumericalError(fmt::format("lost after {} steps", i));
  }
  FoundArm found;
  found.arm = readings.unknowns.arm_at(x);
  found.free = readings.unknowns.free();
  found.condition_number = scaled_condition_number(triangular_factor(problem, x));
  return found;
}

}  // namespace armcal
