// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/blunders.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(Blunders, SpoilTheStatedShareByTheStatedSize) {
  RandomStream random(1);
  int spoilt = 0;
  constexpr int kReadings = 10000;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < kReadings; ++i) {
    const Eigen::Vector3d off = drawn_blunder({.share = 0.1, .size_mm = 0.5}, random);
    if (off.isZero(0.0)) continue;
    EXPECT_NEAR(off.norm(), 0.5, 1e-12);
    sum += off;
    ++spoilt;
  }
  // Binomial, 4 standard deviations; directions favour none.
  EXPECT_NEAR(spoilt, 1000, 120);
  EXPECT_LT(sum.norm() / spoilt, 0.06);
}

TEST(Blunders, OfALargerShareAreTheSameAndMore) {
  RandomStream few(1);
  RandomStream many(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d rare = drawn_blunder({.share = 0.02, .size_mm = 0.1}, few);
    const Eigen::Vector3d frequent = drawn_blunder({.share = 0.2, .size_mm = 0.1}, many);
    EXPECT_TRUE(rare.isZero(0.0) || frequent == rare);
  }
}

}  // namespace
}  // namespace armcal
