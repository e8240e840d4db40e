// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::tool;

const std::string kProbedArm = example("arms/seven-joint.arm.toml");

// The first rows of seat A of a check.
std::string seat(const testing::TemporaryFolder& folder, int count) {
  std::istringstream file(testing::read_bytes(example("check/week-01.csv")));
  std::string rows;
  for (std::string line; std::getline(file, line) && count >= 0;) {
    if (line.starts_with('#')) continue;
    rows += line.substr(line.find(',') + 1) + '\n';
    --count;
  }
  return folder.write("seat.csv", rows);
}

TEST(ProbeCommand, QualifiesAStylusWithAVerdict) {
  const testing::TemporaryFolder folder;
  const auto result = tool({"probe", kProbedArm, seat(folder, 10), "--u-encoder-arcsec", "3"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.out, HasSubstr("qualified to U = "));
  EXPECT_THAT(result.out, HasSubstr("no change beyond chance"));
  EXPECT_THAT(result.err, Not(HasSubstr("advised")));
}

TEST(ProbeCommand, EndsWith1WhereTheTipIsNotKnownWellEnough) {
  const testing::TemporaryFolder folder;
  const std::string readings = seat(folder, 10);
  const auto wide = tool({"probe", kProbedArm, readings, "--limit", "0.5", "--json"});
  EXPECT_EQ(wide.code, kDone) << wide.err;
  EXPECT_EQ(wide.json()["verdict"], "pass");
  const auto narrow = tool({"probe", kProbedArm, readings, "--limit", "0.0001", "--json"});
  EXPECT_EQ(narrow.code, kDoesNotConform);
  EXPECT_EQ(narrow.json()["verdict"], "fail");
  EXPECT_EQ(narrow.json()["tip"].size(), 3u);
  EXPECT_EQ(narrow.json()["tip_covariance_mm2"].size(), 3u);
  EXPECT_TRUE(narrow.json().contains("parameters"));  // the keys of a calibration stay
}

TEST(ProbeCommand, AsksForEnoughReadings) {
  const testing::TemporaryFolder folder;
  const auto four = tool({"probe", kProbedArm, seat(folder, 4)});
  EXPECT_EQ(four.code, kWrongInput);
  EXPECT_THAT(four.err, HasSubstr("4 readings in the seat: at least 5 are needed"));
  const auto seven = tool({"probe", kProbedArm, seat(folder, 7)});
  EXPECT_EQ(seven.code, kDone) << seven.err;
  EXPECT_THAT(seven.err, HasSubstr("7 readings in the seat: 10 are advised"));
}

TEST(ProbeCommand, WarnsOfAWristThatHardlyTurns) {
  const auto result =
      tool({"probe", example("arms/romer-infinite-2.0.arm.toml"), example("sphere/still-wrist.csv"),
            "--sphere-diameter", "15.8754", "--tip-diameter", "6"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.err, HasSubstr("the direction of a7 swings by no more than 1.2 deg"));
  EXPECT_THAT(result.err, HasSubstr("turn every joint of the wrist"));
}

TEST(ProbeCommand, NamesWhatAStillWristLeavesOpen) {
  const testing::TemporaryFolder folder;
  std::string rows = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,q7_deg\n";
  for (int i = 0; i < 10; ++i) rows += "10,20,30,40,50,60," + std::to_string(0.001 * i) + "\n";
  const auto result = tool({"probe", kProbedArm, folder.write("still.csv", rows)});
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("the readings do not determine a8, b8, d8: the direction of a8 "
                                    "swings by no more than 0.0 deg"));
  EXPECT_THAT(result.err, HasSubstr("turn every joint of the wrist"));
}

}  // namespace
}  // namespace armcal::cli
