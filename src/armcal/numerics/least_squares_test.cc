// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/least_squares.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/core/random.h"
#include "armcal/numerics/rank_analysis.h"
#include "armcal/testing/dense_problem.h"
#include "armcal/testing/extended_precision.h"

namespace armcal {
namespace {

using testing::DenseProblem;

// Residuals that bend: r_i = sin(a_i . x) + a_i . x - y_i, in blocks as wanted.
struct Bent {
  Eigen::MatrixXd a;
  Eigen::VectorXd y;

  Bent(Eigen::Index rows, Eigen::Index unknowns, double noise, std::uint64_t seed = 1) {
    RandomStream random(seed);
    const double scale = 1.0 / std::sqrt(static_cast<double>(unknowns));
    a = Eigen::MatrixXd::NullaryExpr(rows, unknowns, [&] { return scale * random.normal(); });
    const Eigen::VectorXd truth = Eigen::VectorXd::LinSpaced(unknowns, -0.5, 0.5);
    const Eigen::ArrayXd t = a * truth;
    y = t.sin() + t;
    for (double& value : y) value += noise * random.normal();
  }
  [[nodiscard]] DenseProblem::Evaluate evaluate() const {
    return [this](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
      const Eigen::ArrayXd t = a * x;
      r = (t.sin() + t).matrix() - y;
      J = (t.cos() + 1.0).matrix().asDiagonal() * a;
    };
  }
  [[nodiscard]] std::vector<DenseProblem::Block> blocks(Eigen::Index rows_of_one) const {
    const auto columns = DenseProblem::all(static_cast<int>(a.cols()));
    std::vector<DenseProblem::Block> all;
    for (Eigen::Index first = 0; first < a.rows(); first += rows_of_one) {
      all.push_back({std::min(rows_of_one, a.rows() - first), columns});
    }
    return all;
  }
  [[nodiscard]] DenseProblem problem(Eigen::Index rows_of_one) const {
    return {static_cast<int>(a.cols()), blocks(rows_of_one), evaluate()};
  }
};

Eigen::VectorXd zeros(Eigen::Index n) { return Eigen::VectorXd::Zero(n); }

TEST(LeastSquares, SolvesALinearProblemInOneStepAndProvesIt) {
  RandomStream random(2);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(50, 6, [&] { return random.normal(); });
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(50, [&] { return random.normal(); });
  const auto solution = solve_least_squares(DenseProblem(6, 50, testing::linear(a, b)), zeros(6));
  ASSERT_TRUE(solution.ok());
  const Eigen::VectorXd expected = testing::solve_in_extended_precision(a, b).x;
  EXPECT_LT((solution.x - expected).norm(), 1e-14);
  EXPECT_EQ(solution.iterations, 2);
  EXPECT_EQ(solution.rows, 50);
  EXPECT_NEAR(solution.cost, (a * expected - b).squaredNorm(), 1e-12);
  const Eigen::MatrixXd cofactor = solution.inverse_factor * solution.inverse_factor.transpose();
  EXPECT_LT((cofactor * (a.transpose() * a) - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-13);
}

TEST(LeastSquares, DoesNotDependOnHowRowsAreCutIntoBlocks) {
  const Bent bent(3000, 20, 0.01);
  const auto whole = solve_least_squares(bent.problem(3000), zeros(20));
  ASSERT_TRUE(whole.ok());
  for (const Eigen::Index rows : {1, 7, 192}) {
    const auto cut = solve_least_squares(bent.problem(rows), zeros(20));
    ASSERT_TRUE(cut.ok());
    EXPECT_LT((cut.x - whole.x).norm(), 1e-12 * whole.x.norm()) << rows;
    EXPECT_NEAR(cut.cost / whole.cost, 1.0, 1e-12);
    EXPECT_LT((cut.inverse_factor - whole.inverse_factor).norm(),
              1e-12 * whole.inverse_factor.norm());
  }
}

TEST(LeastSquares, HasTheSameDigitsForEveryNumberOfThreads) {
  const Bent bent(12000, 20, 0.01);  // about ten shards
  const DenseProblem problem = bent.problem(192);
  for (const RobustLoss loss : {RobustLoss::none, RobustLoss::huber}) {
    const LeastSquaresOptions options{.loss = loss, .loss_scale = 0.01};
    const auto expected = solve_least_squares(problem, zeros(20), options);
    ASSERT_TRUE(expected.ok());
    for (const int threads : {2, 3, 8}) {
      LeastSquaresOptions threaded = options;
      threaded.threads = threads;
      const auto solution = solve_least_squares(problem, zeros(20), threaded);
      EXPECT_EQ(solution.x, expected.x) << threads;
      EXPECT_EQ(solution.cost, expected.cost) << threads;
      EXPECT_EQ(solution.inverse_factor, expected.inverse_factor) << threads;
    }
  }
}

TEST(LeastSquares, SolvesForUnknownsThatBelongToSomeBlocksOnly) {
  // 4 shared unknowns and one of its own for each of 120 blocks, as each placement of an artefact
  // has.
  constexpr int kBlocks = 120;
  constexpr int kUnknowns = 4 + kBlocks;
  RandomStream random(9);
  std::vector<DenseProblem::Block> blocks;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5 * kBlocks, kUnknowns);
  for (int block = 0; block < kBlocks; ++block) {
    blocks.push_back({5, {0, 1, 2, 3, 4 + block}});
    for (Eigen::Index row = 5 * block; row < 5 * block + 5; ++row) {
      for (const int column : blocks.back().columns) a(row, column) = random.normal();
    }
  }
  const Eigen::VectorXd truth =
      Eigen::VectorXd::NullaryExpr(kUnknowns, [&] { return random.normal(); });
  const DenseProblem problem(kUnknowns, blocks, testing::linear(a, a * truth));
  const auto solution =
      solve_least_squares(problem, zeros(kUnknowns), {.residual_resolution = 1e-14});
  ASSERT_TRUE(solution.ok());
  EXPECT_LT((solution.x - truth).norm(), 1e-11);
}

TEST(LeastSquares, DampsWhereGaussNewtonOvershoots) {
  const DenseProblem rosenbrock(2, 2, [](const auto& x, auto& r, auto& J) {
    r << 10.0 * (x(1) - x(0) * x(0)), 1.0 - x(0);
    J << -20.0 * x(0), 10.0, -1.0, 0.0;
  });
  const auto solution =
      solve_least_squares(rosenbrock, Eigen::Vector2d(-1.2, 1.0), {.residual_resolution = 1e-15});
  ASSERT_TRUE(solution.ok());
  EXPECT_LT((solution.x - Eigen::Vector2d(1, 1)).norm(), 1e-13);
}

TEST(LeastSquares, KeepsACostThatFallsFromTheStartToTheEnd) {
  const Bent bent(300, 8, 0.1);
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(8, 3.0);
  const DenseProblem problem = bent.problem(64);
  const auto solution = solve_least_squares(problem, start);
  ASSERT_TRUE(solution.ok());
  ASSERT_GE(solution.costs.size(), 3u);
  EXPECT_LE(static_cast<int>(solution.costs.size()), solution.iterations + 1);
  EXPECT_NEAR(solution.costs.front() / residuals_at(problem, start).squaredNorm(), 1.0, 1e-12);
  EXPECT_EQ(solution.costs.back(), solution.cost);
  for (std::size_t i = 1; i < solution.costs.size(); ++i)
    EXPECT_LE(solution.costs[i], solution.costs[i - 1]);
}

TEST(LeastSquares, MovesAlongTheManifoldOfTheProblem) {
  // The unit direction closest to a vector, by steps in its tangent plane.
  class Direction : public LeastSquaresProblem {
   public:
    [[nodiscard]] int unknown_count() const override { return 2; }
    [[nodiscard]] int block_count() const override { return 1; }
    [[nodiscard]] BlockShape shape(int) const override { return {3, 3, columns_}; }
    [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const override {
      struct Here : Evaluation {
        Eigen::Vector3d direction;
        void fill(int, const BlockRows& rows) const override {
          const Eigen::Matrix<double, 3, 2> basis = tangents(direction);
          const Eigen::Vector3d residual = direction - Eigen::Vector3d(1, -2, 2);
          for (Eigen::Index r = 0; r < 3; ++r) {
            rows.row(r)[0] = basis(r, 0);
            rows.row(r)[1] = basis(r, 1);
            rows.residual(r) = residual(r);
          }
        }
      };
      auto here = std::make_unique<Here>();
      here->direction = x;
      return here;
    }
    [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& x,
                                        const Eigen::VectorXd& step) const override {
      return (x + tangents(x) * step).normalized();
    }

   private:
    static Eigen::Matrix<double, 3, 2> tangents(const Eigen::Vector3d& d) {
      const Eigen::Vector3d other =
          std::abs(d.x()) < 0.7 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
      const Eigen::Vector3d first = d.cross(other).normalized();
      return (Eigen::Matrix<double, 3, 2>() << first, d.cross(first)).finished();
    }
    std::vector<int> columns_ = {0, 1};
  };
  const auto solution = solve_least_squares(Direction(), Eigen::Vector3d(0, 0, 1));
  ASSERT_TRUE(solution.ok());
  EXPECT_LT((solution.x - Eigen::Vector3d(1, -2, 2) / 3.0).norm(), 1e-7);
  EXPECT_NEAR(solution.cost, 4.0, 1e-12);
}

TEST(LeastSquares, AvoidsPointsWhereTheModelIsNotDefined) {
  // sqrt(x) = 0.1 from x = 4: the full step lands at a negative x.
  const DenseProblem problem(1, 1, [](const auto& x, auto& r, auto& J) {
    r(0) = std::sqrt(x(0)) - 0.1;
    J(0, 0) = 0.5 / std::sqrt(x(0));
  });
  const auto solution = solve_least_squares(problem, Eigen::VectorXd::Constant(1, 4.0),
                                            {.residual_resolution = 1e-16});
  ASSERT_TRUE(solution.ok());
  EXPECT_NEAR(solution.x(0), 0.01, 1e-15);
}

TEST(LeastSquares, KeepsDigitsOfAnIllConditionedProblem) {
  // A cubic through numbers around 10: condition number 5e8, residuals of order one.
  RandomStream random(4);
  Eigen::MatrixXd a(60, 4);
  for (Eigen::Index i = 0; i < 60; ++i) {
    const double t = 10.0 + static_cast<double>(i) / 600.0;
    for (int k = 0; k < 4; ++k) a(i, k) = std::pow(t, k);
  }
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(60, [&] { return random.normal(); });
  const auto solution = solve_least_squares(DenseProblem(4, 60, testing::linear(a, b)), zeros(4));
  ASSERT_TRUE(solution.ok());
  const Eigen::VectorXd expected = testing::solve_in_extended_precision(a, b).x;
  EXPECT_LT((solution.x - expected).norm() / solution.x.norm(), 1e-6);
  EXPECT_GT(solution.condition_number, 1e8);
}

// -- robust losses -----------------------------------------------------------------------------

// The x in [low, high] with the least cost, by ever finer grids.
template <class Cost>
double brute_force_minimum(const Cost& cost, double low, double high) {
  double best = low;
  while (high - low > 1e-9) {
    const double step = (high - low) / 1000.0;
    for (int i = 0; i <= 1000; ++i) {
      const double x = low + i * step;
      if (cost(x) < cost(best)) best = x;
    }
    low = best - 2.0 * step;
    high = best + 2.0 * step;
  }
  return best;
}

TEST(LeastSquares, FindsTheMinimumOfARobustLoss) {
  const Eigen::VectorXd data{{-0.3, 0.1, 0.2, -0.6, 0.9, 1.4, -1.1, 8.0, 30.0, 25.0}};
  for (const RobustLoss kind : {RobustLoss::huber, RobustLoss::cauchy}) {
    for (const Eigen::Index group : {1, 2}) {
      const auto cost = [&](double x) {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < data.size(); i += group) {
          const double squared = (data.segment(i, group).array() - x).square().sum();
          sum += robust_loss(kind, squared, 1.345).loss;
        }
        return sum;
      };
      const DenseProblem problem(1, {{data.size(), {0}, group}},
                                 testing::linear(Eigen::MatrixXd::Ones(data.size(), 1), data));
      const auto solution = solve_least_squares(problem, zeros(1), {.loss = kind});
      ASSERT_TRUE(solution.ok()) << to_string(solution.termination);
      const double expected = brute_force_minimum(cost, -5.0, 30.0);
      // The grid sees differences of the cost down to its rounding: x to the root of that.
      EXPECT_NEAR(solution.x(0), expected, 1e-6);
      EXPECT_NEAR(solution.cost, cost(expected), 1e-11);
    }
  }
}

TEST(LeastSquares, IsNotMovedByOutliersUnderARobustLoss) {
  Bent bent(3000, 8, 0.01);
  for (Eigen::Index i = 0; i < 3000; i += 25) bent.y(i) += 5.0;
  const Eigen::VectorXd truth = Eigen::VectorXd::LinSpaced(8, -0.5, 0.5);
  const auto plain = solve_least_squares(bent.problem(192), zeros(8));
  const auto robust = solve_least_squares(bent.problem(192), zeros(8),
                                          {.loss = RobustLoss::cauchy, .loss_scale = 0.02});
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(robust.ok());
  // 0.01 / sqrt(3000) per unit column, three deviations of several unknowns.
  EXPECT_LT((robust.x - truth).norm(), 5e-3);
  EXPECT_GT((plain.x - truth).norm(), 5e-2);
}

// -- every reason of termination ---------------------------------------------------------------

TEST(LeastSquares, SaysWhenItRanOutOfIterations) {
  const Bent bent(100, 5, 0.1);
  const auto solution = solve_least_squares(bent.problem(100), zeros(5), {.max_iterations = 1});
  EXPECT_EQ(solution.termination, Termination::iteration_limit);
  EXPECT_EQ(solution.iterations, 1);
  EXPECT_EQ(solution.inverse_factor.size(), 0);
  const auto none = solve_least_squares(bent.problem(100), zeros(5), {.max_iterations = 0});
  EXPECT_EQ(none.termination, Termination::iteration_limit);
  EXPECT_EQ(none.x, zeros(5));
}

TEST(LeastSquares, SaysWhenNoStepHelps) {
  // The Jacobian has the wrong sign: every step leads uphill.
  const DenseProblem problem(1, 1, [](const auto& x, auto& r, auto& J) {
    r(0) = x(0) + 1.0;
    J(0, 0) = -1.0;
  });
  const auto solution = solve_least_squares(problem, zeros(1));
  EXPECT_EQ(solution.termination, Termination::no_decrease);
  EXPECT_EQ(solution.x, zeros(1));
  EXPECT_EQ(solution.cost, 1.0);
}

TEST(LeastSquares, SaysWhenNoStepLeadsToADefinedPoint) {
  const DenseProblem problem(1, 1, [](const auto& x, auto& r, auto& J) {
    r(0) = x(0) == 0.0 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
    J(0, 0) = 1.0;
  });
  EXPECT_EQ(solve_least_squares(problem, zeros(1)).termination, Termination::no_decrease);
}

TEST(LeastSquares, SaysWhenTheModelIsNotDefinedAtTheStart) {
  for (const bool derivative : {false, true}) {
    const DenseProblem problem(1, 2, [derivative](const auto&, auto& r, auto& J) {
      r.setOnes();
      J.setOnes();
      (derivative ? J(1, 0) : r(1)) = std::numeric_limits<double>::quiet_NaN();
    });
    const auto solution = solve_least_squares(problem, zeros(1));
    EXPECT_EQ(solution.termination, Termination::not_finite);
    EXPECT_EQ(solution.iterations, 0);
  }
}

void expect_rank_deficient(const LeastSquaresProblem& problem) {
  const auto solution = solve_least_squares(problem, zeros(problem.unknown_count()));
  EXPECT_EQ(solution.termination, Termination::rank_deficient);
  EXPECT_TRUE(solution.x.allFinite());
  EXPECT_EQ(solution.condition_number, std::numeric_limits<double>::infinity());
  EXPECT_EQ(solution.inverse_factor.size(), 0);
}

TEST(LeastSquares, SaysWhenAColumnDependsOnTheOthers) {
  RandomStream random(2);
  Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(50, 4, [&] { return random.normal(); });
  const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(50, [&] { return random.normal(); });
  a.col(2) = 3.0 * a.col(0) - 1e-6 * a.col(1);
  expect_rank_deficient(DenseProblem(4, 50, testing::linear(a, b)));
  // Rounding of its own in every row does not make it independent.
  for (double& value : a.reshaped()) value *= 1.0 + 1e-15 * random.normal();
  expect_rank_deficient(DenseProblem(4, 50, testing::linear(a, b)));
}

TEST(LeastSquares, SaysWhenNoRowSeesAnUnknown) {
  const Eigen::MatrixXd a{{1.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}};
  expect_rank_deficient(DenseProblem(2, 3, testing::linear(a, Eigen::Vector3d(1, 1, 1))));
  expect_rank_deficient(DenseProblem(2, {{3, {0}}}, testing::linear(a, Eigen::Vector3d(1, 1, 1))));
}

TEST(LeastSquares, SaysWhenThereAreNoRowsOrTooFew) {
  expect_rank_deficient(DenseProblem(3, 0, testing::linear(Eigen::MatrixXd(0, 3), zeros(0))));
  expect_rank_deficient(DenseProblem(3, std::vector<DenseProblem::Block>{},
                                     testing::linear(Eigen::MatrixXd(0, 3), zeros(0))));
  RandomStream random(2);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(3, 5, [&] { return random.normal(); });
  expect_rank_deficient(DenseProblem(5, 3, testing::linear(a, Eigen::Vector3d(1, 2, 3))));
}

TEST(LeastSquares, IsContentWithoutUnknowns) {
  const DenseProblem problem(0, 2, [](const auto&, auto& r, auto&) { r << 3.0, 4.0; });
  const auto solution = solve_least_squares(problem, zeros(0));
  EXPECT_TRUE(solution.ok());
  EXPECT_EQ(solution.cost, 25.0);
}

TEST(LeastSquares, StopsAtTheResolutionOfExactData) {
  const Bent bent(200, 5, 0.0);
  const auto solution =
      solve_least_squares(bent.problem(64), zeros(5), {.residual_resolution = 1e-15});
  ASSERT_TRUE(solution.ok()) << to_string(solution.termination);
  EXPECT_LT((solution.x - Eigen::VectorXd::LinSpaced(5, -0.5, 0.5)).norm(), 1e-13);
}

// -- progress and interruption -----------------------------------------------------------------

TEST(LeastSquares, TellsHowFarItHasCome) {
  const Bent bent(100, 5, 0.1);
  std::vector<double> fractions;
  LeastSquaresOptions options;
  options.monitor.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.stage, "adjusting");
    fractions.push_back(progress.fraction);
  };
  const auto solution = solve_least_squares(bent.problem(100), zeros(5), options);
  ASSERT_TRUE(solution.ok());
  ASSERT_GE(fractions.size(), 2U);
  EXPECT_EQ(fractions.front(), 0.0);
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_LE(fractions.back(), 1.0);
}

