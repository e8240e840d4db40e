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
using testing::read_bytes;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using testing::tool;

TEST(FkCommand, PrintsTheTable) {
  const auto result = tool({"fk", example("arms/ur10.arm.toml"), example("angles/six-joints.csv")});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.out, StartsWith("x_mm,y_mm,z_mm\n-1184.3,-256.141,11.6"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST(FkCommand, ReadsAForeignFileByMap) {
  const auto result = tool(
      {"fk", example("arms/panda.arm.toml"), example("angles/seven-joints-german.csv"), "--map",
       "q1_rad=A1,q2_rad=A2,q3_rad=A3,q4_rad=A4,q5_rad=A5,q6_rad=A6,q7_rad=A7", "--json"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_EQ(result.json()["count"], 4);
  EXPECT_EQ(result.json()["tips_mm"][0].size(), 3u);
  EXPECT_EQ(result.json()["inputs"].size(), 2u);
}

TEST(FkCommand, WritesAFileButNeverOverOne) {
  const TemporaryFolder folder;
  const std::string output = folder.path("tips.csv");
  const std::vector<std::string> line = {"fk", example("arms/ur10.arm.toml"),
                                         example("angles/six-joints.csv"), "-o", output};
  const auto first = tool(line);
  EXPECT_EQ(first.code, kDone);
  EXPECT_THAT(first.out, IsEmpty());
  EXPECT_THAT(read_bytes(output), StartsWith("x_mm,y_mm,z_mm\n"));
  std::ofstream(output) << "precious";
  const auto second = tool(line);
  EXPECT_EQ(second.code, kWrongInput);
  EXPECT_THAT(second.err, HasSubstr("exists already"));
  EXPECT_EQ(read_bytes(output), "precious");
  std::vector<std::string> forced = line;
  forced.push_back("--force");
  EXPECT_EQ(tool(forced).code, kDone);
}

// Bad input of every kind: a clear message, exit 2, no crash, nothing overwritten.
struct BadInput {
  const char* name;
  std::string bytes;
  const char* message;
};

class FkBadAngles : public ::testing::TestWithParam<BadInput> {};

TEST_P(FkBadAngles, IsRefusedInWords) {
  const TemporaryFolder folder;
  const std::string output = folder.write("tips.csv", "precious");
  const auto result = tool({"fk", example("arms/ur10.arm.toml"),
                            folder.write("q.csv", GetParam().bytes), "-o", output, "--force"});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_EQ(read_bytes(output), "precious");
}

const std::string kHeader = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n";

INSTANTIATE_TEST_SUITE_P(
    Files, FkBadAngles,
    ::testing::Values(
        BadInput{"empty", "", "q.csv: error: is empty"},
        BadInput{"truncated", kHeader + "1,2,3,4,5,6\n1,2,3",
                 "q.csv:3: error: has 3 fields, the first row has 6"},
        BadInput{
            "wrong_unit", "q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad\n0,90,0,0,0,0\n",
            "q.csv:2:3: error: joint 2 angle 90 looks like degrees but the column is in radians"},
        BadInput{"nan", kHeader + "1,2,nan,4,5,6\n",
                 "q.csv:2:5: error: joint 3 angle is missing (\"nan\")"},
        BadInput{"no_number", kHeader + "1,2,3,12.3.4,5,6\n",
                 "q.csv:2:7: error: joint 4 angle \"12.3.4\" is not a number"},
        BadInput{"missing_column", "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg\n1,2,3,4,5\n",
                 "q.csv: error: has no column q6_deg"},
        BadInput{"binary",
                 std::string("\x7F"
                             "ELF\x02\x01\x01\x00\x00\x00",
                             10),
                 "q.csv: error: is not a text file"},
        BadInput{"header_only", kHeader, "q.csv: error: has a header but no rows below it"},
        BadInput{"other_arm", "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,q7_deg\n1,2,3,4,5,6,7\n",
                 "q.csv: error: has a column q7 but the arm has 6 joints"}),
    [](const auto& test) { return std::string(test.param.name); });

class FkBadArm : public ::testing::TestWithParam<BadInput> {};

TEST_P(FkBadArm, IsRefusedInWords) {
  const TemporaryFolder folder;
  const auto result =
      tool({"fk", folder.write("a.arm.toml", GetParam().bytes), example("angles/six-joints.csv")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
}

std::string arm_with_links(int links) {
  std::string text = "schema = \"armcal.arm/1\"\n";
  for (int i = 0; i < links; ++i) text += "[[link]]\nb_mm = 100\n";
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    Files, FkBadArm,
    ::testing::Values(
        BadInput{"empty", "", "a.arm.toml: error: is empty"},
        BadInput{"zero_joints", "schema = \"armcal.arm/1\"\n",
                 "describes 1 joint: an arm here has 2 to 10"},
        BadInput{"eleven_joints", arm_with_links(10),
                 "describes 11 joints: an arm here has 2 to 10"},
        BadInput{"unknown_key", arm_with_links(5) + "lenght = 3\n",
                 "a.arm.toml:12:1: error: unknown key \"lenght\""},
        BadInput{"truncated", "schema = \"armcal.arm/1\"\n[[link]]\nb_mm = ", "a.arm.toml:3:"},
        BadInput{"not_toml", "q1_deg,q2_deg\n1,2\n", "is not TOML"},
        BadInput{"binary", std::string("\x00\x01\x02\x03", 4), "is not a text file"},
        BadInput{"huge", std::string(std::size_t{5} << 20, '#'), "is larger than 4 MB"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FkCommand, TakesALogThatRepeatsAPosture) {
  const TemporaryFolder folder;
  const std::string row = "1,2,3,4,5,6\n";
  const auto result =
      tool({"fk", example("arms/ur10.arm.toml"), folder.write("q.csv", kHeader + row + row)});
  EXPECT_EQ(result.code, kDone) << result.err;
}

// "column  has no unit" was said of a table without header.
TEST(FkCommand, NamesColumnsThatHaveNoNameByNumber) {
  const TemporaryFolder folder;
  const auto result =
      tool({"fk", example("arms/ur10.arm.toml"), folder.write("q.csv", "1,2,3,4,5,6\n")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("error: column 1 has no unit"));
}

// Numbers such as 1e300 went through the model and came out as inf.
TEST(FkCommand, RefusesArmsLongerThanAKilometre) {
  const TemporaryFolder folder;
  const std::string arm = folder.write(
      "a.arm.toml", "schema = \"armcal.arm/1\"\n[[link]]\nb_mm = 1e300\n[tip]\na_mm = 100\n");
  const auto result = tool({"fk", arm, folder.write("q.csv", "q1_deg,q2_deg\n1,2\n")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err,
              HasSubstr("a.arm.toml:3:1: error: b_mm is 1e+300 mm: longer than a kilometre"));
}

TEST(FkCommand, RefusesTwoHundredMegabytesOfNonsenseInSeconds) {
  const TemporaryFolder folder;
  const std::string path = folder.path("big.csv");
  {
    std::ofstream file(path, std::ios::binary);
    file << kHeader;
    const std::string chunk(std::size_t{1} << 20, '7');
    for (int i = 0; i < 200; ++i) file << chunk << "\n";
  }
  const auto result = tool({"fk", example("arms/ur10.arm.toml"), path});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("big.csv:2: error: has 1 field, the first row has 6"));
  EXPECT_THAT(result.err, HasSubstr("more errors not shown"));
  EXPECT_LT(result.err.size(), 5000u);
}

}  // namespace
}  // namespace armcal::cli
