// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/robust_loss.h"

#include <gtest/gtest.h>

#include <cmath>

namespace armcal {
namespace {

constexpr double kScale = 1.5;

TEST(RobustLoss, IsTheSquareForSmallResiduals) {
  for (const RobustLoss kind : {RobustLoss::none, RobustLoss::huber, RobustLoss::cauchy}) {
    // Cauchy: k^2 log(1 + s/k^2) = s - s^2 / (2 k^2) ...
    EXPECT_NEAR(robust_loss(kind, 1e-8, kScale).loss / 1e-8, 1.0, 1e-8);
    EXPECT_NEAR(robust_loss(kind, 1e-8, kScale).weight, 1.0, 1e-8);
    EXPECT_EQ(robust_loss(kind, 0.0, kScale).loss, 0.0);
  }
}

TEST(RobustLoss, HasTheDerivativeOfTheLossForItsWeight) {
  const double h = 1e-5;
  for (const RobustLoss kind : {RobustLoss::none, RobustLoss::huber, RobustLoss::cauchy}) {
    for (const double squared : {0.5, 2.0, 3.0, 100.0, 1e4}) {
      const double slope = (robust_loss(kind, squared + h, kScale).loss -
                            robust_loss(kind, squared - h, kScale).loss) /
                           (2.0 * h);
      // Central differences: rounding of a loss of up to 1e4 over 2e-5.
      EXPECT_NEAR(robust_loss(kind, squared, kScale).weight, slope, 2e-7) << squared;
    }
  }
}

TEST(RobustLoss, GrowsWithTheLengthAndWithItsLogarithm) {
  // Huber: 2 k s - k^2.  Cauchy: k^2 log(1 + s^2/k^2).
  EXPECT_NEAR(robust_loss(RobustLoss::huber, 100.0, kScale).loss, 30.0 - 2.25, 1e-13);
  EXPECT_NEAR(robust_loss(RobustLoss::cauchy, 100.0, kScale).loss,
              2.25 * std::log(1.0 + 100.0 / 2.25), 1e-13);
}

TEST(RobustLoss, IsSmoothAtHubersKnee) {
  const double below = kScale * kScale * (1.0 - 1e-12);
  const double above = kScale * kScale * (1.0 + 1e-12);
  const LossAndWeight a = robust_loss(RobustLoss::huber, below, kScale);
  const LossAndWeight b = robust_loss(RobustLoss::huber, above, kScale);
  EXPECT_NEAR(a.loss, b.loss, 1e-11);
  EXPECT_NEAR(a.weight, b.weight, 1e-11);
}

}  // namespace
}  // namespace armcal
