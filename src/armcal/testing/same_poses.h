// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/testing/random_arms.h"

namespace armcal::testing {

/// Same pose of the tip frame at the same readings, at postures all over: 1e-9 mm and 1e-12 rad.
inline void expect_same_poses(const ArmModel& one, const ArmModel& other) {
  ASSERT_EQ(one.joint_count(), other.joint_count());
  const ForwardKinematics first(one);
  const ForwardKinematics second(other);
  RandomStream random(77);
  for (int i = 0; i < 30; ++i) {
    const auto q = random_posture(one.joint_count(), random);
    const RigidTransform a = first.base_from_tip(q);
    const RigidTransform b = second.base_from_tip(q);
    EXPECT_LT((a.translation_mm - b.translation_mm).norm(), 1e-9);
    EXPECT_LT((a.rotation - b.rotation).norm(), 1e-12);
  }
}

}  // namespace armcal::testing
