// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/block_sweep.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "armcal/testing/dense_problem.h"

namespace armcal {
namespace {

using testing::DenseProblem;

DenseProblem::Evaluate nothing() {
  return [](const Eigen::VectorXd&, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r.setZero();
    J.setZero();
  };
}

TEST(BlockPlan, KeepsASmallProblemWhole) {
  const DenseProblem problem(10, {{64, DenseProblem::all(10)}, {6, {1, 2}}}, nothing());
  const BlockPlan plan = plan_blocks(problem);
  EXPECT_EQ(plan.shard_count(), 1);
  EXPECT_EQ(plan.rows, 70);
  EXPECT_EQ(plan.largest_rows, 64);
  EXPECT_EQ(plan.largest_columns, 10);
}

TEST(BlockPlan, CutsALargeProblemIntoEqualWork) {
  std::vector<DenseProblem::Block> blocks(1000, {192, DenseProblem::all(33)});
  // A few blocks far above the others.
  for (int i = 0; i < 3; ++i) blocks.push_back({2000, DenseProblem::all(33)});
  const BlockPlan plan = plan_blocks(DenseProblem(33, std::move(blocks), nothing()));
  EXPECT_EQ(plan.shard_count(), 64);
  EXPECT_EQ(plan.shard_begin(0), 0);
  EXPECT_EQ(plan.shard_end(plan.shard_count() - 1), 1003);
  for (int shard = 0; shard < plan.shard_count(); ++shard) {
    const int blocks_in_shard = plan.shard_end(shard) - plan.shard_begin(shard);
    EXPECT_GE(blocks_in_shard, 1);
    EXPECT_LE(blocks_in_shard, 17);  // 198000 rows / 64 / 192, and one
  }
}

TEST(BlockPlan, BoundsTheMemoryOfManyUnknowns) {
  std::vector<DenseProblem::Block> blocks(100, {1000, DenseProblem::all(1000)});
  const BlockPlan plan = plan_blocks(DenseProblem(1000, std::move(blocks), nothing()));
  EXPECT_EQ(plan.shard_count(), 16);
}

TEST(BlockPlan, RefusesBlocksThatContradictThemselves) {
  const auto plan = [](DenseProblem::Block block) {
    return plan_blocks(DenseProblem(3, {std::move(block)}, nothing()));
  };
  EXPECT_THROW((void)plan({2, {1, 1}}), std::invalid_argument);
  EXPECT_THROW((void)plan({2, {2, 0}}), std::invalid_argument);
  EXPECT_THROW((void)plan({2, {3}}), std::invalid_argument);
  EXPECT_THROW((void)plan({2, {-1}}), std::invalid_argument);
  EXPECT_THROW((void)plan({4, {0}, 3}), std::invalid_argument);
  EXPECT_THROW((void)plan({4, {0}, 0}), std::invalid_argument);
}

TEST(AlignedBuffer, StartsOnALineOf64Bytes) {
  AlignedBuffer buffer;
  for (const Eigen::Index count : {0, 1, 8, 1000}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.reserve(count)) % 64, 0U);
  }
}

TEST(SweepShard, GathersSmallNeighboursWithEqualColumns) {
  struct Counter : RowSink {
    std::vector<Eigen::Index> rows;
    void add(std::span<const int>, const BlockRows& block) override { rows.push_back(block.rows); }
  };
  std::vector<DenseProblem::Block> blocks(100, {1, {0, 1}});
  blocks.push_back({5, {0}});
  blocks.push_back({5, {0}});
  blocks.push_back({5, {1}});
  const DenseProblem problem(2, std::move(blocks), nothing());
  const auto evaluation = problem.at(Eigen::VectorXd::Zero(2));
  Counter counter;
  AlignedBuffer workspace;
  sweep_shard(problem, *evaluation, plan_blocks(problem), 0, {}, {}, workspace, counter);
  EXPECT_EQ(counter.rows, (std::vector<Eigen::Index>{64, 36, 10, 5}));
}

TEST(SweepShard, GivesEveryBlockZeroedRows) {
  struct Check : LeastSquaresProblem {
    std::vector<int> columns = {0, 1, 2};
    [[nodiscard]] int unknown_count() const override { return 3; }
    [[nodiscard]] int block_count() const override { return 50; }
    [[nodiscard]] BlockShape shape(int) const override { return {7, 1, columns}; }
    [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd&) const override {
      struct Here : Evaluation {
        void fill(int, const BlockRows& rows) const override {
          EXPECT_EQ(rows.stride % 8, 0);
          for (Eigen::Index i = 0; i < rows.rows * rows.stride; ++i) {
            ASSERT_EQ(rows.data[i], 0.0);
            rows.data[i] = 1.0;
          }
        }
      };
      return std::make_unique<Here>();
    }
  } problem;
  struct Ignore : RowSink {
    void add(std::span<const int>, const BlockRows&) override {}
  } sink;
  AlignedBuffer workspace;
  sweep_shard(problem, *problem.at({}), plan_blocks(problem), 0, {}, {}, workspace, sink);
}

}  // namespace
}  // namespace armcal
