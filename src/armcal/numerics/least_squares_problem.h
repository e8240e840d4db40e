// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

namespace armcal {

/// Rows of one block, as a problem fills them: row-major, derivatives by the block's own columns in
/// their order, then the residual, then zeros up to the stride (a multiple of 8; memory aligned to
/// 64 bytes). All zero before the call.
struct BlockRows {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;  ///< derivatives; the residual stands in this column
  Eigen::Index stride = 0;
  double* data = nullptr;

  [[nodiscard]] double* row(Eigen::Index r) const { return data + r * stride; }
  [[nodiscard]] double& residual(Eigen::Index r) const { return data[r * stride + columns]; }
};

/// A nonlinear least-squares problem whose rows are produced block by block and never kept.
class LeastSquaresProblem {
 public:
  virtual ~LeastSquaresProblem() = default;

  struct BlockShape {
    Eigen::Index rows = 0;
    /// Rows of one observation (3 for a point): a robust loss weighs them together. Divides `rows`.
    Eigen::Index rows_per_observation = 1;
    /// Unknowns that the rows depend on, ascending. Neighbouring blocks with equal columns are
    /// cheapest. The numbers must live as long as the problem.
    std::span<const int> columns;
  };

  /// The problem at one point: prepared once, then asked for its blocks, from several threads at
  /// once.
  class Evaluation {
   public:
    virtual ~Evaluation() = default;
    /// Fills derivatives and residuals. A point where the model is not defined is told by a
    /// residual that is not finite.
    virtual void fill(int block, const BlockRows& rows) const = 0;
  };

  [[nodiscard]] virtual int unknown_count() const = 0;
  [[nodiscard]] virtual int block_count() const = 0;
  [[nodiscard]] virtual BlockShape shape(int block) const = 0;
  [[nodiscard]] virtual std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const = 0;
  /// Moves `x` by a step of unknown_count() numbers; x itself may hold more (directions,
  /// rotations).
  [[nodiscard]] virtual Eigen::VectorXd moved(const Eigen::VectorXd& x,
                                              const Eigen::VectorXd& step) const {
    return x + step;
  }
};

}  // namespace armcal
