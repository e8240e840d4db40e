// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/half_turn_plan_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::degrees;
using ::testing::HasSubstr;

HalfTurnPlan small_half_turn_plan() {
  HalfTurnPlan plan;
  plan.arm = testing::consistent_romer();
  plan.unknowns = {1, 2};
  plan.parameters = {{"b3", false, 0.0012}, {"zero2", true, radians_from_arcseconds(0.5)}};
  plan.covariance = Eigen::Matrix2d::Identity();
  plan.condition_number = 6.7;
  plan.length_error_mm = 0.0031;
  plan.joints_set = 2;
  plan.candidates = 4000;
  plan.readings = {{"h01",
                    {1, degrees({90, 0, 45, 0, 0, 0}), degrees({-90, 0, 45, 0, 0, 0})},
                    1742.396,
                    0.006,
                    0.351,
                    0.042,
                    0.076},
                   {"h02",
                    {2, degrees({-90, 0, 45, 22.5, 90, 0}), degrees({-90, 180, 45, 22.5, 90, 0})},
                    93.91,
                    0.005,
                    0.4,
                    0.033,
                    std::numeric_limits<double>::infinity()}};
  return plan;
}

TEST(HalfTurnPlanReport, TellsAnOperatorWhatToDo) {
  const std::string text = text_result(small_half_turn_plan());
  EXPECT_THAT(text, HasSubstr("rms error of a length between two random tip positions 0.0031 mm"));
  EXPECT_THAT(text, HasSubstr("h01      q1      90  -90   90   0  45"));
  EXPECT_THAT(text, HasSubstr("1742.396"));
  EXPECT_THAT(text, HasSubstr("q4 0 -> 22.5, q5 0 -> 90"));
  EXPECT_THAT(text, HasSubstr("zero2        0.50  arcsec"));
}

TEST(HalfTurnPlanReport, WorksheetsHaveOneRowForEachReading) {
  const std::string csv = worksheet_csv(small_half_turn_plan());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THAT(csv, HasSubstr(",\"q4 0 -> 22.5, q5 0 -> 90\"\n"));
  EXPECT_THAT(worksheet_markdown(small_half_turn_plan()),
              HasSubstr("\n| h02 | q2 | 0 | 180 | -90 |"));
}

// What nothing names is no number: neither in the table nor in JSON.
TEST(HalfTurnPlanReport, AnErrorThatIsNeverNamedIsNull) {
  EXPECT_TRUE(json_result(small_half_turn_plan())["readings"][1]["smallest_named_mm"].is_null());
  EXPECT_EQ(text_result(small_half_turn_plan()).find("inf"), std::string::npos);
}

}  // namespace
}  // namespace armcal
