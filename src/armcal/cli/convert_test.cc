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
using testing::read_bytes;
using testing::TemporaryFolder;
using testing::tool;

TEST(ConvertCommand, WritesTheTableOfARobot) {
  const auto result =
      tool({"convert", example("arms/puma-560.arm.toml"), "--to", "dh-classic", "--csv"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_EQ(
      result.out,
      "theta_deg,d_mm,a_mm,alpha_deg\n0.0,0.0,0.0,90.0\n0.0,0.0,431.8,0.0\n0.0,150.05,20.3,-90.0\n"
      "0.0,431.8,0.0,90.0\n0.0,0.0,0.0,-90.0\n0.0,0.0,0.0,0.0\n");
}

TEST(ConvertCommand, AnOutputNamedCsvIsASpreadsheet) {
  const TemporaryFolder folder;
  const std::string csv = folder.path("panda.csv");
  EXPECT_EQ(
      tool({"convert", example("arms/panda.arm.toml"), "--to", "dh-modified", "-o", csv}).code,
      kDone);
  EXPECT_THAT(read_bytes(csv), HasSubstr("0.0,107.0,88.0,90.0\n"));
  const std::string arm = folder.path("panda.arm.toml");
  EXPECT_EQ(tool({"convert", csv, "--from", "dh-modified", "-o", arm}).code, kDone);
  EXPECT_THAT(read_bytes(arm), HasSubstr("a_mm = 82.5\nalpha_deg = 90.0\n"));
}

TEST(ConvertCommand, AnArmFileComesThroughUnchanged) {
  const TemporaryFolder folder;
  const std::string once = folder.path("once.arm.toml");
  ASSERT_EQ(tool({"convert", example("arms/gao-2018.arm.toml"), "-o", once}).code, kDone);
  EXPECT_EQ(tool({"convert", once}).out, read_bytes(once));
  EXPECT_THAT(read_bytes(once), HasSubstr("alpha_deg = -89.9683\n"));
}

TEST(ConvertCommand, SaysWhatATableCannotHold) {
  const auto result = tool({"convert", example("arms/seven-joint.arm.toml"), "--to", "dh-classic"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.err,
              HasSubstr("a D-H table has no place for the limits of joint 1: left out"));
  const auto csv =
      tool({"convert", example("arms/gao-2018.arm.toml"), "--to", "dh-classic", "--csv"});
  EXPECT_EQ(csv.code, kWrongInput);
  EXPECT_THAT(csv.err, HasSubstr("has a base or tool pose"));
}

// An option that the file or the format contradicts was ignored in silence.
TEST(ConvertCommand, RefusesOptionsThatCannotHold) {
  const TemporaryFolder folder;
  const std::string arm = example("arms/panda.arm.toml");
  const std::string dh = folder.path("panda.dh.toml");
  ASSERT_EQ(tool({"convert", arm, "--to", "dh-modified", "-o", dh}).code, kDone);
  EXPECT_EQ(tool({"convert", dh, "--from", "dh-modified"}).code, kDone);
  const auto contradiction = tool({"convert", dh, "--from", "dh-classic"});
  EXPECT_EQ(contradiction.code, kWrongInput);
  EXPECT_THAT(contradiction.err,
              HasSubstr("says convention = \"modified\", which --from contradicts"));
  const auto none = tool({"convert", arm, "--from", "dh-classic", "--to", "dh-classic"});
  EXPECT_EQ(none.code, kWrongInput);
  EXPECT_THAT(none.err, HasSubstr("is an arm file, which has no D-H convention"));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--csv"}, {"-o", folder.path("p.csv")}}) {
    std::vector<std::string> line = {"convert", arm};
    line.insert(line.end(), more.begin(), more.end());
    EXPECT_EQ(tool(line).code, kWrongInput);
    EXPECT_THAT(tool(line).err, HasSubstr("is for D-H tables, not for --to arm"));
  }
}

TEST(ConvertCommand, SaysThatATableHasNoHeader) {
  const TemporaryFolder folder;
  const auto result =
      tool({"convert", folder.write("t.csv", "0,100,0,90\n0,0,200,0\n"), "--from", "dh-classic"});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("it has no header and 4 columns; name the right one with --map "
                                    "theta_deg=NUMBER"));
}

TEST(ConvertCommand, RefusesNearlyParallelAxesWithCode4) {
  const TemporaryFolder folder;
  const auto result =
      tool({"convert",
            folder.write("a.arm.toml",
                         "schema = \"armcal.arm/1\"\n[[link]]\na_mm = 600\nbeta_deg = 1e-4\n"),
            "--to", "dh-classic"});
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("axes 1 and 2 are 0.0001 deg from parallel"));
}

TEST(ConvertCommand, ReadsAUrdf) {
  const auto result = tool({"convert", example("urdf/ur10.urdf"), "--to", "dh-classic", "--csv"});
  EXPECT_EQ(result.code, kDone) << result.err;
  EXPECT_EQ(result.out,
            tool({"convert", example("arms/ur10.arm.toml"), "--to", "dh-classic", "--csv"}).out);
}

TEST(ConvertCommand, WarnsOfWhatAUrdfCannotSay) {
  const TemporaryFolder folder;
  const std::string arm = folder.write("a.arm.toml",
                                       "schema = \"armcal.arm/1\"\n[[link]]\nb_mm = 600\n"
                                       "[[joint]]\nharmonics = [[1e-5, 0.0]]\n[[joint]]\n");
  const auto result = tool({"convert", arm, "--to", "urdf"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.err,
              HasSubstr("a URDF has no place for the encoder harmonics of joint 1: left out"));
  EXPECT_THAT(tool({"convert", arm, "--to", "c-header"}).out, HasSubstr("ARMCAL_HARMONICS 1"));
  EXPECT_THAT(tool({"convert", arm, "--to", "csv-line"}).out,
              HasSubstr(",cos1_1_rad,sin1_1_rad\n"));
}

TEST(ConvertCommand, ABrokenUrdfIsWrongInput) {
  const TemporaryFolder folder;
  const auto result = tool({"convert", folder.write("a.urdf", "<robot>\n</rob>\n")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("a.urdf:2:3: error: is not XML"));
}

}  // namespace
}  // namespace armcal::cli
