// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/arm_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/arm/parameter_table.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

TextFile arm_file(std::string text) { return {"x.arm.toml", std::move(text), "UTF-8", ""}; }

ArmModel read_arm(const std::string& text) {
  Diagnostics diagnostics;
  const auto arm = read_arm(arm_file(text), diagnostics);
  EXPECT_TRUE(arm.has_value()) << diagnostics.to_text();
  return arm.value_or(ArmModel{});
}

std::string complaint_about_arm(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_arm(arm_file(text), diagnostics).has_value());
  return diagnostics.to_text();
}

constexpr const char* kArmHead = "schema = \"armcal.arm/1\"\n";

TEST(ArmFile, ReadsTheExampleOfTheContract) {
  const ArmModel arm = read_arm(R"(schema = "armcal.arm/1"
name = "two joints"
[[link]]
d_mm = 0.0
b_mm = 747.489
a_mm = 0
alpha_deg = -90
beta_deg = 0
[tip]
a_mm = -25.962
b_mm = 176.484
[[joint]]
zero_deg = 180
direction = -1
min_deg = -180
max_deg = 180
harmonics = [ [0.0, 0.0] ]
[[joint]]
harmonics = [ [1e-4, -2e-4], [0, 3e-5] ]
)");
  EXPECT_EQ(arm.name, "two joints");
  EXPECT_EQ(arm.links.at(0).b_mm, 747.489);
  EXPECT_EQ(arm.links[0].alpha_rad, -std::numbers::pi / 2);
  EXPECT_EQ(arm.tip.a_mm, -25.962);
  EXPECT_EQ(arm.tip.d_mm, 0.0);
  EXPECT_EQ(arm.joints[0].zero_rad, std::numbers::pi);
  EXPECT_EQ(arm.joints[0].direction, -1);
  EXPECT_TRUE(arm.joints[0].harmonics.empty());
  EXPECT_EQ(arm.joints[1].harmonics[1].sin_rad, 3e-5);
  EXPECT_TRUE(std::isinf(arm.joints[1].max_rad));
}

TEST(ArmFile, WrittenAndReadAgainIsTheSameArm) {
  RandomStream random(1);
  for (int n = 2; n <= 10; ++n) {
    ArmModel arm = testing::random_arm(n, random, {.harmonics = n % 3});
    arm.name = "say \"arm\" \\ \n \xE5\x85\xB3\xE8\x8A\x82";
    arm.note = "note";
    arm.joints[0].min_rad = -3.0;
    const ArmModel once = read_arm(arm_text(arm));
    // Lengths to the last bit, angles to one unit in the last place ..
    const Eigen::VectorXd before = parameter_values(arm);
    const Eigen::VectorXd after = parameter_values(once);
    const ParameterTable table(arm);
    for (int i = 0; i < table.size(); ++i) {
      if (table[i].unit == ParameterUnit::mm || table[i].harmonic > 0) {
        EXPECT_EQ(before(i), after(i)) << table[i].name;
      } else {
        EXPECT_NEAR(before(i), after(i), 2.3e-16 * std::abs(before(i))) << table[i].name;
      }
    }
    EXPECT_EQ(once.name, arm.name);
    EXPECT_NEAR((once.base_from_first_joint.rotation - arm.base_from_first_joint.rotation).norm(),
                0, 3e-15);
    // .. and from then on nothing changes any more.
    const ArmModel twice = read_arm(arm_text(once));
    EXPECT_EQ(parameter_values(twice), parameter_values(once));
    EXPECT_EQ(twice.joints[0].min_rad, once.joints[0].min_rad);
  }
}

TEST(ArmFile, AnglesTypedInDegreesSurviveExactly) {
  const std::string text =
      std::string(kArmHead) +
      "name = \"g\"\n\n[[link]]\nd_mm = 376.5\nb_mm = 0.0\na_mm = -0.0226\nalpha_deg = -89.9683\n"
      "\n[tip]\na_mm = 0.0\nb_mm = 97.811\nd_mm = 15.0695\n"
      "\n[[joint]]\nzero_deg = 0.0\n\n[[joint]]\nzero_deg = -0.006\n";
  EXPECT_EQ(arm_text(read_arm(text)), text);
}

TEST(ArmFile, NamesEveryProblemWithItsPlace) {
  const std::string text = complaint_about_arm(
      "schema = \"armcal.arm/1\"\n[[link]]\nd_mm = \"1\"\nalfa_deg = 90\n[tip]\nb_mm = "
      "nan\n[base]\nposition_mm = [1, 2]\n");
  EXPECT_THAT(text, HasSubstr("x.arm.toml:3:1: error: d_mm must be a number, not a text"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "x.arm.toml:4:1: error: unknown key \"alfa_deg\"\n  help: did you mean \"alpha_deg\"?"));
  EXPECT_THAT(text, HasSubstr("x.arm.toml:6:1: error: b_mm must be a number, not nan or inf"));
  EXPECT_THAT(text, HasSubstr("x.arm.toml:8:1: error: position_mm has 2 numbers: must have 3"));
}

TEST(ArmFile, WarnsOfTwistsThatLookLikeRadians) {
  Diagnostics diagnostics;
  const std::string text =
      "schema = 'armcal.arm/1'\n[[link]]\nalpha_deg = 1.5708\n[[link]]\nalpha_deg = -1.5708\n";
  EXPECT_TRUE(read_arm({"a.toml", text, "UTF-8", ""}, diagnostics).has_value());
  EXPECT_EQ(
      diagnostics.to_text(),
      "a.toml:2:1: warning: the values of alpha_deg look like radians, and are read as degrees\n"
      "  help: write them in degrees: 90 instead of 1.5708\n");
}

TEST(ArmFile, RefusesZeroAndElevenJoints) {
  EXPECT_THAT(complaint_about_arm(kArmHead),
              HasSubstr("x.arm.toml: error: describes 1 joint: an arm here has 2 to 10"));
  std::string eleven = kArmHead;
  for (int i = 0; i < 10; ++i) eleven += "[[link]]\nb_mm = 100\n";
  EXPECT_THAT(complaint_about_arm(eleven),
              HasSubstr("describes 11 joints: an arm here has 2 to 10"));
}

TEST(ArmFile, RefusesJointsThatDoNotMatchTheLinks) {
  EXPECT_THAT(
      complaint_about_arm(std::string(kArmHead) + "[[link]]\nb_mm = 1\n[[joint]]\nzero_deg = 0\n"),
      HasSubstr("x.arm.toml:4:1: error: 1 [[joint]] tables for 2 joints"));
  EXPECT_THAT(complaint_about_arm(
                  std::string(kArmHead) +
                  "[[link]]\n[[joint]]\ndirection = 2\n[[joint]]\nmin_deg = 5\nmax_deg = 5\n"),
              HasSubstr("direction is 2: must be 1 or -1"));
}

TEST(ArmFile, RefusesAnotherKindOfFile) {
  EXPECT_THAT(complaint_about_arm("schema = \"armcal.session/1\"\n[[link]]\n"),
              HasSubstr("is not \"armcal.arm/1\""));
  EXPECT_THAT(complaint_about_arm("x_mm,y_mm\n1,2\n"), HasSubstr("is not TOML"));
}

RC_GTEST_PROP(ArmFile, SurvivesAnyBytes, (const std::string& text)) {
  Diagnostics diagnostics;
  const bool read = read_arm(arm_file(kArmHead + text), diagnostics).has_value();
  RC_ASSERT(read != diagnostics.has_errors());
}

}  // namespace
}  // namespace armcal
