// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/base_movement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/simulation/errors/gravity_sag.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using Eigen::Vector3d;

TEST(BaseMovement, TurnsTheArmAboutItsFirstJointAndShiftsIt) {
  RandomStream random(1);
  const ArmModel arm = testing::random_arm(6, random);
  ArmState state = state_of(arm, testing::random_posture(6, random));
  const Vector3d foot = arm.base_from_first_joint.translation_mm;
  const Vector3d before = frames_of(state).tip_mm;
  const RigidTransform movement = testing::random_transform(random, 1.0);
  add_movement(state, movement);
  const Vector3d expected = foot + movement.rotation * (before - foot) + movement.translation_mm;
  EXPECT_LT((frames_of(state).tip_mm - expected).norm(), 1e-10);
}

TEST(BaseMovement, HasTheStatedSizes) {
  RandomStream random(1);
  double shift2 = 0.0;
  double turn2 = 0.0;
  constexpr int kReadings = 2000;
  for (int i = 0; i < kReadings; ++i) {
    const auto movement = drawn_movement({.u_shift_mm = 0.01, .u_tilt_rad = 1e-5}, random);
    shift2 += movement.translation_mm.squaredNorm() / 3.0;
    turn2 += vector_from_rotation(movement.rotation).squaredNorm() / 3.0;
  }
  EXPECT_NEAR(std::sqrt(shift2 / kReadings), 0.01, 0.0004);
  EXPECT_NEAR(std::sqrt(turn2 / kReadings), 1e-5, 4e-7);
}

TEST(BaseMovement, LeansToWhereTheArmReachesOut) {
  ArmState state;
  state.joints.resize(1);
  state.links.resize(1);
  state.links[0].way_mm = {1000.0, 0.0, 0.0};
  const BaseMovement base{.load_kg = 4.0, .tilt_rad_per_N_mm = 1e-9};
  EXPECT_TRUE(base.tilts());
  EXPECT_FALSE(base.is_random());
  add_tilt(state, base, -Vector3d::UnitZ());
  // 4 kg at 500 mm tilt by 1e-9 rad per N mm, seen at 1000 mm.
  const double drop = 1e-9 * 4.0 * kGravity_m_per_s2 * 500.0 * 1000.0;
  EXPECT_NEAR(frames_of(state).tip_mm.z(), -drop, 1e-8);
}

}  // namespace
}  // namespace armcal
