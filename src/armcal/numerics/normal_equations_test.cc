// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/normal_equations.h"

#include <gtest/gtest.h>

#include <limits>

#include "armcal/core/random.h"
#include "armcal/testing/dense_problem.h"

namespace armcal {
namespace {

using testing::DenseProblem;

constexpr int kUnknowns = 37;

// Blocks of 1 to 300 rows whose columns begin and end anywhere, some leaving out every other one.
std::vector<DenseProblem::Block> varied_blocks(RandomStream& random) {
  std::vector<DenseProblem::Block> blocks;
  for (int i = 0; i < 200; ++i) {
    const auto rows = static_cast<Eigen::Index>(1 + random.below(i % 10 == 0 ? 300 : 12));
    DenseProblem::Block block{rows, {}};
    const int first = static_cast<int>(random.below(kUnknowns - 1));
    const int stride = static_cast<int>(1 + random.below(2));
    for (int column = first; column < kUnknowns; column += stride) block.columns.push_back(column);
    // Runs of equal columns, as an arm's poses have.
    for (std::uint64_t copies = random.below(4) + 1; copies > 0; --copies) blocks.push_back(block);
  }
  blocks.push_back({3, {}});
  blocks.push_back({0, {1, 2}});
  return blocks;
}

struct Varied {
  std::vector<DenseProblem::Block> blocks;
  Eigen::MatrixXd a;
  Eigen::VectorXd b;

  Varied() {
    RandomStream random(3);
    blocks = varied_blocks(random);
    Eigen::Index rows = 0;
    for (const auto& block : blocks) rows += block.rows;
    a = Eigen::MatrixXd::Zero(rows, kUnknowns);
    b.resize(rows);
    Eigen::Index row = 0;
    for (const auto& block : blocks) {
      for (Eigen::Index r = 0; r < block.rows; ++r, ++row) {
        for (const int column : block.columns) a(row, column) = random.normal();
        b(row) = random.normal();
      }
    }
  }
  [[nodiscard]] DenseProblem problem() const { return {kUnknowns, blocks, testing::linear(a, b)}; }
};

NormalEquations built(const LeastSquaresProblem& problem, const Eigen::VectorXd& x,
                      const PassOptions& options = {}) {
  const BlockPlan plan = plan_blocks(problem);
  NormalEquations equations;
  NormalEquationsBuilder(problem, plan, options).build(x, equations);
  return equations;
}

Eigen::MatrixXd lower(const Eigen::MatrixXd& a) { return a.triangularView<Eigen::Lower>(); }

TEST(NormalEquations, OfManyBlocksAreThoseOfTheWholeJacobian) {
  const Varied varied;
  Eigen::MatrixXd whole(varied.a.rows(), kUnknowns + 1);
  whole << varied.a, -varied.b;
  const Eigen::MatrixXd expected = whole.transpose() * whole;
  const NormalEquations equations = built(varied.problem(), Eigen::VectorXd::Zero(kUnknowns));
  const double scale = expected.cwiseAbs().maxCoeff();
  EXPECT_LT((lower(equations.gram) - lower(expected)).cwiseAbs().maxCoeff(), 1e-13 * scale);
  EXPECT_EQ(equations.cost, equations.gram(kUnknowns, kUnknowns));
}

TEST(NormalEquations, HaveTheSameDigitsForEveryNumberOfThreads) {
  const Varied varied;
  const DenseProblem problem = varied.problem();
  ASSERT_GE(plan_blocks(problem).shard_count(), 3);
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(kUnknowns, 0.1);
  const NormalEquations expected = built(problem, x);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(built(problem, x, {.threads = threads}).gram, expected.gram) << threads;
  }
}

TEST(NormalEquations, AreTheSameFromPassToPass) {
  const Varied varied;
  const DenseProblem problem = varied.problem();
  const BlockPlan plan = plan_blocks(problem);
  const PassOptions options;
  NormalEquationsBuilder builder(problem, plan, options);
  NormalEquations first;
  NormalEquations second;
  builder.build(Eigen::VectorXd::Zero(kUnknowns), first);
  builder.build(Eigen::VectorXd::Ones(kUnknowns), second);
  builder.build(Eigen::VectorXd::Zero(kUnknowns), second);
  EXPECT_EQ(first.gram, second.gram);
}

TEST(NormalEquations, OfWeightedRowsHaveTheGradientOfTheLoss) {
  RandomStream random(5);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(60, 4, [&] { return random.normal(); });
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(60, [&] { return 3.0 * random.normal(); });
  const DenseProblem problem(4, {{60, DenseProblem::all(4), 3}}, testing::linear(a, b));
  for (const RobustLoss kind : {RobustLoss::huber, RobustLoss::cauchy}) {
    const PassOptions options{.loss = {kind, 1.345}};
    const NormalEquations here = built(problem, Eigen::VectorXd::Zero(4), options);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double h = 1e-5;
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(4, i);
      const double slope =
          (built(problem, step, options).cost - built(problem, -step, options).cost) / (2.0 * h);
      // The cost is a sum of squares: its gradient is 2 J^T r.
      EXPECT_NEAR(2.0 * here.gradient()(i), slope, 1e-6);
    }
  }
}

TEST(NormalEquations, TellWhereTheModelIsNotDefined) {
  for (const bool derivative : {false, true}) {
    const DenseProblem problem(
        2, 5, [derivative](const Eigen::VectorXd&, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
          r.setOnes();
          J.setOnes();
          (derivative ? J(3, 1) : r(3)) = std::numeric_limits<double>::quiet_NaN();
        });
    EXPECT_FALSE(built(problem, Eigen::VectorXd::Zero(2)).finite());
  }
}

TEST(TriangularSystem, HasTheGramMatrixOfTheJacobian) {
  const Varied varied;
  const DenseProblem problem = varied.problem();
  const TriangularSystem system =
      triangular_system(problem, plan_blocks(problem), Eigen::VectorXd::Zero(kUnknowns), {});
  const Eigen::MatrixXd gram = varied.a.transpose() * varied.a;
  EXPECT_LT((system.r.transpose() * system.r - gram).cwiseAbs().maxCoeff(),
            1e-13 * gram.cwiseAbs().maxCoeff());
  const Eigen::VectorXd gradient = -varied.a.transpose() * varied.b;
  EXPECT_LT((system.r.transpose() * system.q_r - gradient).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_TRUE(system.r.isUpperTriangular(0.0));
}

TEST(TriangularSystem, HasTheSameDigitsForEveryNumberOfThreads) {
  const Varied varied;
  const DenseProblem problem = varied.problem();
  const BlockPlan plan = plan_blocks(problem);
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
  const TriangularSystem expected = triangular_system(problem, plan, x, {});
  for (const int threads : {2, 8}) {
    const TriangularSystem system = triangular_system(problem, plan, x, {.threads = threads});
    EXPECT_EQ(system.r, expected.r);
    EXPECT_EQ(system.q_r, expected.q_r);
  }
}

}  // namespace
}  // namespace armcal
