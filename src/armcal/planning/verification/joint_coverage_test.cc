// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/joint_coverage.h"

#include <gtest/gtest.h>

#include "armcal/core/units.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::degrees;

ArmModel arm_of_two() {
  ArmModel arm;
  arm.joints.resize(2);
  arm.links.resize(1);
  return arm;
}

TEST(JointCoverage, IsTheShareOfTheWayFromStopToStop) {
  ArmModel arm = arm_of_two();
  arm.joints[0].min_rad = radians_from_degrees(-60.0);
  arm.joints[0].max_rad = radians_from_degrees(120.0);
  const auto share = joint_coverage(arm, {degrees({-15, 0}), degrees({75, 0}), degrees({30, 0})});
  EXPECT_NEAR(share(0), 0.5, 1e-12);
}

// Readings of 170 and -170 deg are 20 deg apart, not 340.
TEST(JointCoverage, OfAJointThatGoesAllRoundIsTheTurnLessTheLargestGap) {
  const ArmModel arm = arm_of_two();
  const auto share =
      joint_coverage(arm, {degrees({170, 0}), degrees({-170, 90}), degrees({175, 180 + 360})});
  EXPECT_NEAR(share(0), 20.0 / 360.0, 1e-12);
  EXPECT_NEAR(share(1), 180.0 / 360.0, 1e-12);
}

TEST(JointCoverage, OfOnePostureOrNoneIsNothing) {
  const ArmModel arm = arm_of_two();
  EXPECT_EQ(joint_coverage(arm, {}), Eigen::Vector2d::Zero());
  EXPECT_EQ(joint_coverage(arm, {degrees({40, -40})}), Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace armcal
