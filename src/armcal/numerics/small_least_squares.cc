// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/small_least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

constexpr double kFirstDamping = 1e-4;
constexpr double kLargestDamping = 1e12;

// The least gain that a sum of squares can show: its own rounding, and that of the residuals in it.
double visible_gain(double cost, Eigen::Index rows, double resolution) {
  const double root = std::sqrt(cost) + resolution;
  return kSumRounding * cost + 4.0 * root * resolution * std::sqrt(static_cast<double>(rows));
}

// The step that minimises |r + J s|^2 + damping |D s|^2, D the column norms of J.
Eigen::VectorXd damped_step(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                            double damping) {
  const Eigen::VectorXd scales = column_scales(jacobian);
  const Eigen::Index m = jacobian.rows();
  const Eigen::Index n = jacobian.cols();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(damping > 0.0 ? m + n : m, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
  system.topRows(m) = jacobian * scales.cwiseInverse().asDiagonal();
  right.head(m) = -residuals;
  if (damping > 0.0) system.bottomRows(n).diagonal().setConstant(std::sqrt(damping));
  const Eigen::VectorXd step = shortest_solution(system, right);
  return step.cwiseQuotient(scales);
}

}  // namespace

SmallSolution solve_small_least_squares(const SmallProblem& problem, const Eigen::VectorXd& start,
                                        int max_iterations) {
  SmallSolution solution;
  solution.x = start;
  problem.evaluate(solution.x, solution.residuals, solution.jacobian);
  if (!solution.residuals.allFinite() || !solution.jacobian.allFinite()) return solution;

  double cost = solution.residuals.squaredNorm();
  double damping = 0.0;
  double last_change = std::numeric_limits<double>::infinity();
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  while (solution.iterations < max_iterations) {
    ++solution.iterations;
    const Eigen::VectorXd step = damped_step(solution.jacobian, solution.residuals, damping);
    const Eigen::VectorXd changes = solution.jacobian * step;
    const double change = changes.lpNorm<Eigen::Infinity>();
    // Damping shortens the step, so only an undamped one proves that nothing is left to gain.
    const bool undamped = damping == 0.0;
    const bool at_rest = undamped && change <= problem.residual_resolution;
    // Close to the optimum the sum of squares cannot tell a step from none (its change is of second
    // order), but the steps still shrink: follow them, or half of the digits stay unused.
    const bool blind =
        undamped &&
        changes.squaredNorm() <= visible_gain(cost, changes.size(), problem.residual_resolution);
    if (blind && !at_rest && change >= last_change) {
      solution.termination = SmallTermination::converged;
      return solution;
    }
    const Eigen::VectorXd x = problem.move ? problem.move(solution.x, step) : solution.x + step;
    problem.evaluate(x, residuals, jacobian);
    const bool usable = residuals.allFinite() && jacobian.allFinite();
    if (usable && (residuals.squaredNorm() < cost || at_rest || blind)) {
      solution.x = x;
      std::swap(solution.residuals, residuals);
      std::swap(solution.jacobian, jacobian);
      cost = solution.residuals.squaredNorm();
      damping = damping <= kFirstDamping ? 0.0 : damping / 10.0;
      last_change = undamped ? change : std::numeric_limits<double>::infinity();
    } else {
      damping = undamped ? kFirstDamping : damping * 10.0;
    }
    if (at_rest) {
      solution.termination = SmallTermination::converged;
      return solution;
    }
    if (damping > kLargestDamping) {
      solution.termination = SmallTermination::no_decrease;
      return solution;
    }
  }
  solution.termination = SmallTermination::iteration_limit;
  return solution;
}

std::optional<Eigen::MatrixXd> cofactor_matrix(const Eigen::MatrixXd& jacobian) {
  const auto factor = inverse_factor(jacobian);
  if (!factor) return std::nullopt;
  return *factor * factor->transpose();
}

}  // namespace armcal
