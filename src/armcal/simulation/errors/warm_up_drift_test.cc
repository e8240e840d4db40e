// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/warm_up_drift.h"

#include <gtest/gtest.h>

#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

TEST(WarmUpDrift, MovesZerosInTheDirectionOfTheCountAndLengthsInProportion) {
  RandomStream random(1);
  ArmModel arm = testing::random_arm(5, random, {.harmonics = 0});
  const auto posture = testing::random_posture(5, random);
  const DrawnDrift drift = drawn_drift(5, {.u_zero_rad = 1e-4, .u_length = 1e-4}, random);
  ArmState state = state_of(arm, posture);
  add_drift(state, drift, arm.joints, 0.5);
  // The same arm with other zeros and lengths.
  for (std::size_t i = 0; i < 5; ++i) {
    arm.joints[i].zero_rad += 0.5 * drift.zero_rad[i];
    const double grown = 1.0 + 0.5 * drift.growth[i];
    double* const lengths[3] = {i < 4 ? &arm.links[i].a_mm : &arm.tip.a_mm,
                                i < 4 ? &arm.links[i].b_mm : &arm.tip.b_mm,
                                i < 4 ? &arm.links[i].d_mm : &arm.tip.d_mm};
    for (double* length : lengths) *length *= grown;
  }
  const Eigen::Vector3d expected = frames_of(state_of(arm, posture)).tip_mm;
  EXPECT_LT((frames_of(state).tip_mm - expected).norm(), 1e-10);
}

TEST(WarmUpDrift, HasNotBegunAtTheStart) {
  RandomStream random(1);
  const ArmModel arm = testing::random_arm(5, random);
  const auto posture = testing::random_posture(5, random);
  ArmState state = state_of(arm, posture);
  add_drift(state, drawn_drift(5, WarmUpDrift::typical(), random), arm.joints, 0.0);
  EXPECT_EQ(frames_of(state).tip_mm, frames_of(state_of(arm, posture)).tip_mm);
}

}  // namespace
}  // namespace armcal
