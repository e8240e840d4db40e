// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/trend_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/report/check_report.h"
#include "armcal/testing/weekly_checks.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A check a week from 2026-01-05 on.
TEST(TrendChart, MarksEveryCheckBetweenItsLimits) {
  // 41 columns from one limit to the other, 0.0025 mm each: 0 is column 20, the centre 0.005 is 22;
  // sigma 0.01 / 1.128, so 3 sigma lie at -0.0216 and 0.0316, columns 11 and 33.
  EXPECT_THAT(trend_chart(testing::weekly_checks({0.00, 0.01, 0.00, 0.01, 0.04})),
              ::testing::StartsWith(
                  "  check  date            mm\n"
                  "      1  2026-01-05  0.0000  [          :        * |          :      ]\n"
                  "      2  2026-01-12  0.0100  [          :          | *        :      ]\n"
                  "      3  2026-01-19  0.0000  [          :        * |          :      ]\n"
                  "      4  2026-01-26  0.0100  [          :          | *        :      ]\n"
                  "      5  2026-02-02  0.0400  [          :          |          :  #   ]\n"));
}

TEST(TrendChart, NamesBrokenRulesInWords) {
  const std::string chart =
      trend_chart(testing::weekly_checks({0.010, 0.012, 0.010, 0.012, 0.030}));
  EXPECT_THAT(chart, HasSubstr("#"));
  EXPECT_THAT(chart,
              HasSubstr("check 5: 1 check more than 3 sigma above the centre line (rule 1)"));
}

TEST(TrendChart, ShowsTheLastChecksOnly) {
  const std::string chart = trend_chart(
      testing::weekly_checks(std::vector<double>{0.010, 0.012, 0.010, 0.012, 0.011, 0.012}), 2);
  EXPECT_THAT(chart, Not(HasSubstr("2026-01-26")));
  EXPECT_THAT(chart, HasSubstr("2026-02-02"));
}

TEST(TrendChart, WaitsForItsBaseline) {
  EXPECT_THAT(trend_chart(testing::weekly_checks({0.010, 0.012})),
              HasSubstr("a centre line comes with 4 checks; 2 so far"));
}

TEST(TrendChart, ShowsOneCheckAndEqualOnes) {
  EXPECT_THAT(trend_chart(testing::weekly_checks({0.010})), HasSubstr("*"));
  EXPECT_THAT(trend_chart(testing::weekly_checks({0.01, 0.01, 0.01, 0.01, 0.01})),
              Not(HasSubstr("#")));
}

TEST(CheckWarnings, TellOfRulesAndDriftAtTheLastCheck) {
  const auto warnings =
      warnings_of(testing::weekly_checks({0.010, 0.013, 0.020, 0.024, 0.030, 0.034}));
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings.back(), HasSubstr("length error: drifts by +0.0"));
  EXPECT_THAT(warnings.back(), HasSubstr("is at its limit in"));
  EXPECT_TRUE(
      warnings_of(testing::weekly_checks({0.010, 0.013, 0.009, 0.012, 0.010, 0.011})).empty());
}

}  // namespace
}  // namespace armcal
