// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/derivative_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace armcal {
namespace {

template <typename Vector>
Vector example(const Vector& x) {
  Vector y(2);
  y(0) = sin(x(0)) * exp(x(1));
  y(1) = x(0) * x(0) * x(1);
  return y;
}

Eigen::MatrixXd exact(const Eigen::VectorXd& x) {
  Eigen::MatrixXd jacobian(2, 2);
  jacobian << std::cos(x(0)) * std::exp(x(1)), std::sin(x(0)) * std::exp(x(1)),  //
      2.0 * x(0) * x(1), x(0) * x(0);
  return jacobian;
}

TEST(DerivativeCheck, ComplexStepsAreExactToRounding) {
  const Eigen::VectorXd x = Eigen::Vector2d(0.7, -1.3);
  const auto jacobian = jacobian_by_complex_step(example<Eigen::VectorXcd>, x);
  EXPECT_LT(worst_relative_difference(jacobian, exact(x)), 1e-15);
}

TEST(DerivativeCheck, DifferencesReachTenDigits) {
  const Eigen::VectorXd x = Eigen::Vector2d(0.7, -1.3);
  const auto jacobian =
      jacobian_by_differences(example<Eigen::VectorXd>, x, Eigen::Vector2d(0.1, 0.1));
  EXPECT_LT(worst_relative_difference(jacobian, exact(x)), 1e-10);
}

TEST(DerivativeCheck, FindsAWrongEntry) {
  const Eigen::VectorXd x = Eigen::Vector2d(0.7, -1.3);
  Eigen::MatrixXd wrong = exact(x);
  wrong(1, 0) *= 1.0 + 1e-6;
  EXPECT_GT(worst_relative_difference(wrong, exact(x)), 1e-7);
  wrong(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GT(worst_relative_difference(wrong, exact(x)), 1e300);
}

}  // namespace
}  // namespace armcal
