// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/comparison_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/comparison_cells.h"
#include "armcal/report/paper_sphere_report.h"
#include "armcal/report/session_comparison_report.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Comparison drawn_comparison() {
  Comparison comparison{*scenario_named("romer"), 5, 3, 0.0154, {}};
  ComparisonRow good{.name = "cmm",
                     .title = "least squares",
                     .reference = "Somebody 2007",
                     .needs = "a machine",
                     .readings = 120,
                     .arms = 3};
  good.score = {0.004, 0.0037, 0.008, 0.0032, 1.04, 63, 61};
  good.condition_number = 7.7;
  good.seconds = 0.0031;
  ComparisonRow partly = good;
  partly.name = "bar";
  partly.title = "ball bar";
  partly.arms = 2;
  partly.problem = "out of reach";
  ComparisonRow never{.name = "chain", .title = "chain", .problem = "for six joints"};
  comparison.rows = {good, partly, never};
  return comparison;
}

TEST(ComparisonReport, HasARowForEveryMethodAndReasonsForThoseThatFailed) {
  const std::string text = text_result(drawn_comparison());
  EXPECT_THAT(text, HasSubstr("medians over 3 arms (seeds 5 to 7)"));
  EXPECT_THAT(text, HasSubstr("0.0040   0.0037  0.0080     0.0032     1.04    61/63"));
  EXPECT_THAT(text, HasSubstr("1 of 3 arms failed: out of reach"));
  EXPECT_THAT(text, HasSubstr("for six joints"));
  EXPECT_THAT(text, HasSubstr("0.0154 mm"));
}

TEST(ComparisonReport, IsATableOfAPageAndJson) {
  EXPECT_THAT(markdown_result(drawn_comparison()),
              HasSubstr("| least squares | 120 | 0.0040 | 0.0037 | 0.0080 | 0.0032 | 1.04 | 61/63 "
                        "| 8 | 0.0031 s | |\n"));
  const Json json = json_result(drawn_comparison());
  EXPECT_EQ(json["scenario"], "romer");
  ASSERT_EQ(json["methods"].size(), 3u);
  EXPECT_EQ(json["methods"][0]["inside"], 61);
  EXPECT_FALSE(json["methods"][0].contains("problem"));
  EXPECT_EQ(json["methods"][1]["problem"], "out of reach");
  EXPECT_FALSE(json["methods"][2].contains("point_rms_mm"));
}

TEST(ComparisonReport, OfASessionSaysWhereItWasSplit) {
  SessionComparison comparison{.arm_name = "arm", .fitted = 70, .held_out = 30, .rows = {}};
  SessionComparisonRow row{.name = "ls", .title = "least squares", .parameters = 21};
  row.fitted = RowFigures{{70, 0.01, 0.009, 0.02}, 1.0};
  row.held_out = RowFigures{{30, 0.011, 0.01, 0.021}, 1.1};
  comparison.rows = {row};
  EXPECT_THAT(text_result(comparison), Not(HasSubstr("holds nothing out")));
  comparison.split_here = true;
  EXPECT_THAT(text_result(comparison), HasSubstr("30 held out (here: the session holds nothing"));
  EXPECT_EQ(json_result(comparison)["methods"][0]["held_out"]["rms_mm"], 0.011);
  EXPECT_THAT(markdown_result(comparison), HasSubstr("| least squares | 21 | | 0.0100 | 0.0110 |"));
}

TEST(ComparisonReport, OfThePapersSphereSaysWhichEffectsReachItsError) {
  NeglectedEffect effect{"twists", "0.025 deg", 400, {}, {}};
  effect.one_articulation = {0.002, 0.01, 0.0, 0.01};
  effect.five_articulations = {0.16, 0.9, 0.8, 0.5};
  const std::vector<NeglectedEffect> effects = {effect};
  EXPECT_THAT(text_result(effects), HasSubstr("80.0 %"));
  const Json json = json_result(effects);
  EXPECT_FALSE(json["effects"][0]["one_articulation"]["explains_the_paper"].get<bool>());
  EXPECT_TRUE(json["effects"][0]["five_articulations"]["explains_the_paper"].get<bool>());
}

TEST(ComparisonCells, ShowNoMoreDigitsThanAreTrue) {
  EXPECT_EQ(seconds_cell(0.0031), "0.0031 s");
  EXPECT_EQ(seconds_cell(0.58), "0.58 s");
  EXPECT_EQ(seconds_cell(12.3), "12 s");
  EXPECT_EQ(error_cell(0.00421), "0.0042");
  EXPECT_EQ(error_cell(174.756), "174.76");
  EXPECT_EQ(ratio_cell(1.044), "1.04");
  EXPECT_EQ(ratio_cell(46.3), "46");
  EXPECT_EQ(condition_cell(7.7), "8");
  EXPECT_EQ(condition_cell(1.3e16), "1e+16");
  EXPECT_EQ(condition_cell(std::nullopt), "");
}

}  // namespace
}  // namespace armcal
