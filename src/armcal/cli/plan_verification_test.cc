// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::tool;

std::vector<std::string> plan(const std::vector<std::string>& more,
                              const std::string& arm = "seven-joint.arm.toml") {
  std::vector<std::string> line = {"plan", "verification", example("arms/" + arm)};
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

TEST(PlanVerificationCommand, PlansTheTestsOfBothStandards) {
  const auto result = tool(plan({"--bench", "-200", "--column-radius", "60", "--json"}));
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  ASSERT_EQ(json["tests"].size(), 6u);
  EXPECT_EQ(json["tests"][0]["name"], "probing");
  EXPECT_EQ(json["tests"][0]["spheres"].size(), 2u);
  EXPECT_EQ(json["tests"][2]["bars"].size(), 7u);
  EXPECT_EQ(json["tests"][5]["readings"].size(), 40u);
  EXPECT_EQ(json["seed"], 1);
}

// What an operator does with it: the angles of the plan go where the encoders' readings belong.
std::string filled_in(std::string sheet, int joints) {
  for (int j = 1; j <= joints; ++j) {
    const std::string q = "q" + std::to_string(j) + "_deg";
    sheet.replace(sheet.find("," + q), q.size() + 1, ",unused" + std::to_string(j));
    sheet.replace(sheet.find("planned_" + q), q.size() + 8, q);
  }
  return sheet;
}

TEST(PlanVerificationCommand, PutsTheAnglesWhereTheTipIsSaidToBe) {
  const TemporaryFolder folder;
  const std::string sheet = folder.path("sheet.csv");
  const auto planned = tool(plan({"--standard", "b89.4.22", "--worksheet", sheet, "--json"}));
  ASSERT_EQ(planned.code, kDone) << planned.err;
  const std::string arm = example("arms/seven-joint.arm.toml");
  EXPECT_EQ(tool({"fk", arm, sheet}).code, kWrongInput);  // a plan is no reading
  const std::string filled = folder.path("filled.csv");
  std::ofstream(filled, std::ios::binary) << filled_in(testing::read_bytes(sheet), 7);
  const auto tips = tool({"fk", arm, filled, "--json"});
  ASSERT_EQ(tips.code, kDone) << tips.err;
  std::size_t row = 0;
  const Json plan_json = planned.json();
  const Json tips_json = tips.json();
  for (const auto& test : plan_json["tests"]) {
    for (const auto& reading : test["readings"]) {
      const auto& tip = tips_json["tips_mm"][row++];
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(tip[i].get<double>(), reading["tip_mm"][i].get<double>(), 1e-6);
      }
    }
  }
  EXPECT_EQ(row, 97u);  // 27 on the sphere, 30 in seats, 40 at ends of bars
}

TEST(PlanVerificationCommand, TheSeedDecides) {
  const std::vector<std::string> few = {"--standard", "b89.4.22"};
  const auto one = tool(plan(few));
  EXPECT_EQ(one.out, tool(plan(few)).out);
  EXPECT_NE(one.out, tool(plan({"--standard", "b89.4.22", "--seed", "2"})).out);
}

TEST(PlanVerificationCommand, WritesWorksheetAndPicture) {
  const TemporaryFolder folder;
  const std::string sheet = folder.path("sheet.md");
  const std::string picture = folder.path("plan.svg");
  const std::vector<std::string> flags = {"--standard", "b89.4.22",  "--worksheet",
                                          sheet,        "--picture", picture};
  EXPECT_EQ(tool(plan(flags)).code, kDone);
  EXPECT_THAT(testing::read_bytes(sheet), HasSubstr("| position | articulation | q1 |"));
  EXPECT_THAT(testing::read_bytes(picture), HasSubstr("far seat</text>"));
  const auto again = tool(plan(flags));
  EXPECT_EQ(again.code, kWrongInput);
  EXPECT_THAT(again.err, HasSubstr("--force"));
}

TEST(PlanVerificationCommand, NamesEverythingThatFindsNoPlace) {
  const auto result = tool(plan({"--volume", "-600,600,-600,600,-100,600"}));
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("no place for the far seat"));
  EXPECT_THAT(result.err, HasSubstr("outside the measuring volume"));
  EXPECT_THAT(result.err, HasSubstr("no place for a bar of 1150 mm along z"));
  EXPECT_TRUE(result.out.empty());
}

TEST(PlanVerificationCommand, RefusesNonsense) {
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--standard", "iso"},
                                             {"--lengths", "200,x"},
                                             {"--lengths", "400,200"},
                                             {"--lengths", "0,200"},
                                             {"--bars", "500"},
                                             {"--bars", "900,500"},
                                             {"--sphere-diameter", "0"},
                                             {"--tip-diameter", "-1"},
                                             {"--reach", "0"},
                                             {"--volume", "1,0,0,1,0,1"}}) {
    const auto result = tool(plan(wrong));
    EXPECT_EQ(result.code, kWrongInput) << wrong.front() << ' ' << wrong.back() << result.err;
    EXPECT_TRUE(result.out.empty());
  }
}

}  // namespace
}  // namespace armcal::cli