// Asks for a stop, or throws, in its 20th block.
class Troubled : public DenseProblem {
 public:
  Troubled(const Bent& bent, std::function<void()> trouble)
      : DenseProblem(bent.problem(192)), trouble_(std::move(trouble)) {}
  [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const override {
    struct Watched : Evaluation {
      std::unique_ptr<Evaluation> inner;
      const Troubled& problem;
      explicit Watched(const Troubled& p) : problem(p) {}
      void fill(int block, const BlockRows& rows) const override {
        ++problem.filled;
        if (block == 20) problem.trouble_();
        inner->fill(block, rows);
      }
    };
    auto here = std::make_unique<Watched>(*this);
    here->inner = DenseProblem::at(x);
    return here;
  }
  mutable std::atomic<int> filled = 0;

 private:
  std::function<void()> trouble_;
};

TEST(LeastSquares, IsInterruptedWithinAPass) {
  const Bent bent(12000, 20, 0.01);
  for (const int threads : {1, 2}) {
    std::stop_source source;
    const Troubled problem(bent, [&] { source.request_stop(); });
    LeastSquaresOptions options;
    options.threads = threads;
    options.monitor.stop = source.get_token();
    EXPECT_THROW((void)solve_least_squares(problem, zeros(20), options), Interrupted);
    EXPECT_LT(problem.filled, problem.block_count());
  }
}

TEST(LeastSquares, LetsExceptionsOfTheProblemThrough) {
  const Bent bent(12000, 20, 0.01);
  for (const int threads : {1, 3}) {
    const Troubled problem(bent, [] { throw std::runtime_error("no such pose"); });
    EXPECT_THROW((void)solve_least_squares(problem, zeros(20), {.threads = threads}),
                 std::runtime_error);
  }
}

// -- what else can be asked at a point ---------------------------------------------------------

TEST(TriangularFactor, TellsTheSameRankAsTheJacobian) {
  RandomStream random(2);
  Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(500, 6, [&] { return random.normal(); });
  a.col(1) = a.col(4) - 0.5 * a.col(2);
  a.col(5).setZero();
  const DenseProblem problem(6, 500, testing::linear(a, zeros(500)));
  const std::vector<int> preference = {0, 1, 2, 3, 4, 5};
  const RankAnalysis expected = analyse_rank(a, preference);
  const RankAnalysis analysis = analyse_rank(triangular_factor(problem, zeros(6)), preference);
  EXPECT_EQ(analysis.rank, 4);
  EXPECT_EQ(analysis.basis, expected.basis);
  EXPECT_EQ(analysis.unseen, expected.unseen);
  ASSERT_EQ(analysis.dependent.size(), 1U);
  EXPECT_EQ(analysis.dependent[0].column, expected.dependent[0].column);
  EXPECT_LT((analysis.dependent[0].weights - expected.dependent[0].weights).norm(), 1e-12);
  EXPECT_NEAR(analysis.condition_number, expected.condition_number, 1e-12);
}

TEST(TriangularFactor, IsSquareEvenWithFewerRowsThanUnknowns) {
  const Eigen::MatrixXd a{{1.0, 2.0, 3.0}};
  const DenseProblem problem(3, 1, testing::linear(a, zeros(1)));
  const Eigen::MatrixXd r = triangular_factor(problem, zeros(3));
  ASSERT_EQ(r.rows(), 3);
  EXPECT_LT((r.transpose() * r - a.transpose() * a).norm(), 1e-14);
}

TEST(ResidualsAt, FollowTheBlocks) {
  const Bent bent(1000, 5, 0.1);
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 0.2);
  Eigen::VectorXd expected;
  Eigen::MatrixXd jacobian;
  bent.evaluate()(x, expected, jacobian);
  EXPECT_EQ(residuals_at(bent.problem(7), x), expected);
}

}  // namespace
}  // namespace armcal
