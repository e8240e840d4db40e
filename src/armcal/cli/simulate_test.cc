// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/io/sha256.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using ::testing::HasSubstr;
using testing::tool;

TEST(Simulate, WritesWhatItLists) {
  const testing::TemporaryFolder folder;
  const auto result =
      tool({"simulate", "--scenario", "digitizer", "-o", folder.path("out"), "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["seed"], 1);
  EXPECT_GT(json["floor_mm"], 0.0);
  EXPECT_GT(json["drawing_error_mm"], json["floor_mm"]);
  ASSERT_GT(json["files"].size(), 3u);
  for (const Json& file : json["files"]) {
    EXPECT_EQ(sha256_hex(testing::read_bytes(file["path"].get<std::string>())), file["sha256"]);
  }
}

TEST(Simulate, DrawsAnotherArmWithAnotherSeed) {
  const testing::TemporaryFolder folder;
  for (const char* seed : {"1", "2"}) {
    const auto result = tool({"simulate", "--scenario", "digitizer", "-o",
                              folder.path(std::string("out") + seed), "--seed", seed});
    ASSERT_EQ(result.code, kDone) << result.err;
    EXPECT_THAT(result.out, HasSubstr(std::string("seed ") + seed));
  }
  EXPECT_NE(testing::read_bytes(folder.path("out1/truth.arm.toml")),
            testing::read_bytes(folder.path("out2/truth.arm.toml")));
  EXPECT_EQ(testing::read_bytes(folder.path("out1/nominal.arm.toml")),
            testing::read_bytes(folder.path("out2/nominal.arm.toml")));
}

TEST(Simulate, OverwritesOnlyWithForceAndNeverItsInputs) {
  const testing::TemporaryFolder folder;
  const std::string arm = testing::read_bytes(testing::example("calibration/digitizer.arm.toml"));
  folder.write("nominal.arm.toml", arm);
  const std::string scenario = folder.write("a.scenario.toml", R"(schema = "armcal.scenario/1"
arm = "nominal.arm.toml"
[[measure]]
with = "reference_cmm"
)");
  const auto into = [&](const std::string& out, const char* flag) {
    return tool({"simulate", scenario, "-o", folder.path(out), flag});
  };
  EXPECT_EQ(into("out", "--quiet").code, kDone);
  const auto again = into("out", "--quiet");
  EXPECT_EQ(again.code, kWrongInput);
  EXPECT_THAT(again.err, HasSubstr("cmm.csv: error: exists already\n  help: give --force"));
  EXPECT_EQ(into("out", "--force").code, kDone);
  const auto beside = into("", "--force");  // would replace the drawing that it reads
  EXPECT_EQ(beside.code, kWrongInput);
  EXPECT_THAT(beside.err, HasSubstr("is an input of this very command"));
  EXPECT_EQ(testing::read_bytes(folder.path("nominal.arm.toml")), arm);
}

TEST(Simulate, SaysWhatIsMissingOrWrong) {
  EXPECT_EQ(tool({"simulate"}).code, kWrongInput);
  EXPECT_THAT(tool({"simulate"}).err, HasSubstr("give either a scenario file or --scenario NAME"));
  EXPECT_THAT(tool({"simulate", "--scenario", "romer"}).err, HasSubstr("-o FOLDER"));
  const auto unknown = tool({"simulate", "--scenario", "rommer", "-o", "x"});
  EXPECT_EQ(unknown.code, kWrongInput);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"romer\"?"));
  EXPECT_THAT(tool({"simulate", "--scenario", "romer", "-o", "x", "--seed", "1.5"}).err,
              HasSubstr("--seed 1.5: must be a whole number"));
  EXPECT_EQ(tool({"simulate", "nowhere.scenario.toml", "-o", "x"}).code, kWrongInput);
}

TEST(Simulate, RefusesTheImpossibleWithPlaceAndReason) {
  const testing::TemporaryFolder folder;
  folder.write("arm.toml", testing::read_bytes(testing::example("calibration/digitizer.arm.toml")));
  const std::string scenario = folder.write("a.scenario.toml", R"(schema = "armcal.scenario/1"
arm = "arm.toml"
[[measure]]
with = "ball_bar"
length_mm = 5000
)");
  const auto result = tool({"simulate", scenario, "-o", folder.path("out")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("a.scenario.toml:3:1: error: ball-bar"));
  EXPECT_THAT(result.err, HasSubstr("reach"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

}  // namespace
}  // namespace armcal::cli
