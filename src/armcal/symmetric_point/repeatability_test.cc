// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/repeatability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/core/random.h"

namespace armcal {
namespace {

Reduction reading_with(double s_mm, int count = 5) {
  Reduction reduction;
  reduction.end_a = EndStatistics{count, Eigen::Vector3d::Zero(), s_mm};
  reduction.end_b = EndStatistics{count, Eigen::Vector3d::Zero(), s_mm};
  reduction.u_type_a = s_mm * std::sqrt(2.0 / count);
  return reduction;
}

// Half turns of a machine that scatters by 8 um.
std::vector<Reduction> readings(int count, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Reduction> all;
  for (int i = 0; i < count; ++i) {
    double variance = 0.0;
    for (int k = 0; k < 8; ++k) variance += std::pow(0.008 * random.normal(), 2) / 8.0;
    all.push_back(reading_with(std::sqrt(variance)));
  }
  return all;
}

TEST(Repeatability, OfManyReadingsIsKnownBetterThanOfOne) {
  auto all = readings(40, 1);
  share_repeatability(all);
  for (const Reduction& each : all) {
    // Median of 40 variances of 8 degrees of freedom: 5 % of the standard deviation.
    EXPECT_NEAR(each.u_type_a, 0.008 * std::sqrt(0.4), 0.15 * 0.008 * std::sqrt(0.4));
    EXPECT_EQ(each.u_type_a, all.front().u_type_a);
  }
}

TEST(Repeatability, AReadingThatScattersFarMoreKeepsItsOwn) {
  auto all = readings(20, 2);
  all[7] = reading_with(0.1);
  auto without = readings(20, 2);
  share_repeatability(all);
  share_repeatability(without);
  EXPECT_NEAR(all[7].u_type_a, 0.1 * std::sqrt(0.4), 1e-12);
  EXPECT_NEAR(all[3].u_type_a / without[3].u_type_a, 1.0, 0.15);  // the others hardly notice
}

TEST(Repeatability, FollowsTheNumberOfRepeats) {
  auto all = readings(20, 3);
  all[5].end_b->count = 20;
  share_repeatability(all);
  EXPECT_NEAR(all[5].u_type_a / all[4].u_type_a, std::sqrt((0.2 + 0.05) / 0.4), 1e-12);
}

// An arm that gives way scatters more with a longer lever: then there is no one spread.
TEST(Repeatability, LeavesSpreadsAloneThatDiffer) {
  auto all = readings(20, 5);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double lever = 0.3 + 0.1 * static_cast<double>(i);
    all[i].end_a->s_mm *= lever;
    all[i].end_b->s_mm *= lever;
    all[i].u_type_a *= lever;
  }
  const auto before = all;
  share_repeatability(all);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].u_type_a, before[i].u_type_a);
}

TEST(Repeatability, LeavesFewReadingsAlone) {
  auto two = readings(2, 4);
  const double before = two[0].u_type_a;
  share_repeatability(two);
  EXPECT_EQ(two[0].u_type_a, before);
  std::vector<Reduction> none(3);
  share_repeatability(none);
  EXPECT_EQ(none[0].u_type_a, 0.0);
}

}  // namespace
}  // namespace armcal
