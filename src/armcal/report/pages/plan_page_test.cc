// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/plan_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/verification_plan_report.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::words_of;

constexpr const char* kPlanCommand = "plan verification";

PlannedTest test_of(const std::string& name, const std::string& title, bool is_of_iso) {
  PlannedTest test;
  test.name = name;
  test.title = title;
  test.covers = "892 mm (51 % of the reach)";
  test.is_of_iso = is_of_iso;
  test.joint_coverage = Eigen::VectorXd::Constant(6, 0.5);
  test.joint_coverage(2) = 0.1;
  test.touches.resize(1);
  test.touches[0].encoder_rad = Eigen::VectorXd::Zero(6);
  test.touches[0].touch = {{300, 0, 100}, {0, 0, 1}};
  return test;
}

VerificationPlan plan_example() {
  VerificationPlan plan;
  plan.arm = testing::consistent_romer();
  plan.arm.name = "arm <7>";
  plan.arm.base_from_first_joint.translation_mm = {100.0, 0.0, 0.0};
  plan.wishes.bars_mm = {900.0, 1750.0};
  plan.wishes.lengths_mm = {200.0, 1000.0};
  plan.wishes.room.surroundings = {60.0, 0.0, -200.0};
  plan.reach_mm = 1463.0;
  PlannedTest spheres = test_of("probing", "ISO 10360-12 probing size and form", true);
  spheres.spheres = {{"near", {100.0, 0.0, 292.6}, {0, 0, 1}}};
  PlannedTest bars = test_of("volumetric_length", "B89.4.22 volumetric length", false);
  bars.seats = {{"far", {700, 0, 100}, {0, 0, 1}}};
  bars.bars = {{"1", {300, 0, 100}, {1200, 0, 100}, {900.0}},
               {"2", {-875, 200, 50}, {875, 200, 50}, {1750.0}}};
  plan.tests = {spheres, bars};
  plan.joint_coverage = spheres.joint_coverage;
  return plan;
}

Json document_of_example() { return document_of(kPlanCommand, json_result(plan_example())); }

TEST(VerificationPlanPage, ShowsPlacesBarsAndCoverage) {
  const Page page = page_in("en", document_of_example());
  EXPECT_EQ(page.subtitle, "arm <7>");
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("B89.4.22 volumetric length | 2 | 1750.0 | -875.0 | 200.0 | 50.0 | "
                               "875.0 | 200.0 | 50.0 | "));
  EXPECT_THAT(words, HasSubstr("| sphere | near | 100.0 | 0.0 | 292.6 | 0.00 | 0.00 | 1.00 | "));
  EXPECT_THAT(words, HasSubstr("ISO 10360-12 probing size and form | 1 | 50 | 50 | 10 | 50"));
}

TEST(VerificationPlanPage, DrawsEachStandardFromAboveAndFromTheSide) {
  const Page page = page_in("en", document_of_example());
  const auto iso = std::get<Figures>(section_of(page, "placement-1").blocks.at(0)).items;
  const auto asme = std::get<Figures>(section_of(page, "placement-2").blocks.at(0)).items;
  ASSERT_EQ(iso.size(), 2u);
  EXPECT_THAT(iso[0].svg, HasSubstr("probing (near)"));
  EXPECT_THAT(iso[0].svg, Not(HasSubstr("far seat")));
  EXPECT_THAT(asme[1].svg, HasSubstr("far seat"));
  EXPECT_THAT(asme[1].svg, HasSubstr("bar long"));
  // Above the first joint by a fifth of the reach: 50 above the middle of the drawing.
  EXPECT_THAT(iso[0].svg, HasSubstr("<circle class=\"mark\" cx=\"280.0\" cy=\"280.0\""));
  EXPECT_THAT(iso[1].svg, HasSubstr("<circle class=\"mark\" cx=\"280.0\" cy=\"230.0\""));
}

TEST(VerificationPlanPage, SpeaksChinese) {
  const std::string words = words_of(page_in("zh", document_of_example()));
  EXPECT_THAT(words, HasSubstr("ISO 10360-12 探测尺寸与形状"));
  EXPECT_THAT(words, HasSubstr("892 mm（臂展的 51 %）"));
  EXPECT_THAT(words, Not(HasSubstr("reach")));
}

TEST(VerificationPlanPage, HasTablesAloneWhereTheSurroundingsAreUnknown) {
  Json document = document_of_example();
  document.erase("surroundings");
  for (Json& test : document["tests"]) test.erase("standard");
  const Page page = page_in("en", document);
  EXPECT_EQ(section_of(page, "placement-1").title, "Where things go: all tests");
  EXPECT_TRUE(std::holds_alternative<Facts>(section_of(page, "placement-1").blocks.at(0)));
}

TEST(VerificationPlanPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_of_example());
}

}  // namespace
}  // namespace armcal
