// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/check_trend.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

// A check a week.
CheckTrend weekly(const std::vector<double>& values_mm, std::size_t baseline) {
  CheckTrend trend;
  trend.name = "length_error";
  trend.limit_mm = 0.05;
  trend.is_signed = true;
  trend.baseline = baseline;
  for (std::size_t i = 0; i < values_mm.size(); ++i) {
    const auto number = static_cast<std::int64_t>(i);
    trend.points.push_back({number + 1, 604800 * number, values_mm[i]});
  }
  return judged(trend);
}

TEST(CheckTrend, HasNoCentreLineBeforeItsBaseline) {
  const CheckTrend trend = weekly({0.01, 0.012, 0.011}, 4);
  EXPECT_FALSE(trend.limits.has_value());
  EXPECT_TRUE(trend.violations.empty());
  EXPECT_TRUE(trend.drift.has_value());
}

TEST(CheckTrend, JudgesLaterChecksByTheBaselineAlone) {
  const CheckTrend trend = weekly({0.010, 0.012, 0.010, 0.012, 0.011, 0.030}, 4);
  EXPECT_NEAR(trend.limits->center, 0.011, 1e-15);
  EXPECT_NEAR(trend.limits->sigma, 0.002 / kRangeOfTwo_sigma, 1e-15);
  ASSERT_EQ(trend.violations_now().size(), 1u);
  EXPECT_EQ(trend.violations_now()[0].rule, ControlRule::beyond_three_sigma);
}

TEST(CheckTrend, TellsOfTheLastCheckOnlyWhatIsNew) {
  const CheckTrend trend = weekly({0.010, 0.012, 0.010, 0.012, 0.030, 0.011}, 4);
  EXPECT_EQ(trend.violations.size(), 1u);
  EXPECT_TRUE(trend.violations_now().empty());
}

TEST(CheckTrend, ForeseesWhenADriftReachesTheLimit) {
  const CheckTrend trend = weekly({0.010, 0.013, 0.020, 0.024, 0.030, 0.034}, 4);
  // Some 5 um a week, 16 um to go.
  EXPECT_NEAR(trend.days_to_limit().value(), 22.0, 2.0);
  EXPECT_FALSE(weekly({0.010, 0.013, 0.009, 0.012, 0.010, 0.011}, 4).days_to_limit().has_value());
}

TEST(CheckTrend, ForeseesNothingThatHasHappened) {
  EXPECT_FALSE(weekly({0.010, 0.020, 0.030, 0.040, 0.051}, 4).days_to_limit().has_value());
  EXPECT_TRUE(weekly({0.010, 0.020, 0.030, 0.040, 0.049}, 4).days_to_limit().has_value());
}

TEST(CheckTrend, SmallerDeviationsLeadToNoLimit) {
  CheckTrend trend = weekly({0.034, 0.030, 0.024, 0.020, 0.013, 0.010}, 4);
  EXPECT_TRUE(trend.days_to_limit().has_value());  // a length error goes on to the other side
  trend.is_signed = false;
  EXPECT_FALSE(trend.days_to_limit().has_value());
}

}  // namespace
}  // namespace armcal
