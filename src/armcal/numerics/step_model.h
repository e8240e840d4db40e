// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "armcal/numerics/normal_equations.h"

namespace armcal {

/// A step in unknowns scaled by the lengths of their columns.
struct ModelStep {
  Eigen::VectorXd scaled;
  double damping = 0.0;
  double length = 0.0;              ///< of the weighted step, the one that a radius limits
  double predicted_decrease = 0.0;  ///< of the cost, were the residuals linear
};

/// The residuals made linear at a point: what a step would do there. Steps come from the
/// column-scaled normal equations by Cholesky, or by QR where those would lose the digits.
/// Method: theory/least_squares.md eq. (13)-(16).
class StepModel {
 public:
  /// @param triangular  makes R and Q^T r at the same point; called only where Cholesky will not do
  StepModel(const NormalEquations& equations, const std::function<TriangularSystem()>& triangular);

  [[nodiscard]] const Eigen::VectorXd& scales() const { return scales_; }
  /// The shortest of the best steps.
  [[nodiscard]] const ModelStep& undamped() const { return undamped_; }
  [[nodiscard]] bool by_qr() const { return r_.size() > 0; }
  [[nodiscard]] bool full_rank() const { return rank_ == scales_.size(); }

  /// Sets what each unknown counts in the length of a step, at least 1.
  void weigh_lengths(const Eigen::VectorXd& weights);
  /// The best step of at most `radius` (met to a tenth), searched from `damping`: eq. (20).
  [[nodiscard]] ModelStep step_within(double radius, double damping) const;

  /// W with W W^T = (J^T J)^-1; nothing when a column depends on the others.
  [[nodiscard]] std::optional<Eigen::MatrixXd> inverse_factor() const;
  /// Of the column-scaled Jacobian; infinite when a column depends on the others.
  [[nodiscard]] double condition_number() const;

 private:
  struct Damped {
    Eigen::MatrixXd lower;  ///< L with L L^T = C + damping E^2
    Eigen::VectorXd step;
  };
  void solve_by_qr(const TriangularSystem& system);
  [[nodiscard]] std::optional<Damped> damped(double damping) const;
  [[nodiscard]] double decrease(const Eigen::VectorXd& step, double damping) const;

  Eigen::VectorXd scales_;
  Eigen::MatrixXd c_;  ///< lower triangle of the scaled normal matrix
  Eigen::VectorXd b_;  ///< scaled gradient
  Eigen::MatrixXd l_;  ///< Cholesky factor of c_; empty by QR
  Eigen::MatrixXd r_;  ///< R of the scaled Jacobian; empty by Cholesky
  Eigen::VectorXd q_r_;
  Eigen::Index rank_ = 0;
  Eigen::VectorXd weights_;
  ModelStep undamped_;
};

}  // namespace armcal
