// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/urdf_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/io/urdf_file.h"
#include "armcal/testing/same_poses.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ArmModel read_back(const std::string& text) {
  Diagnostics diagnostics;
  auto arm = read_urdf({"w.urdf", text, "UTF-8", ""}, std::nullopt, diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  return arm.value();
}

TEST(UrdfWriter, WhatIsWrittenHasTheSamePoses) {
  RandomStream random(1);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    for (int i = 0; i < 10; ++i) {
      const ArmModel arm = testing::random_arm(n, random, {.harmonics = 0});
      const UrdfText urdf = urdf_text(arm);
      EXPECT_THAT(urdf.lost, ElementsAre());
      testing::expect_same_poses(arm, read_back(urdf.text));
    }
  }
}

TEST(UrdfWriter, ParallelAntiparallelAndNearlyParallelAxesToo) {
  RandomStream random(2);
  for (double beta = 1e-16; beta < 0.2; beta *= 10.0) {
    ArmModel arm = testing::random_arm(5, random, {.beta = false, .harmonics = 0});
    arm.links[0].alpha_rad = 0.0;
    arm.links[1].alpha_rad = std::numbers::pi;
    arm.links[1].a_mm = arm.links[1].b_mm = 0.0;
    arm.links[2].alpha_rad = 0.0;
    arm.links[2].beta_rad = beta;
    testing::expect_same_poses(arm, read_back(urdf_text(arm).text));
  }
}

TEST(UrdfWriter, JointsShowDirectionAndLimits) {
  RandomStream random(3);
  ArmModel arm = testing::random_arm(3, random, {.harmonics = 0});
  arm.joints[0].direction = -1;
  arm.joints[0].min_rad = -2.5;
  arm.joints[0].max_rad = 0.5;
  arm.joints[2].max_rad = 1.0;
  arm.joints[1].harmonics = {{1e-5, 0.0}};
  const UrdfText urdf = urdf_text(arm);
  EXPECT_THAT(urdf.text, HasSubstr("<joint name=\"joint_1\" type=\"revolute\">"));
  EXPECT_THAT(urdf.text, HasSubstr("<axis xyz=\"0 0 -1\"/>"));
  EXPECT_THAT(urdf.text,
              HasSubstr("<limit lower=\"-2.5\" upper=\"0.5\" effort=\"0\" velocity=\"0\"/>"));
  EXPECT_THAT(urdf.text, HasSubstr("<joint name=\"joint_2\" type=\"continuous\">"));
  EXPECT_THAT(urdf.lost,
              ElementsAre("encoder harmonics of joint 2", "limit on one side only of joint 3"));
  const ArmModel back = read_back(urdf.text);
  EXPECT_EQ(back.joints[0].direction, -1);
  EXPECT_EQ(back.joints[0].min_rad, -2.5);
}

TEST(UrdfWriter, NamesAndNotesCannotBreakTheXml) {
  RandomStream random(4);
  ArmModel arm = testing::random_arm(2, random, {.harmonics = 0});
  arm.name = "<a> \"b\" & 'c' --> \x01 \xE5\x85\xB3\xE8\x8A\x82\xE8\x87\x82";
  arm.note = "-- - ---><robot> & \x02";
  const ArmModel back = read_back(urdf_text(arm).text);
  EXPECT_EQ(back.name, "<a> \"b\" & 'c' -->   \xE5\x85\xB3\xE8\x8A\x82\xE8\x87\x82");
}

}  // namespace
}  // namespace armcal
