// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/block_sweep.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace armcal {
namespace {

// Multiplications from which a shard is worth a thread's waking up: some 50 microseconds.
constexpr double kShardWork = 5e5;
// Enough for even work on tens of threads.
constexpr Eigen::Index kMostShards = 64;
// All shards together: 128 MiB of doubles, 16 shards of 1000 unknowns.
constexpr Eigen::Index kShardMemory = Eigen::Index{1} << 24;
// Rows from which it does not matter that sums go from memory to registers and back.
constexpr Eigen::Index kEnoughRows = 64;

double work_of(const LeastSquaresProblem::BlockShape& shape) {
  const auto width = static_cast<double>(shape.columns.size() + 1);
  return static_cast<double>(shape.rows) * width * width;
}

void check_shape(const LeastSquaresProblem::BlockShape& shape, int block, int unknowns) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("least-squares block " + std::to_string(block) + ": " + what);
  };
  int before = -1;
  for (const int column : shape.columns) {
    if (column <= before || column >= unknowns) {
      refuse("column " + std::to_string(column) + " after " + std::to_string(before) + " of " +
             std::to_string(unknowns) + " unknowns");
    }
    before = column;
  }
  if (shape.rows < 0 || shape.rows_per_observation < 1 ||
      shape.rows % shape.rows_per_observation != 0) {
    refuse(std::to_string(shape.rows) + " rows in observations of " +
           std::to_string(shape.rows_per_observation));
  }
}

Eigen::Index shard_count(double work, Eigen::Index unknowns, int blocks) {
  const auto by_work = static_cast<Eigen::Index>(std::min(work / kShardWork, 1e6));
  const Eigen::Index by_memory = kShardMemory / ((unknowns + 1) * (unknowns + 1));
  return std::max<Eigen::Index>(1,
                                std::min({by_work, by_memory, kMostShards, Eigen::Index{blocks}}));
}

double weigh_rows(const BlockRows& rows, Eigen::Index rows_per_observation,
                  const LossChoice& choice) {
  double sum = 0.0;
  for (Eigen::Index first = 0; first < rows.rows; first += rows_per_observation) {
    double squared = 0.0;
    for (Eigen::Index r = first; r < first + rows_per_observation; ++r) {
      squared += rows.residual(r) * rows.residual(r);
    }
    const LossAndWeight at = robust_loss(choice.kind, squared, choice.scale);
    sum += at.loss;
    if (at.weight == 1.0) continue;
    Eigen::Map<Eigen::ArrayXd>(rows.row(first), rows_per_observation * rows.stride) *=
        std::sqrt(at.weight);
  }
  return sum;
}

}  // namespace

BlockPlan plan_blocks(const LeastSquaresProblem& problem) {
  BlockPlan plan;
  plan.unknowns = problem.unknown_count();
  const int blocks = problem.block_count();
  double work = 0.0;
  for (int block = 0; block < blocks; ++block) {
    const auto shape = problem.shape(block);
    check_shape(shape, block, problem.unknown_count());
    work += work_of(shape);
    plan.rows += shape.rows;
    plan.largest_rows = std::max(plan.largest_rows, shape.rows);
    plan.largest_columns =
        std::max(plan.largest_columns, static_cast<Eigen::Index>(shape.columns.size()));
  }
  const Eigen::Index shards = shard_count(work, plan.unknowns, blocks);
  const double share = work / static_cast<double>(shards);
  double done = 0.0;
  for (int block = 0; block + 1 < blocks; ++block) {
    done += work_of(problem.shape(block));
    const auto ended = static_cast<double>(plan.shard_ends.size());
    if (done >= share * (ended + 1.0) && ended + 1.0 < static_cast<double>(shards)) {
      plan.shard_ends.push_back(block + 1);
    }
  }
  plan.shard_ends.push_back(blocks);
  return plan;
}

double* AlignedBuffer::reserve(Eigen::Index count) {
  const auto lines = static_cast<std::size_t>((count + 7) / 8);
  if (lines_.size() < std::max<std::size_t>(lines, 1)) {
    lines_.resize(std::max<std::size_t>(lines, 1));
  }
  return lines_.front().values.data();
}

double sweep_shard(const LeastSquaresProblem& problem,
                   const LeastSquaresProblem::Evaluation& evaluation, const BlockPlan& plan,
                   int shard, const LossChoice& loss, const std::stop_token& stop,
                   AlignedBuffer& workspace, RowSink& sink) {
  const Eigen::Index room = std::max(kEnoughRows, plan.largest_rows);
  BlockRows gathered;
  gathered.data = workspace.reserve(room * row_stride(plan.largest_columns));
  std::span<const int> columns;
  double cost = 0.0;
  for (int block = plan.shard_begin(shard); block < plan.shard_end(shard); ++block) {
    if (stop.stop_requested()) throw Interrupted();
    const auto shape = problem.shape(block);
    if (gathered.rows > 0 &&
        (gathered.rows + shape.rows > room || !std::ranges::equal(columns, shape.columns))) {
      sink.add(columns, gathered);
      gathered.rows = 0;
    }
    if (gathered.rows == 0) {
      columns = shape.columns;
      gathered.columns = static_cast<Eigen::Index>(columns.size());
      gathered.stride = row_stride(gathered.columns);
    }
    BlockRows rows = gathered;
    rows.data = gathered.row(gathered.rows);
    rows.rows = shape.rows;
    std::fill_n(rows.data, rows.rows * rows.stride, 0.0);
    evaluation.fill(block, rows);
    if (loss.kind != RobustLoss::none) {
      cost += weigh_rows(rows, shape.rows_per_observation, loss);
    }
    gathered.rows += rows.rows;
  }
  if (gathered.rows > 0) sink.add(columns, gathered);
  return cost;
}

}  // namespace armcal
