// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/step_model.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/core/random.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/extended_precision.h"

namespace armcal {
namespace {

struct Linear {
  Eigen::MatrixXd a;
  Eigen::VectorXd r;

  [[nodiscard]] NormalEquations equations() const {
    Eigen::MatrixXd whole(a.rows(), a.cols() + 1);
    whole << a, r;
    return {whole.transpose() * whole, r.squaredNorm()};
  }
  [[nodiscard]] TriangularSystem triangular() const {
    Eigen::MatrixXd whole(a.rows(), a.cols() + 1);
    whole << a, r;
    triangularise(whole);
    const Eigen::Index n = a.cols();
    return {whole.topLeftCorner(n, n), whole.col(n).head(n)};
  }
  [[nodiscard]] StepModel model() const {
    return {equations(), [this] { return triangular(); }};
  }
};

Linear random_problem(std::uint64_t seed) {
  RandomStream random(seed);
  Linear problem;
  problem.a = Eigen::MatrixXd::NullaryExpr(40, 5, [&] { return random.normal(); });
  problem.a.col(3) *= 1e6;  // millimetres beside radians
  problem.r = Eigen::VectorXd::NullaryExpr(40, [&] { return random.normal(); });
  return problem;
}

// Powers of numbers around 10: the condition number of the scaled columns is about 5e8.
Linear powers() {
  RandomStream random(4);
  Linear problem;
  problem.a.resize(60, 4);
  for (Eigen::Index i = 0; i < 60; ++i) {
    const double t = 10.0 + static_cast<double>(i) / 600.0;
    for (int k = 0; k < 4; ++k) problem.a(i, k) = std::pow(t, k);
  }
  problem.r = Eigen::VectorXd::NullaryExpr(60, [&] { return random.normal(); });
  return problem;
}

TEST(StepModel, TakesTheBestStepWhereNothingLimitsIt) {
  const Linear problem = random_problem(1);
  const StepModel model = problem.model();
  EXPECT_FALSE(model.by_qr());
  const Eigen::VectorXd expected = shortest_solution(problem.a, -problem.r);
  const Eigen::VectorXd step = model.undamped().scaled.cwiseQuotient(model.scales());
  EXPECT_LT(((step - expected).array() / expected.array()).abs().maxCoeff(), 1e-13);
  const double decrease =
      problem.r.squaredNorm() - (problem.r + problem.a * expected).squaredNorm();
  EXPECT_NEAR(model.undamped().predicted_decrease, decrease, 1e-12);
}

TEST(StepModel, KeepsItsDigitsWhereNormalEquationsLoseThem) {
  const Linear problem = powers();
  const StepModel model = problem.model();
  ASSERT_TRUE(model.by_qr());
  ASSERT_TRUE(model.full_rank());
  const auto expected = testing::solve_in_extended_precision(problem.a, -problem.r);
  const Eigen::VectorXd step = model.undamped().scaled.cwiseQuotient(model.scales());
  // Rounding times the condition number; normal equations would keep no digit at all.
  EXPECT_LT(((step - expected.x).array() / step.array()).abs().maxCoeff(), 1e-6);

  const auto factor = model.inverse_factor();
  ASSERT_TRUE(factor.has_value());
  EXPECT_LT(
      (factor->rowwise().norm().cwiseQuotient(expected.deviations).array() - 1.0).abs().maxCoeff(),
      1e-6);
}

TEST(StepModel, TellsTheConditionNumberOfTheScaledColumns) {
  for (const Linear& problem : {random_problem(2), powers()}) {
    // One-sided Jacobi: small singular values keep their relative accuracy.
    const Eigen::VectorXd singular =
        singular_value_decomposition(problem.a *
                                     column_scales(problem.a).cwiseInverse().asDiagonal())
            .values;
    const double expected = singular(0) / singular(singular.size() - 1);
    EXPECT_NEAR(problem.model().condition_number() / expected, 1.0, 1e-6);
  }
}

TEST(StepModel, StaysWithinTheRadius) {
  for (const Linear& problem : {random_problem(3), powers()}) {
    StepModel model = problem.model();
    model.weigh_lengths(Eigen::VectorXd::LinSpaced(problem.a.cols(), 1.0, 3.0));
    double last_decrease = model.undamped().predicted_decrease;
    for (const double share : {0.5, 0.1, 1e-3, 1e-6}) {
      const double radius = share * model.undamped().length;
      const ModelStep step = model.step_within(radius, 0.0);
      EXPECT_NEAR(step.length / radius, 1.0, 0.11);
      EXPECT_GT(step.damping, 0.0);
      // What it predicts is what linear residuals do, to the rounding of a sum of products that
      // cancel: the longest step is 1e7 times the residuals.
      const Eigen::VectorXd moved =
          problem.r + problem.a * step.scaled.cwiseQuotient(model.scales());
      const double decrease = problem.r.squaredNorm() - moved.squaredNorm();
      EXPECT_NEAR(step.predicted_decrease, decrease, 1e-8 * problem.r.squaredNorm());
      EXPECT_LT(step.predicted_decrease, last_decrease);
      last_decrease = step.predicted_decrease;
    }
  }
}

TEST(StepModel, MinimisesAmongStepsOfItsLength) {
  // At the minimum on a sphere of weighted steps the gradient is along the normal of the sphere.
  const Linear problem = random_problem(6);
  StepModel model = problem.model();
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(5, 1.0, 3.0);
  model.weigh_lengths(weights);
  const ModelStep step = model.step_within(0.3 * model.undamped().length, 0.0);
  const Eigen::MatrixXd scaled = problem.a * model.scales().cwiseInverse().asDiagonal();
  const Eigen::VectorXd gradient = scaled.transpose() * (problem.r + scaled * step.scaled);
  const Eigen::VectorXd normal = weights.cwiseAbs2().cwiseProduct(step.scaled);
  EXPECT_NEAR(gradient.dot(normal) / (gradient.norm() * normal.norm()), -1.0, 1e-12);
}

TEST(StepModel, GivesTheShortestStepWhereColumnsDependOnOthers) {
  Linear problem = random_problem(7);
  problem.a.col(4) = problem.a.col(0) - 2.0 * problem.a.col(1);
  problem.a.col(2).setZero();
  const StepModel model = problem.model();
  EXPECT_FALSE(model.full_rank());
  EXPECT_FALSE(model.inverse_factor().has_value());
  EXPECT_EQ(model.condition_number(), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(model.undamped().scaled(2), 0.0, 1e-14);
  const Eigen::MatrixXd scaled = problem.a * model.scales().cwiseInverse().asDiagonal();
  const Eigen::VectorXd expected = shortest_solution(scaled, -problem.r);
  EXPECT_LT((model.undamped().scaled - expected).norm(), 1e-12);
  const ModelStep damped = model.step_within(0.1 * model.undamped().length, 0.0);
  EXPECT_TRUE(damped.scaled.allFinite());
  EXPECT_NEAR(damped.length / model.undamped().length, 0.1, 0.011);
}

TEST(StepModel, AsksForTheTriangleOnlyWhereItIsNeeded) {
  const Linear problem = random_problem(8);
  const auto never = []() -> TriangularSystem { throw std::logic_error("not needed"); };
  EXPECT_NO_THROW(StepModel(problem.equations(), never));
  EXPECT_THROW(StepModel(powers().equations(), never), std::logic_error);
}

}  // namespace
}  // namespace armcal
