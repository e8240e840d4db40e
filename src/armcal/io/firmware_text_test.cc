// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/firmware_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/io/number_text.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

constexpr int kPostures = 20;

bool has_c_compiler() { return std::system("cc --version >/dev/null 2>&1") == 0; }

/// Tips that a C program computes which includes the header twice; one row for each posture.
std::vector<Eigen::Vector3d> tips_in_c(const ArmModel& arm,
                                       const std::vector<std::vector<double>>& postures) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("arm.h", c_header_text(arm).text));
  std::string program =
      "#include \"arm.h\"\n#include \"arm.h\"\n#include <stdio.h>\n"
      "int main(void) {\n  double tip[3];\n  int i;\n";
  program +=
      fmt::format("  static const double postures[{}][ARMCAL_JOINTS] = {{\n", postures.size());
  for (const auto& posture : postures) {
    program += "{";
    for (const double angle : posture) program += shortest_text(angle) + ",";
    program += "},\n";
  }
  program += fmt::format(
      "  }};\n  for (i = 0; i < {}; ++i) {{\n"
      "    armcal_tip(postures[i], tip);\n"
      "    printf(\"%.17g %.17g %.17g\\n\", tip[0], tip[1], tip[2]);\n  }}\n"
      "  return 0;\n}}\n",
      postures.size());
  static_cast<void>(folder.write("main.c", program));
  const std::string command = fmt::format(
      "cd '{}' && cc -std=c99 -Wall -Wextra -pedantic -Werror -O1 main.c -o tips -lm 2>log && "
      "./tips >tips.txt",
      folder.path("."));
  EXPECT_EQ(std::system(command.c_str()), 0) << testing::read_bytes(folder.path("log"));
  std::istringstream numbers(testing::read_bytes(folder.path("tips.txt")));
  std::vector<Eigen::Vector3d> tips;
  for (Eigen::Vector3d p; numbers >> p.x() >> p.y() >> p.z();) tips.push_back(p);
  return tips;
}

void expect_same_tips(const ArmModel& arm) {
  RandomStream random(5);
  std::vector<std::vector<double>> postures;
  for (int i = 0; i < kPostures; ++i) {
    postures.push_back(testing::random_posture(arm.joint_count(), random));
  }
  const auto tips = tips_in_c(arm, postures);
  ASSERT_EQ(tips.size(), postures.size());
  const ForwardKinematics kinematics(arm);
  for (std::size_t i = 0; i < tips.size(); ++i) {
    EXPECT_LT((tips[i] - kinematics.tip_in_base(postures[i])).norm(), 1e-9);
  }
}

TEST(CHeader, ComputesTheSameTips) {
  if (!has_c_compiler()) GTEST_SKIP() << "no C compiler `cc` found";
  RandomStream random(1);
  for (const int joints : {2, 6, 7, 10}) expect_same_tips(testing::random_arm(joints, random));
}

TEST(CHeader, TakesArmsWithoutHarmonicsAndWithUnequalOnes) {
  if (!has_c_compiler()) GTEST_SKIP() << "no C compiler `cc` found";
  RandomStream random(2);
  ArmModel arm = testing::random_arm(6, random, {.harmonics = 0});
  expect_same_tips(arm);
  arm.joints[1].harmonics = {{1e-3, 2e-3}, {0.0, 1e-4}, {1e-4, 0.0}};
  arm.joints[4].harmonics = {{-1e-3, 0.0}};
  expect_same_tips(arm);
}

TEST(CHeader, CompilesWhateverTheName) {
  if (!has_c_compiler()) GTEST_SKIP() << "no C compiler `cc` found";
  RandomStream random(3);
  ArmModel arm = testing::random_arm(2, random);
  for (const char* name : {"*/ int x; /*", "a\\\nb?\?/\nc\r", "", "\xE5\x85\xB3\xE8\x8A\x82 7",
                           "right \xE2\x80\xAE to left", "\"quoted\" // %s {}"}) {
    arm.name = name;
    expect_same_tips(arm);
  }
}

TEST(CHeader, GuardIsMadeFromTheName) {
  RandomStream random(4);
  ArmModel arm = testing::random_arm(2, random);
  arm.name = "Romer: Infinite 2.0!";
  EXPECT_THAT(c_header_text(arm).text, HasSubstr("#ifndef ARMCAL_ROMER_INFINITE_2_0_H\n"));
  arm.name = "";
  EXPECT_THAT(c_header_text(arm).text, HasSubstr("#ifndef ARMCAL_ARM_H\n"));
}

TEST(CHeader, SaysWhatItLeavesOut) {
  RandomStream random(5);
  ArmModel arm = testing::random_arm(2, random);
  arm.joints[1].max_rad = 1.0;
  EXPECT_THAT(c_header_text(arm).lost, ElementsAre("limits of joint 2", "orientation of the tip"));
}

TEST(CsvLine, HasNamesWithUnitsAndValuesInTableOrder) {
  ArmModel arm;
  arm.joints.resize(2);
  arm.joints[1].zero_rad = 0.25;
  arm.joints[1].harmonics = {{1e-5, -2e-5}};
  arm.links = {{1.5, 747.489, -3.0, 1.5707963267948966, 0.0}};
  arm.tip.b_mm = 100.0;
  const FirmwareText line = csv_line_text(arm);
  EXPECT_EQ(line.text,
            "zero1_rad,zero2_rad,d2_mm,b2_mm,a2_mm,alpha2_rad,beta2_rad,a3_mm,b3_mm,d3_mm,"
            "cos1_2_rad,sin1_2_rad\n"
            "0.0,0.25,1.5,747.489,-3.0,1.5707963267948966,0.0,0.0,100.0,0.0,1e-05,-2e-05\n");
  EXPECT_THAT(line.lost, ElementsAre());
}

TEST(CsvLine, SaysWhatItLeavesOut) {
  RandomStream random(6);
  ArmModel arm = testing::random_arm(2, random);
  arm.joints[0].direction = -1;
  arm.joints[1].direction = 1;
  EXPECT_THAT(csv_line_text(arm).lost,
              ElementsAre("orientation of the tip", "counting direction -1 of joint 1",
                          "place of the base"));
}

}  // namespace
}  // namespace armcal
