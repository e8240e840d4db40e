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

const std::string kArm = example("arms/seven-joint.arm.toml");

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
  const auto result = tool({"probe", kArm, seat(folder, 10), "--u-encoder-arcsec", "3"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.out, HasSubstr("qualified to U = "));
  EXPECT_THAT(result.out, HasSubstr("no change beyond chance"));
  EXPECT_THAT(result.err, Not(HasSubstr("advised")));
}

TEST(ProbeCommand, EndsWith1WhereTheTipIsNotKnownWellEnough) {
  const testing::TemporaryFolder folder;
  const std::string readings = seat(folder, 10);
  const auto wide = tool({"probe", kArm, readings, "--limit", "0.5", "--json"});
  EXPECT_EQ(wide.code, kDone) << wide.err;
  EXPECT_EQ(wide.json()["verdict"], "pass");
  const auto narrow = tool({"probe", kArm, readings, "--limit", "0.0001", "--json"});
  EXPECT_EQ(narrow.code, kDoesNotConform);
  EXPECT_EQ(narrow.json()["verdict"], "fail");
  EXPECT_EQ(narrow.json()["tip"].size(), 3u);
  EXPECT_EQ(narrow.json()["tip_covariance_mm2"].size(), 3u);
  EXPECT_TRUE(narrow.json().contains("parameters"));  // the keys of a calibration stay
}

TEST(ProbeCommand, AsksForEnoughReadings) {
  const testing::TemporaryFolder folder;
  const auto four = tool({"probe", kArm, seat(folder, 4)});
  EXPECT_EQ(four.code, kWrongInput);
  EXPECT_THAT(four.err, HasSubstr("4 readings in the seat: at least 5 are needed"));
  const auto seven = tool({"probe", kArm, seat(folder, 7)});
  EXPECT_EQ(seven.code, kDone) << seven.err;
  EXPECT_THAT(seven.err, HasSubstr("7 readings in the seat: 10 are advised"));
}

TEST(ProbeCommand, NamesWhatAStillWristLeavesOpen) {
  const auto result =
      tool({"probe", example("arms/romer-infinite-2.0.arm.toml"), example("sphere/still-wrist.csv"),
            "--sphere-diameter", "15.8754", "--tip-diameter", "6"});
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("is not determined: the direction of"));
  EXPECT_THAT(result.err, HasSubstr("turn every joint of the wrist"));
}

}  // namespace
}  // namespace armcal::cli
