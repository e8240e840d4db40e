// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace armcal {

/// A nonlinear least-squares problem small enough to keep its Jacobian: fits of elements,
/// adjustments of tens of readings. Minimises the sum of squared residuals.
struct SmallProblem {
  /// Fills residuals (m) and Jacobian (m x n) at `x`. A point where the model is not defined is
  /// told by a residual that is not finite.
  std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                     Eigen::MatrixXd& jacobian)>
      evaluate;
  /// Moves `x` by a step in the n local coordinates of the Jacobian's columns. Empty means x +
  /// step; a direction on the sphere, say, needs more numbers in x than it has degrees of freedom.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> move;
  /// Changes of a residual below this are rounding, not information.
  double residual_resolution = 0.0;
};

/// Why the iteration ended. Only `converged` is a result.
enum class SmallTermination {
  converged,        ///< the next step would change no residual by more than residual_resolution
  iteration_limit,  ///< max_iterations steps were taken
  no_decrease,      ///< no step, however short, makes the sum of squares smaller
  not_finite,       ///< the model is not defined at the start
};

struct SmallSolution {
  SmallTermination termination = SmallTermination::not_finite;
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< at x
  int iterations = 0;

  [[nodiscard]] bool ok() const { return termination == SmallTermination::converged; }
};

/// Levenberg-Marquardt from `start`, each step by QR of the column-scaled Jacobian (never by normal
/// equations, so data of condition number 1e8 still give eight digits). Undamped Gauss-Newton as
/// long as that makes progress; a rank-deficient Jacobian gets the shortest step. Method:
/// theory/least_squares.md eq. (1)-(6).
[[nodiscard]] SmallSolution solve_small_least_squares(const SmallProblem& problem,
                                                      const Eigen::VectorXd& start,
                                                      int max_iterations = 100);

/// (J^T J)^-1 by QR of the column-scaled Jacobian; nothing when a column depends on the others to
/// rounding or when there are fewer rows than columns. Times the variance of one residual it is the
/// covariance of the estimate: theory/least_squares.md eq. (7).
[[nodiscard]] std::optional<Eigen::MatrixXd> cofactor_matrix(const Eigen::MatrixXd& jacobian);

}  // namespace armcal
