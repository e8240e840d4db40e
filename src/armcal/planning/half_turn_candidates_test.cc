// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/half_turn_candidates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

std::vector<HalfTurn> candidates(const ArmModel& arm, const HalfTurnRoom& room, int count = 200) {
  Rejections rejections;
  return half_turn_candidates(arm, room, count, 1, rejections);
}

Eigen::Vector3d tip(const ArmModel& arm, const Eigen::VectorXd& posture) {
  return ForwardKinematics(arm).tip_in_base(as_span(posture));
}

TEST(HalfTurnCandidates, TurnOneJointByHalfATurnWithinItsStops) {
  const ArmModel arm = seven_joint_arm();
  for (const double grid_deg : {90.0, 45.0, 0.0}) {
    HalfTurnRoom room;
    room.grid_rad = radians_from_degrees(grid_deg);
    const auto found = candidates(arm, room);
    ASSERT_EQ(found.size(), 200u);
    for (const HalfTurn& turn : found) {
      Eigen::VectorXd step = turn.posture_end_rad - turn.posture_rad;
      EXPECT_NEAR(std::abs(step(turn.joint - 1)), std::numbers::pi, 1e-12);
      step(turn.joint - 1) = 0.0;
      EXPECT_EQ(step.norm(), 0.0);
      EXPECT_FALSE(obstacle(arm, room, turn.posture_rad)) << turn.posture_rad.transpose();
      EXPECT_FALSE(obstacle(arm, room, turn.posture_end_rad));
      if (grid_deg == 0.0) continue;
      const Eigen::ArrayXd steps = turn.posture_rad.array() / room.grid_rad;
      EXPECT_LT((steps - steps.round()).abs().maxCoeff(), 1e-9);
    }
  }
}

TEST(HalfTurnCandidates, AnArmWithoutStopsStaysWithinOneTurn) {
  for (const HalfTurn& turn : candidates(testing::consistent_romer(), {})) {
    EXPECT_LE(turn.posture_rad.cwiseAbs().maxCoeff(), std::numbers::pi + 1e-6);
    EXPECT_LE(turn.posture_end_rad.cwiseAbs().maxCoeff(), std::numbers::pi + 1e-6);
  }
}

// Joints before the one that turns carry both tips along: 1 + 4 + 16 half turns of the last three
// joints on a grid of 90 deg are all there are.
TEST(HalfTurnCandidates, NoTwoAreTheSameDistanceByDesign) {
  HalfTurnRoom room;
  room.grid_rad = radians_from_degrees(90.0);
  room.joints = {4, 5, 6};
  EXPECT_EQ(candidates(testing::consistent_romer(), room, 30).size(), 21u);
}

TEST(HalfTurnCandidates, KeepBothTipsInsideTheVolume) {
  HalfTurnRoom room;
  room.volume = MeasuringVolume{{-900, -900, 0}, {900, 900, 700}};
  const ArmModel arm = testing::consistent_romer();
  const auto found = candidates(arm, room);
  ASSERT_EQ(found.size(), 200u);
  for (const HalfTurn& turn : found) {
    for (const Eigen::VectorXd& posture : {turn.posture_rad, turn.posture_end_rad}) {
      EXPECT_GE(tip(arm, posture).z(), 0.0);
      EXPECT_LE(tip(arm, posture).z(), 700.0);
      EXPECT_LE(tip(arm, posture).cwiseAbs().maxCoeff(), 900.0);
    }
  }
}

TEST(HalfTurnCandidates, KeepClearOfBenchAndColumn) {
  HalfTurnRoom room;
  room.surroundings = {.column_radius_mm = 80.0, .column_top_mm = -50.0, .bench_mm = -300.0};
  const ArmModel arm = testing::consistent_romer();
  const ForwardKinematics kinematics(arm);
  const auto found = candidates(arm, room);
  ASSERT_EQ(found.size(), 200u);
  for (const HalfTurn& turn : found) {
    for (const Eigen::VectorXd& posture : {turn.posture_rad, turn.posture_end_rad}) {
      EXPECT_FALSE(collision(kinematics, {posture.data(), 6}, room.surroundings));
    }
  }
}

TEST(HalfTurnCandidates, SayWhatStoodInTheWay) {
  ArmModel arm = testing::consistent_romer();
  for (Joint& joint : arm.joints) {
    joint.min_rad = -1.0;
    joint.max_rad = 1.0;
  }
  Rejections rejections;
  EXPECT_TRUE(half_turn_candidates(arm, {}, 10, 1, rejections).empty());
  EXPECT_EQ(rejections.beyond_limit, rejections.tried);
  EXPECT_THAT(explain(rejections), HasSubstr("of 2000 half turns tried, 2000 were beyond a joint"));
}

TEST(HalfTurnCandidates, RefuseAJointThatTheArmDoesNotHave) {
  HalfTurnRoom room;
  room.joints = {3, 7};
  EXPECT_THROW(static_cast<void>(candidates(testing::consistent_romer(), room)), ImpossiblePlan);
}

TEST(HalfTurnCandidates, DependOnTheSeedAlone) {
  Rejections none;
  const ArmModel arm = testing::consistent_romer();
  const auto first = half_turn_candidates(arm, {}, 50, 7, none);
  const auto again = half_turn_candidates(arm, {}, 50, 7, none);
  const auto other = half_turn_candidates(arm, {}, 50, 8, none);
  ASSERT_EQ(first.size(), again.size());
  bool differs = false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].posture_rad, again[i].posture_rad);
    differs = differs || first[i].posture_rad != other[i].posture_rad;
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace armcal
