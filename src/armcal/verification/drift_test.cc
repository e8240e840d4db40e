// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/drift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "armcal/core/random.h"

namespace armcal {
namespace {

TEST(Drift, FollowsAStraightLineExactly) {
  std::vector<TimedValue> history;
  for (const double day : {0.0, 7.0, 15.0, 21.0}) history.push_back({day, 0.010 + 0.001 * day});
  const Drift drift = drift_of(history).value();
  EXPECT_NEAR(drift.mm_per_day, 0.001, 1e-15);
  EXPECT_NEAR(drift.u_mm_per_day, 0.0, 1e-15);
  EXPECT_NEAR(drift.now_mm, 0.031, 1e-15);
  EXPECT_TRUE(drift.is_significant);
  EXPECT_NEAR(drift.days_to(0.050).value(), 19.0, 1e-9);
  EXPECT_EQ(drift.days_to(0.020).value(), 0.0);  // is beyond it already
}

TEST(Drift, AgreesWithACaseComputedByHand) {
  // Times -1 0 1, values 1 2 2: slope 1/2, residuals -1/6 1/3 -1/6, sum of squares 1/6, one degree
  // of freedom, u = sqrt(1/6 / 2).
  const std::vector<TimedValue> history = {{-1.0, 1.0}, {0.0, 2.0}, {1.0, 2.0}};
  const Drift drift = drift_of(history).value();
  EXPECT_NEAR(drift.mm_per_day, 0.5, 1e-15);
  EXPECT_NEAR(drift.u_mm_per_day, std::sqrt(1.0 / 12.0), 1e-15);
  EXPECT_NEAR(drift.now_mm, 5.0 / 3.0 + 0.5, 1e-15);
  EXPECT_FALSE(drift.is_significant);  // t = 1.73, Student asks for 12.7
}

TEST(Drift, IsTheSameFromAnyOrigin) {
  const std::vector<TimedValue> early = {{0.0, 1.0}, {3.0, 2.0}, {4.0, 2.5}, {9.0, 2.0}};
  std::vector<TimedValue> late = early;
  for (TimedValue& each : late) each.time_days += 20000.0;
  EXPECT_NEAR(drift_of(late)->mm_per_day, drift_of(early)->mm_per_day, 1e-12);
  EXPECT_NEAR(drift_of(late)->now_mm, drift_of(early)->now_mm, 1e-12);
}

TEST(Drift, GoesToTheLimitOfItsSide) {
  const std::vector<TimedValue> history = {{0.0, 0.02}, {1.0, 0.01}, {2.0, 0.0}};
  EXPECT_NEAR(drift_of(history)->days_to(0.05).value(), 5.0, 1e-9);
  const std::vector<TimedValue> level = {{0.0, 0.02}, {1.0, 0.02}, {2.0, 0.02}};
  EXPECT_FALSE(drift_of(level)->days_to(0.05).has_value());
  EXPECT_FALSE(drift_of(level)->is_significant);
}

TEST(Drift, IsFoundInOneOfTwentyHistoriesWithout) {
  constexpr int kHistories = 2000;
  int significant = 0;
  double squares = 0.0;
  for (int k = 0; k < kHistories; ++k) {
    RandomStream random(5, static_cast<std::uint64_t>(k));
    std::vector<TimedValue> history;
    for (int i = 0; i < 12; ++i) history.push_back({7.0 * i, random.normal()});
    const Drift drift = drift_of(history).value();
    significant += drift.is_significant ? 1 : 0;
    squares += std::pow(drift.mm_per_day, 2) / kHistories;
  }
  // Binomial: standard deviation sqrt(0.05 * 0.95 / 2000) = 0.5 %, four of them.
  EXPECT_NEAR(significant / double{kHistories}, 0.05, 0.02);
  // Variance of the slope: 1 / sum of squares of the times about their mean, 49 * 143.
  EXPECT_NEAR(squares * 49.0 * 143.0, 1.0, 4.0 * std::sqrt(2.0 / kHistories));
}

TEST(Drift, NeedsThreeValuesAtTwoTimes) {
  EXPECT_FALSE(drift_of(std::vector<TimedValue>{{0.0, 1.0}, {1.0, 1.0}}).has_value());
  EXPECT_FALSE(drift_of(std::vector<TimedValue>{{2.0, 1.0}, {2.0, 1.1}, {2.0, 1.2}}).has_value());
}

}  // namespace
}  // namespace armcal
