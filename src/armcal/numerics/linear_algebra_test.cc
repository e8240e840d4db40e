// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/linear_algebra.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(ShortestSolution, ChoosesTheLeastNormAmongEqualAnswers) {
  Eigen::MatrixXd a(2, 2);
  a << 1, 1, 2, 2;
  const Eigen::VectorXd x = shortest_solution(a, Eigen::Vector2d(2, 4));
  EXPECT_NEAR(x(0), 1.0, 1e-14);
  EXPECT_NEAR(x(1), 1.0, 1e-14);
}

TEST(InverseFactor, KeepsItsDigitsOnBadlyScaledColumns) {
  Eigen::MatrixXd a(3, 2);
  a << 1e9, 1e-6, 2e9, 3e-6, 3e9, 7e-6;
  const auto factor = inverse_factor(a);
  ASSERT_TRUE(factor.has_value());
  const Eigen::MatrixXd inverse = *factor * factor->transpose();
  // A^T A = [14e18 28e3; 28e3 59e-12], determinant 42e6.
  EXPECT_NEAR(inverse(0, 0) / (59e-12 / 42e6), 1.0, 1e-13);
  EXPECT_NEAR(inverse(1, 1) / (14e18 / 42e6), 1.0, 1e-13);
  EXPECT_NEAR(inverse(0, 1) / (-28e3 / 42e6), 1.0, 1e-13);
}

TEST(InverseFactor, RefusesWhatHasNoInverse) {
  EXPECT_FALSE(inverse_factor(Eigen::MatrixXd::Ones(3, 2)).has_value());
  EXPECT_FALSE(inverse_factor(Eigen::MatrixXd::Ones(1, 2)).has_value());
  EXPECT_FALSE(inverse_factor(Eigen::MatrixXd::Zero(3, 1)).has_value());
}

TEST(SingularValueDecomposition, RebuildsTheMatrix) {
  Eigen::MatrixXd a(2, 3);
  a << 3, 2, 2, 2, 3, -2;
  const auto svd = singular_value_decomposition(a);
  EXPECT_NEAR(svd.values(0), 5.0, 1e-14);  // the textbook example: singular values 5 and 3
  EXPECT_NEAR(svd.values(1), 3.0, 1e-14);
  EXPECT_NEAR((svd.u * svd.values.asDiagonal() * svd.v.transpose() - a).norm(), 0.0, 1e-14);
}

}  // namespace
}  // namespace armcal
