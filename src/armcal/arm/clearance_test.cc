// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using std::numbers::pi;

// Upper arm, forearm and probe of 400, 300 and 100 mm in one vertical plane: the first axis is
// vertical, the others are horizontal. At 0 the arm is stretched out level; joint 2 lifts it.
ArmModel plain_arm() {
  ArmModel arm;
  arm.name = "plain";
  arm.joints.resize(4);
  arm.links = {{.alpha_rad = 0.5 * pi}, {.a_mm = 400.0}, {.a_mm = 300.0}};
  arm.tip.a_mm = 100.0;
  return arm;
}

std::string obstacle(const ArmModel& arm, std::vector<double> degrees,
                     const Surroundings& surroundings) {
  for (double& angle : degrees) angle *= pi / 180.0;
  return collision(ForwardKinematics(arm), degrees, surroundings).value_or("none");
}

TEST(Clearance, NothingIsInTheWayWhereNothingStands) {
  EXPECT_EQ(obstacle(plain_arm(), {0, -90, 180, 0}, {}), "none");
}

TEST(Clearance, TheBenchStopsTipAndJoints) {
  const Surroundings bench{.bench_mm = -200.0};
  EXPECT_EQ(obstacle(plain_arm(), {0, 0, 0, 0}, bench), "none");
  EXPECT_EQ(obstacle(plain_arm(), {30, 0, -30, -60}, bench), "the tip is 50.0 mm below the bench");
  EXPECT_EQ(obstacle(plain_arm(), {30, 0, -60, 90}, bench), "joint 4 is 59.8 mm below the bench");
  EXPECT_EQ(obstacle(plain_arm(), {-70, -60, 150, 0}, bench),
            "joint 3 is 146.4 mm below the bench");
}

TEST(Clearance, TheColumnStopsLinksThatPassIt) {
  const Surroundings column{.column_radius_mm = 60.0, .column_top_mm = 0.0};
  // Forearm back through the column, under the shoulder.
  EXPECT_EQ(obstacle(plain_arm(), {0, -30, -120, 0}, column),
            "the link from joint 4 to the tip passes 0.0 mm from the first axis, inside the column "
            "of radius 60.0 mm");
  EXPECT_EQ(obstacle(plain_arm(), {0, -60, -60, 0}, column),
            "the link from joint 3 to joint 4 passes 50.0 mm from the first axis, inside the "
            "column of radius 60.0 mm");
  // The same over the shoulder, where there is none.
  EXPECT_EQ(obstacle(plain_arm(), {0, 30, 120, 0}, column), "none");
}

TEST(Clearance, TheColumnEndsAtItsTop) {
  // The forearm hangs from 346.4 mm above the shoulder straight down, 200 mm from the axis; then it
  // leans towards it.
  const Surroundings thick{.column_radius_mm = 150.0, .column_top_mm = 100.0};
  EXPECT_EQ(obstacle(plain_arm(), {0, 60, -150, 0}, thick), "none");
  EXPECT_NE(obstacle(plain_arm(), {0, 60, -165, 0}, thick), "none");
  const Surroundings low{.column_radius_mm = 150.0, .column_top_mm = -100.0};
  EXPECT_EQ(obstacle(plain_arm(), {0, 60, -165, 0}, low), "none");
}

TEST(Clearance, OnlyThePartBelowTheTopCounts) {
  // The forearm passes over the column and comes down behind it: it is near the axis above the top
  // and away from it below.
  const Surroundings column{.column_radius_mm = 60.0, .column_top_mm = 0.0};
  const std::vector<double> over = {0, 45, 160, 0};  // down from 283 mm high across the axis
  EXPECT_EQ(obstacle(plain_arm(), over, column), "none");
  const Surroundings high{.column_radius_mm = 60.0, .column_top_mm = 300.0};
  EXPECT_NE(obstacle(plain_arm(), over, high), "none");
}

TEST(Clearance, AShoulderOfSeveralJointsIsNotInItsOwnWay) {
  // Seven joints: the third turns the upper arm about itself and has its origin in the shoulder.
  ArmModel arm;
  arm.name = "seven";
  arm.joints.resize(7);
  arm.links.resize(6);
  for (int i = 0; i < 6; ++i) {
    arm.links[static_cast<std::size_t>(i)].alpha_rad = (i % 2 == 0 ? 0.5 : -0.5) * pi;
  }
  arm.links[2].d_mm = 600.0;
  arm.links[4].d_mm = 500.0;
  arm.tip.b_mm = 200.0;
  const Surroundings around{.column_radius_mm = 60.0, .column_top_mm = 50.0, .bench_mm = -300.0};
  EXPECT_EQ(obstacle(arm, {0, 90, 0, 0, 0, 0, 0}, around), "none");
}

TEST(Clearance, AnArmOfTwoJointsHasOnlyATip) {
  ArmModel arm;
  arm.name = "two";
  arm.joints.resize(2);
  arm.links = {{.alpha_rad = 0.5 * pi}};
  arm.tip.a_mm = 100.0;
  const Surroundings around{.column_radius_mm = 60.0, .column_top_mm = 0.0, .bench_mm = -90.0};
  EXPECT_EQ(obstacle(arm, {0, -30}, around), "none");
  EXPECT_EQ(obstacle(arm, {0, -90}, around), "the tip is 10.0 mm below the bench");
  EXPECT_EQ(obstacle(arm, {0, -60}, around),
            "the tip passes 50.0 mm from the first axis, inside the column of radius 60.0 mm");
}

TEST(Clearance, HeightsAreAlongTheFirstAxisWhereverTheArmStands) {
  RandomStream random(1);
  ArmModel arm = testing::consistent_romer();
  const Surroundings around{.column_radius_mm = 80.0, .column_top_mm = 20.0, .bench_mm = -250.0};
  const ForwardKinematics upright(arm);
  arm.base_from_first_joint = testing::random_transform(random, 1000.0);
  const ForwardKinematics on_a_wall(arm);
  int stopped = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> posture = testing::random_posture(6, random);
    const auto hit = collision(upright, posture, around);
    EXPECT_EQ(collision(on_a_wall, posture, around), hit);
    stopped += hit ? 1 : 0;
  }
  EXPECT_GT(stopped, 50);
  EXPECT_LT(stopped, 190);
}

TEST(JointLimits, NameTheJointItsReadingAndTheLimit) {
  ArmModel arm = plain_arm();
  EXPECT_FALSE(broken_limit(arm, std::vector<double>{100.0, -100.0, 0.0, 0.0}));
  arm.joints[1].min_rad = -0.5 * pi;
  arm.joints[1].max_rad = 0.5 * pi;
  EXPECT_FALSE(broken_limit(arm, std::vector<double>{0.0, 0.5 * pi, 0.0, 0.0}));
  EXPECT_EQ(broken_limit(arm, std::vector<double>{0.0, 95.0 * pi / 180.0, 0.0, 0.0}),
            "joint 2 at 95.0 deg is beyond its limit of 90.0 deg");
  EXPECT_EQ(broken_limit(arm, std::vector<double>{0.0, -100.0 * pi / 180.0, 0.0, 0.0}),
            "joint 2 at -100.0 deg is beyond its limit of -90.0 deg");
  EXPECT_TRUE(broken_limit(arm, std::vector<double>{0.0, std::nan(""), 0.0, 0.0}));
}

}  // namespace
}  // namespace armcal
