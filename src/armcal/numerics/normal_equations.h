// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/numerics/block_sweep.h"
#include "armcal/numerics/least_squares_problem.h"

namespace armcal {

/// How a pass over all blocks is made.
struct PassOptions {
  LossChoice loss;
  int threads = 1;
  Monitor monitor;
};

/// Everything that one pass over the blocks yields at a point.
struct NormalEquations {
  /// Gram matrix of [J r], n + 1 square, lower triangle: J^T J, below it (J^T r)^T and |r|^2.
  Eigen::MatrixXd gram;
  double cost = 0.0;  ///< |r|^2, or the sum of the losses

  /// False where the model is not defined: a residual or a derivative is not finite.
  [[nodiscard]] bool finite() const;
  [[nodiscard]] auto gradient() const { return gram.row(gram.rows() - 1).head(gram.rows() - 1); }
};

/// Sums the Gram matrix of [J r] block by block: theory/least_squares.md eq. (11) and (12). The
/// Jacobian is never kept; workspaces are, from pass to pass.
class NormalEquationsBuilder {
 public:
  NormalEquationsBuilder(const LeastSquaresProblem& problem, const BlockPlan& plan,
                         const PassOptions& options);

  /// One pass at `x`. Throws Interrupted; whatever fill() throws comes through.
  void build(const Eigen::VectorXd& x, NormalEquations& equations);

 private:
  struct Worker {
    AlignedBuffer rows;
    AlignedBuffer local;
  };

  const LeastSquaresProblem& problem_;
  const BlockPlan& plan_;
  const PassOptions& options_;
  std::vector<NormalEquations> shards_;
  std::vector<Worker> workers_;
};

/// R and Q^T r of the QR decomposition of the whole Jacobian.
struct TriangularSystem {
  Eigen::MatrixXd r;  ///< n x n, upper triangular; rows of zeros where there are fewer rows than n
  Eigen::VectorXd q_r;  ///< the first n elements of Q^T r
};

/// The same pass by Householder QR, block by block: theory/least_squares.md eq. (15). Twice the
/// work at half the speed, but its condition number is that of J, not the square of it.
[[nodiscard]] TriangularSystem triangular_system(const LeastSquaresProblem& problem,
                                                 const BlockPlan& plan, const Eigen::VectorXd& x,
                                                 const PassOptions& options);

}  // namespace armcal
