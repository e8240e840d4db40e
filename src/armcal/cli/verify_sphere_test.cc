// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TemporaryFolder;
using testing::tool;

std::vector<std::string> sphere(const std::string& readings, const std::string& arm,
                                const std::vector<std::string>& more = {}) {
  std::vector<std::string> line = {"verify",
                                   "sphere",
                                   example("sphere/" + readings),
                                   "--arm",
                                   example("arms/" + arm),
                                   "--diameter",
                                   "15.8754",
                                   "--tip-diameter",
                                   "6"};
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

TEST(VerifySphereCommand, PassesARightArm) {
  const auto result = tool(sphere("five-articulations.csv", "romer-infinite-2.0.arm.toml",
                                  {"--limit", "0.02", "--form-limit", "0.05", "--json"}));
  EXPECT_EQ(result.code, kDone);
  EXPECT_EQ(result.json()["verdict"], "pass");
  EXPECT_NEAR(result.json()["diameter_error_mm"].get<double>(), 0.0, 0.01);
  EXPECT_THAT(result.err, IsEmpty());
}

TEST(VerifySphereCommand, FailsThePrintedArmWithCode1) {
  const auto result = tool(sphere("still-wrist.csv", "romer-infinite-2.0-as-printed.arm.toml",
                                  {"--limit", "0.5", "--form-limit", "0.05", "--json"}));
  EXPECT_EQ(result.code, kDoesNotConform);
  EXPECT_EQ(result.json()["tests"][0]["verdict"], "pass");  // the diameter alone looks fair
  EXPECT_EQ(result.json()["tests"][1]["verdict"], "fail");
  EXPECT_GT(result.json()["form_error_mm"].get<double>(), 1.0);
}

TEST(VerifySphereCommand, WarnsOfAStillWrist) {
  const auto result = tool(sphere("still-wrist.csv", "romer-infinite-2.0.arm.toml"));
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.err,
              HasSubstr("warning: the arm moved too little for this test to reveal a wrong arm"));
  EXPECT_THAT(result.err, HasSubstr("help: probe the sphere from several articulations"));
}

TEST(VerifySphereCommand, TakesCoordinatesWithoutAnArm) {
  const auto result =
      tool({"verify", "sphere", example("points/sphere.csv"), "--diameter", "25.4", "--json"});
  EXPECT_EQ(result.code, kDone) << result.err;
  EXPECT_EQ(result.json()["verdict"], "not_judged");
  EXPECT_NEAR(result.json()["diameter_error_mm"].get<double>(), 0.0, 0.005);
}

// Four points used to pass any limit of form with 0.0000.
TEST(VerifySphereCommand, FourPointsShowNoFormError) {
  const TemporaryFolder folder;
  const std::string four =
      folder.write("four.csv", "x_mm,y_mm,z_mm\n10,0,0\n-10,0,0\n0,10,0\n0,0,10\n");
  const auto judged = tool({"verify", "sphere", four, "--diameter", "20", "--form-limit", "0.01"});
  EXPECT_EQ(judged.code, kNumericalFailure);
  EXPECT_THAT(judged.err, HasSubstr("4 points determine a sphere exactly and show no form error"));
  const auto measured =
      tool({"verify", "sphere", four, "--diameter", "20", "--limit", "0.01", "--json"});
  EXPECT_EQ(measured.code, kDone);
  EXPECT_THAT(measured.err, HasSubstr("nothing checks the diameter"));
  EXPECT_TRUE(measured.json()["form_error_mm"].is_null());
  EXPECT_EQ(measured.json()["verdict"], "pass");
}

TEST(VerifySphereCommand, AsksForTheArmWhereThereAreOnlyAngles) {
  const auto result =
      tool({"verify", "sphere", example("sphere/still-wrist.csv"), "--diameter", "15.8754"});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("give the arm that turns them into tips: --arm ARM"));
}

TEST(VerifySphereCommand, RefusesPosturesCopiedTwice) {
  const TemporaryFolder folder;
  const std::string rows = testing::read_bytes(example("sphere/five-articulations.csv"));
  const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
  const std::string doubled = folder.write("doubled.csv", rows + last);
  std::vector<std::string> line = sphere("five-articulations.csv", "romer-infinite-2.0.arm.toml");
  line[2] = doubled;
  EXPECT_THAT(tool(line).err, HasSubstr("is the same as line"));
  EXPECT_EQ(tool(line).code, kWrongInput);
  line.emplace_back("--keep-duplicates");
  EXPECT_EQ(tool(line).code, kDone);
}

TEST(VerifySphereCommand, RefusesNonsense) {
  EXPECT_EQ(tool({"verify", "sphere", example("points/sphere.csv"), "--diameter", "-3"}).code,
            kWrongInput);
  const auto flat = tool({"verify", "sphere", example("points/gander1994.csv"), "--diameter", "3"});
  EXPECT_EQ(flat.code, kNumericalFailure);
  EXPECT_THAT(flat.err, HasSubstr("no sphere fits: the points lie in one plane"));
}

}  // namespace
}  // namespace armcal::cli
