// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/numerics/least_squares_problem.h"
#include "armcal/numerics/robust_loss.h"

namespace armcal {

/// Why the iteration ended. Only the first is a result.
enum class Termination {
  converged,  ///< the undamped step would lower the cost by no more than relative_decrease of it
              ///< (or of the resolution); that step has been taken
  iteration_limit,
  no_decrease,     ///< no step, however short, lowers the cost
  rank_deficient,  ///< at rest, but a column depends on the others: the optimum is not a point
  not_finite,      ///< the model is not defined at the start
};

[[nodiscard]] std::string_view to_string(Termination termination);

struct LeastSquaresOptions {
  int max_iterations = 100;
  RobustLoss loss = RobustLoss::none;
  double loss_scale = 1.345;  ///< in units of whitened residuals
  double relative_decrease = 1e-14;
  /// Rounding of a whitened residual: changes below are no information.
  double residual_resolution = 0;
  int threads = 1;  ///< never changes a digit
  Monitor monitor;
};

struct LeastSquaresSolution {
  Termination termination = Termination::not_finite;
  Eigen::VectorXd x;
  /// Sum of squared residuals (robust: of the loss), at x. Of a converged solution: as predicted
  /// for its last step, which no pass has checked since it is below what the cost can show.
  double cost = 0.0;
  /// The cost at the start and after every step that was taken. Falls, save by rounding where a
  /// step is too small for the cost to show.
  std::vector<double> costs;
  Eigen::Index rows = 0;
  int iterations = 0;             ///< steps tried, the last one included
  double condition_number = 0.0;  ///< of the column-scaled Jacobian at the end
  /// W with W W^T = (J^T J)^-1 at x (weighted by the loss); empty unless converged. Times the
  /// variance of one residual: eq. (7).
  Eigen::MatrixXd inverse_factor;

  [[nodiscard]] bool ok() const { return termination == Termination::converged; }
};

/// Levenberg-Marquardt in a trust region for problems whose Jacobian is too large to keep: up to
/// about 1000 unknowns, any number of rows. One pass over the blocks at each trial point yields
/// cost, gradient and normal equations together. Steps by Cholesky of the column-scaled normal
/// equations; where the condition number of the scaled Jacobian is above 1e5, by QR, with a second
/// pass. Method: theory/least_squares.md eq. (11)-(23).
///
/// Throws Interrupted when the monitor's stop is requested, std::invalid_argument where block
/// shapes contradict each other, and whatever the problem throws.
[[nodiscard]] LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem,
                                                       const Eigen::VectorXd& start,
                                                       const LeastSquaresOptions& options = {});

/// R of the QR decomposition of the whole Jacobian at x, built up block by block (its columns
/// depend on each other exactly as those of the Jacobian, so analyse_rank takes it in its place). n
/// x n; not weighted by a loss. Throws Interrupted. theory/least_squares.md eq. (15).
[[nodiscard]] Eigen::MatrixXd triangular_factor(const LeastSquaresProblem& problem,
                                                const Eigen::VectorXd& x,
                                                const Monitor& monitor = {}, int threads = 1);

/// Every residual at x, block after block.
[[nodiscard]] Eigen::VectorXd residuals_at(const LeastSquaresProblem& problem,
                                           const Eigen::VectorXd& x);

}  // namespace armcal
