// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/small_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace armcal {
namespace {

// y = b1 * (1 - exp(-b2 * x)): NIST StRD Misra1a, certified values printed to 11 digits.
struct Misra1a {
  Eigen::VectorXd x{{77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8,
                     593.1, 689.1, 760.0}};
  Eigen::VectorXd y{{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01,
                     66.40, 75.47, 81.78}};
  [[nodiscard]] SmallProblem problem() const {
    SmallProblem p;
    p.residual_resolution = 1e-14;
    p.evaluate = [this](const Eigen::VectorXd& b, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
      const Eigen::ArrayXd decay = (-b(1) * x.array()).exp();
      r = b(0) * (1.0 - decay) - y.array();
      J.resize(x.size(), 2);
      J.col(0) = 1.0 - decay;
      J.col(1) = b(0) * x.array() * decay;
    };
    return p;
  }
};

TEST(SmallLeastSquares, ReachesThePublishedAnswerFromBothStarts) {
  const Misra1a data;
  for (const Eigen::Vector2d& start : {Eigen::Vector2d(500, 1e-4), Eigen::Vector2d(250, 5e-4)}) {
    const SmallSolution solution = solve_small_least_squares(data.problem(), start);
    ASSERT_TRUE(solution.ok());
    EXPECT_NEAR(solution.x(0) / 2.3894212918e2, 1.0, 1e-10);
    EXPECT_NEAR(solution.x(1) / 5.5015643181e-4, 1.0, 1e-10);
    const double variance = solution.residuals.squaredNorm() / 12.0;
    const auto cofactor = cofactor_matrix(solution.jacobian);
    ASSERT_TRUE(cofactor.has_value());
    EXPECT_NEAR(std::sqrt(variance * (*cofactor)(0, 0)) / 2.7070075241, 1.0, 1e-9);
    EXPECT_NEAR(std::sqrt(variance * (*cofactor)(1, 1)) / 7.2668688436e-6, 1.0, 1e-9);
  }
}

TEST(SmallLeastSquares, DampsWhereGaussNewtonOvershoots) {
  // Rosenbrock's valley.
  SmallProblem problem;
  problem.residual_resolution = 1e-14;
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r = Eigen::Vector2d(10.0 * (x(1) - x(0) * x(0)), 1.0 - x(0));
    J.resize(2, 2);
    J << -20.0 * x(0), 10.0, -1.0, 0.0;
  };
  const SmallSolution solution = solve_small_least_squares(problem, Eigen::Vector2d(-1.2, 1.0));
  ASSERT_TRUE(solution.ok());
  EXPECT_NEAR((solution.x - Eigen::Vector2d(1, 1)).norm(), 0.0, 1e-12);
}

TEST(SmallLeastSquares, TakesTheShortestStepWhenAColumnIsRedundant) {
  SmallProblem problem;
  problem.residual_resolution = 1e-14;
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r = Eigen::Vector2d(x(0) + x(1) - 2.0, 2.0 * (x(0) + x(1)) - 4.0);
    J.resize(2, 2);
    J << 1, 1, 2, 2;
  };
  const SmallSolution solution = solve_small_least_squares(problem, Eigen::Vector2d(0, 0));
  ASSERT_TRUE(solution.ok());
  EXPECT_NEAR(solution.x(0), 1.0, 1e-14);
  EXPECT_NEAR(solution.x(1), 1.0, 1e-14);
  EXPECT_FALSE(cofactor_matrix(solution.jacobian).has_value());
}

TEST(SmallLeastSquares, SaysWhenTheModelIsNotDefinedAtTheStart) {
  SmallProblem problem;
  problem.evaluate = [](const Eigen::VectorXd&, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r = Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
    J = Eigen::MatrixXd::Ones(1, 1);
  };
  EXPECT_EQ(solve_small_least_squares(problem, Eigen::VectorXd::Zero(1)).termination,
            SmallTermination::not_finite);
}

TEST(SmallLeastSquares, SaysWhenItRanOutOfIterations) {
  const Misra1a data;
  const auto solution = solve_small_least_squares(data.problem(), Eigen::Vector2d(500, 1e-4), 2);
  EXPECT_EQ(solution.termination, SmallTermination::iteration_limit);
}

TEST(SmallLeastSquares, SaysWhenNoStepHelps) {
  // The Jacobian has the wrong sign: every step leads uphill.
  SmallProblem problem;
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r = Eigen::VectorXd::Constant(1, x(0) + 1.0);
    J = Eigen::MatrixXd::Constant(1, 1, -1.0);
  };
  EXPECT_EQ(solve_small_least_squares(problem, Eigen::VectorXd::Zero(1)).termination,
            SmallTermination::no_decrease);
}

TEST(SmallLeastSquares, AvoidsPointsWhereTheModelIsNotDefined) {
  // sqrt(x) = 0.1 from x = 4: the full step lands at a negative x.
  SmallProblem problem;
  problem.residual_resolution = 1e-15;
  problem.evaluate = [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    r = Eigen::VectorXd::Constant(1, std::sqrt(x(0)) - 0.1);
    J = Eigen::MatrixXd::Constant(1, 1, 0.5 / std::sqrt(x(0)));
  };
  const SmallSolution solution =
      solve_small_least_squares(problem, Eigen::VectorXd::Constant(1, 4.0));
  ASSERT_TRUE(solution.ok());
  EXPECT_NEAR(solution.x(0), 0.01, 1e-14);
}

}  // namespace
}  // namespace armcal
