// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_plan_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "armcal/report/verification_plan_picture.h"
#include "armcal/report/verification_worksheet.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::degrees;
using ::testing::HasSubstr;
using ::testing::Not;

VerificationPlan small_verification_plan() {
  VerificationPlan plan;
  plan.arm = testing::consistent_romer();
  plan.arm.name = "arm <7> & \"8\"";
  plan.wishes.iso10360_12 = false;
  plan.wishes.bars_mm = {900.0, 1750.0};
  plan.reach_mm = 1463.0;
  PlannedTest test;
  test.name = "volumetric_length";
  test.title = "B89.4.22 volumetric length";
  test.covers = "one octant";
  test.bars = {{"1", {300, 0, 100}, {1200, 0, 100}, {900.0}},
               {"2", {-875, 200, 50}, {875, 200, 50}, {1750.0}}};
  PlannedTouch row;
  row.placement = 1;
  row.length_mm = 900.0;
  row.end = 'A';
  row.touch = {{300, 0, 100}, {0, 0, 1}};
  row.encoder_rad = degrees({0, 45, 90, 135, -0.25, 180});
  test.touches = {row};
  test.joint_coverage = Eigen::VectorXd::Constant(6, 0.5);
  plan.tests = {test};
  plan.joint_coverage = test.joint_coverage;
  return plan;
}

TEST(VerificationPlanReport, TellsWhereThingsGoAndWhatTheyCover) {
  const std::string text = text_result(small_verification_plan());
  EXPECT_THAT(text, HasSubstr("  bars of 900 and 1750 mm\n"));
  EXPECT_THAT(text, HasSubstr("volumetric_length: one octant"));
  EXPECT_THAT(text, HasSubstr("B89.4.22 volumetric length       1  50  50"));
  EXPECT_THAT(text, HasSubstr("900.0   300.0    0.0  100.0  1200.0    0.0  100.0"));
  const Json json = json_result(small_verification_plan());
  EXPECT_EQ(json["tests"][0]["bars"][1]["end_B_mm"][0], 875.0);
  EXPECT_EQ(json["tests"][0]["readings"][0]["end"], "A");
  EXPECT_FALSE(json["tests"][0]["readings"][0].contains("point"));
}

TEST(VerificationWorksheet, LeavesTheReadingsEmpty) {
  EXPECT_EQ(worksheet_csv(small_verification_plan()),
            "test,position,placement,articulation,repeat,length_mm,end,point,"
            "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,"
            "planned_q1_deg,planned_q2_deg,planned_q3_deg,planned_q4_deg,planned_q5_deg,"
            "planned_q6_deg,planned_x_mm,planned_y_mm,planned_z_mm\n"
            "volumetric_length,,1,,,900,A,,,,,,,,0,45,90,135,-0.25,180,300,0,100\n");
}

TEST(VerificationWorksheet, ForPeopleShowsOnlyTheColumnsOfATest) {
  EXPECT_THAT(
      worksheet_markdown(small_verification_plan()),
      HasSubstr("| placement | length_mm | end | q1 | q2 | q3 | q4 | q5 | q6 | x | y | z |\n"
                "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
                "| 1 | 900 | A | 0 | 45 | 90 | 135 | 0 | 180 | 300.0 | 0.0 | 100.0 |\n"));
}

TEST(VerificationPicture, IsDrawnToScaleAndEscapesNames) {
  const std::string svg = verification_picture(small_verification_plan());
  EXPECT_THAT(svg, HasSubstr("ASME B89.4.22: arm &lt;7&gt; &amp; &quot;8&quot;</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("<7>")));
  EXPECT_THAT(svg, Not(HasSubstr("ISO 10360-12")));
  // 250 for the reach: 300 mm are 51.3 from the middle of a view of 560.
  EXPECT_THAT(svg, HasSubstr("<line class=\"bar\" x1=\"331.3\" y1=\"280.0\" x2=\"485.1\""));
  EXPECT_THAT(svg, HasSubstr("<line class=\"bar long\""));
}

}  // namespace
}  // namespace armcal
