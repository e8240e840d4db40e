// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/scale_eccentricity.h"

#include <gtest/gtest.h>

#include "armcal/arm/encoder.h"
#include "armcal/core/units.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

TEST(ScaleEccentricity, OffAddsNoHarmonics) {
  RandomStream random(1);
  const ArmModel arm = with_eccentric_scales(testing::consistent_romer(), {}, random);
  for (const Joint& joint : arm.joints) EXPECT_TRUE(joint.harmonics.empty());
}

TEST(ScaleEccentricity, IsOnceAndTwicePerTurn) {
  RandomStream random(1);
  const ArmModel arm =
      with_eccentric_scales(testing::consistent_romer(), {.u_first_rad = 1e-4}, random);
  for (const Joint& joint : arm.joints) {
    ASSERT_EQ(joint.harmonics.size(), 2U);
    // Once per turn alone: what half a turn away is the opposite.
    const double here = joint_angle(joint, 0.7) - 0.7;
    const double opposite = joint_angle(joint, 0.7 + std::numbers::pi) - 0.7 - std::numbers::pi;
    EXPECT_NEAR(here, -opposite, 1e-15);
    EXPECT_NE(here, 0.0);
  }
}

TEST(ScaleEccentricity, IsAddedToWhatTheScalesHadBefore) {
  ArmModel before = testing::consistent_romer();
  before.joints[2].harmonics = {{1e-3, 0.0}, {0.0, 2e-3}, {3e-3, 0.0}};
  RandomStream random(1);
  const ArmModel arm = with_eccentric_scales(before, ScaleEccentricity::typical(), random);
  ASSERT_EQ(arm.joints[2].harmonics.size(), 3U);
  EXPECT_NEAR(arm.joints[2].harmonics[1].sin_rad, 2e-3, radians_from_arcseconds(10.0));
  EXPECT_NE(arm.joints[2].harmonics[1].sin_rad, 2e-3);
  EXPECT_EQ(arm.joints[2].harmonics[2].cos_rad, 3e-3);
}

}  // namespace
}  // namespace armcal
