// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/half_turns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/arm/clearance.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

Laboratory laboratory_of(const ArmModel& arm) { return {VirtualArm(arm, arm, {}, 1), 7}; }

template <class Gesture>
std::string refusal(const ArmModel& arm, const Gesture& gesture) {
  Laboratory laboratory = laboratory_of(arm);
  try {
    static_cast<void>(measure(laboratory, gesture));
  } catch (const Impossible& impossible) {
    return impossible.what();
  }
  return "measured";
}

TEST(HalfTurns, TurnOneJointByHalfATurnWithinItsStops) {
  const ArmModel arm = seven_joint_arm();
  Laboratory laboratory = laboratory_of(arm);
  const ObservationGroup group = measure(laboratory, HalfTurns{.count = 20, .u_mm = 0.0}).front();
  EXPECT_EQ(group.kind, ReferenceKind::reversal);
  for (Eigen::Index i = 0; i < group.count(); ++i) {
    const int joint = group.joint[static_cast<std::size_t>(i)];
    EXPECT_TRUE(joint != 2 && joint != 7) << joint;  // no room; last
    Eigen::VectorXd turn = group.encoder_end_rad.col(i) - group.encoder_rad.col(i);
    EXPECT_NEAR(turn(joint - 1), std::numbers::pi, 1e-15);
    turn(joint - 1) = 0.0;
    EXPECT_TRUE(turn.isZero(0.0));
    for (const auto& posture : {group.encoder_rad, group.encoder_end_rad}) {
      const Eigen::VectorXd at = posture.col(i);
      EXPECT_EQ(broken_limit(arm, {at.data(), 7}), std::nullopt);
    }
  }
}

TEST(HalfTurns, AreOfTheJointsThatAreWanted) {
  Laboratory laboratory = laboratory_of(testing::nominal_romer());
  const ObservationGroup turns =
      measure(laboratory, HalfTurns{.count = 3, .joints = {1, 3}}).front();
  EXPECT_THAT(turns.joint, ::testing::ElementsAre(1, 3, 1));
  const ObservationGroup circles =
      measure(laboratory, CircleRadii{.count = 3, .joints = {6, 5}}).front();
  EXPECT_THAT(circles.joint, ::testing::ElementsAre(6, 5, 6));
  // Whatever the posture, the tip stays as far from the last axis.
  EXPECT_NEAR(circles.value_mm(0), std::hypot(25.0, 175.0), 0.03);
  EXPECT_NEAR(circles.value_mm(0), circles.value_mm(2), 0.03);
}

TEST(HalfTurns, AreRefusedBetweenStopsThatLeaveNoRoom) {
  EXPECT_EQ(refusal(seven_joint_arm(), HalfTurns{.joints = {2}}),
            "half-turns: half turn of joint 2 is impossible: its stops are 180.0 deg apart");
  ArmModel stiff = testing::nominal_romer();
  for (Joint& joint : stiff.joints) {
    joint.min_rad = -1.0;
    joint.max_rad = 1.0;
  }
  EXPECT_EQ(refusal(stiff, HalfTurns{}), "no joint can be turned by 180.0 deg");
  EXPECT_EQ(refusal(stiff, CircleRadii{.arc_rad = 2.5}), "no joint can be turned by 143.2 deg");
  EXPECT_EQ(refusal(stiff, CircleRadii{.arc_rad = 1.5}), "measured");
}

}  // namespace
}  // namespace armcal
