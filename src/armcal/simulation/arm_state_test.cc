// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/arm_state.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using Eigen::Vector3d;

TEST(ArmState, WithoutDisturbanceHasTheTipOfForwardKinematics) {
  RandomStream random(1);
  for (int joints = 2; joints <= 10; ++joints) {
    const ArmModel arm = testing::random_arm(joints, random);
    const auto posture = testing::random_posture(joints, random);
    const Vector3d tip = ForwardKinematics(arm).tip_in_base(posture);
    // Rounding at some metres.
    EXPECT_LT((frames_of(state_of(arm, posture)).tip_mm - tip).norm(), 1e-11) << joints;
  }
}

TEST(ArmState, HasTheFramesOfTheJoints) {
  RandomStream random(2);
  const ArmModel arm = testing::random_arm(6, random);
  const auto posture = testing::random_posture(6, random);
  const TipLinearisation at = ForwardKinematics(arm).linearise(posture);
  const ArmFrames frames = frames_of(state_of(arm, posture));
  for (int i = 0; i < 6; ++i) {
    const RigidTransform& frame = frames.base_from_link[static_cast<std::size_t>(i)];
    EXPECT_LT((frame.translation_mm - at.joint_origins_mm.col(i)).norm(), 1e-11);
    EXPECT_LT((frame.rotation.col(2) - at.joint_axes.col(i)).norm(), 1e-13);
  }
}

TEST(ArmState, CarriesEverythingBehindADisturbanceWithIt) {
  RandomStream random(3);
  const ArmModel arm = testing::random_arm(5, random);
  const auto posture = testing::random_posture(5, random);
  const ArmState still = state_of(arm, posture);
  const ArmFrames frames = frames_of(still);
  const Vector3d small(1e-6, -2e-6, 3e-6);
  const RigidTransform& third = frames.base_from_link[2];
  const Vector3d lever = frames.tip_mm - frames.base_from_link[3].translation_mm;

  ArmState state = still;
  state.links[2].bend_rad = small;
  EXPECT_LT(
      (frames_of(state).tip_mm - frames.tip_mm - (third.rotation * small).cross(lever)).norm(),
      1e-8);
  state = still;
  state.links[2].sag_mm = small;
  EXPECT_LT((frames_of(state).tip_mm - frames.tip_mm - third.rotation * small).norm(), 1e-11);

  // Tilt and shift of an axis are in the frame before the rotation.
  const Eigen::Matrix3d before =
      third.rotation * rotation_from_vector(-still.joints[2].angle_rad * Vector3d::UnitZ());
  state = still;
  state.joints[2].tilt_rad = small;
  EXPECT_LT((frames_of(state).tip_mm - frames.tip_mm -
             (before * small).cross(frames.tip_mm - third.translation_mm))
                .norm(),
            1e-8);
  state = still;
  state.joints[2].shift_mm = small;
  EXPECT_LT((frames_of(state).tip_mm - frames.tip_mm - before * small).norm(), 1e-11);
}

}  // namespace
}  // namespace armcal
