// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace armcal {
namespace {

TEST(RandomStream, IsThePublishedGenerator) {
  // Random123 known-answer test (kat_vectors): philox4x32-10, counter 0, key 0
  // -> 6627e8d5 e169c58d bc57ac4c 9b00dbd8.
  RandomStream stream(0, 0);
  EXPECT_EQ(stream.bits(), 0xe169c58d6627e8d5u);
  EXPECT_EQ(stream.bits(), 0x9b00dbd8bc57ac4cu);
}

TEST(RandomStream, SameSeedSameNumbers) {
  RandomStream one(42, 7);
  RandomStream other(42, 7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one.bits(), other.bits());
}

TEST(RandomStream, SeedsAndStreamsDiffer) {
  EXPECT_NE(RandomStream(1, 0).bits(), RandomStream(2, 0).bits());
  EXPECT_NE(RandomStream(1, 0).bits(), RandomStream(1, 1).bits());
  EXPECT_NE(RandomStream(std::uint64_t{1} << 40, 0).bits(), RandomStream(0, 0).bits());
}

TEST(RandomStream, UniformAndNormalHaveTheirMoments) {
  RandomStream stream(3);
  const int n = 200000;
  double mean_uniform = 0.0;
  double mean = 0.0;
  double variance = 0.0;
  double fourth = 0.0;
  for (int i = 0; i < n; ++i) {
    mean_uniform += stream.uniform() / n;
    const double z = stream.normal();
    mean += z / n;
    variance += z * z / n;
    fourth += z * z * z * z / n;
  }
  // Five standard errors of each statistic.
  EXPECT_NEAR(mean_uniform, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(mean, 0.0, 5 * std::sqrt(1.0 / n));
  EXPECT_NEAR(variance, 1.0, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth, 3.0, 5 * std::sqrt(96.0 / n));
}

TEST(RandomStream, BelowCoversItsRangeEvenly) {
  RandomStream stream(5);
  std::vector<int> hits(7, 0);
  const int n = 70000;
  for (int i = 0; i < n; ++i) ++hits[stream.below(7)];
  for (const int h : hits) EXPECT_NEAR(h, n / 7, 5 * std::sqrt(n * (1.0 / 7) * (6.0 / 7)));
}

TEST(NormalDeviate, KnowsThePublishedQuantiles) {
  // Wichura 1988, section "test data"; and the everyday ones.
  EXPECT_NEAR(normal_deviate(0.25), -0.6744897501960817, 1e-15);
  EXPECT_NEAR(normal_deviate(0.001), -3.090232306167814, 1e-14);
  EXPECT_NEAR(normal_deviate(1e-20), -9.262340089798408, 1e-13);
  EXPECT_NEAR(normal_deviate(0.975), 1.959963984540054, 1e-14);
  EXPECT_EQ(normal_deviate(0.5), 0.0);
}

}  // namespace
}  // namespace armcal
