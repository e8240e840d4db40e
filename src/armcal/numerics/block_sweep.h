// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/numerics/least_squares_problem.h"
#include "armcal/numerics/robust_loss.h"

namespace armcal {

/// How the blocks of a problem are cut into shards: runs of neighbouring blocks that are summed on
/// their own and put together in their order. A function of the problem alone, so sums have the
/// same digits for every number of threads.
struct BlockPlan {
  Eigen::Index unknowns = 0;
  Eigen::Index rows = 0;
  Eigen::Index largest_rows = 0;     ///< of one block
  Eigen::Index largest_columns = 0;  ///< of one block
  std::vector<int> shard_ends;       ///< block after the last one, per shard; at least one shard

  [[nodiscard]] int shard_count() const { return static_cast<int>(shard_ends.size()); }
  [[nodiscard]] int shard_begin(int shard) const {
    return shard == 0 ? 0 : shard_ends[static_cast<std::size_t>(shard) - 1];
  }
  [[nodiscard]] int shard_end(int shard) const {
    return shard_ends[static_cast<std::size_t>(shard)];
  }
};

/// Throws std::invalid_argument where a block's columns are not ascending unknowns or its
/// observations do not divide its rows.
[[nodiscard]] BlockPlan plan_blocks(const LeastSquaresProblem& problem);

/// Memory aligned to 64 bytes that only grows.
class AlignedBuffer {
 public:
  /// At least `count` doubles; what they were is lost.
  double* reserve(Eigen::Index count);

 private:
  struct alignas(64) Line {
    std::array<double, 8> values;
  };
  std::vector<Line> lines_;
};

/// The stride of rows with so many derivatives and a residual.
[[nodiscard]] inline Eigen::Index row_stride(Eigen::Index columns) { return (columns + 8) / 8 * 8; }

/// Takes rows, already weighted, of one or several blocks with the same columns.
class RowSink {
 public:
  virtual ~RowSink() = default;
  virtual void add(std::span<const int> columns, const BlockRows& rows) = 0;
};

/// The loss that the rows of a sweep are weighted for.
struct LossChoice {
  RobustLoss kind = RobustLoss::none;
  double scale = 1.0;
};

/// Fills the blocks of one shard in `workspace` and hands them to `sink`, small neighbours with
/// equal columns together. Returns the sum of the losses. Throws Interrupted when `stop` asks for
/// it.
double sweep_shard(const LeastSquaresProblem& problem,
                   const LeastSquaresProblem::Evaluation& evaluation, const BlockPlan& plan,
                   int shard, const LossChoice& loss, const std::stop_token& stop,
                   AlignedBuffer& workspace, RowSink& sink);

}  // namespace armcal
