// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/thermal_expansion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

TEST(ThermalExpansion, ScalesAnArmThatIsEvenlyWarm) {
  RandomStream random(1);
  const ArmModel arm = testing::random_arm(6, random);
  const ThermalExpansion thermal{.expansion_per_K = 2e-5, .temperature_K = 5.0};
  ArmState state = state_of(arm, testing::random_posture(6, random));
  const Eigen::Vector3d foot = arm.base_from_first_joint.translation_mm;
  const Eigen::Vector3d before = frames_of(state).tip_mm - foot;
  add_expansion(state, drawn_expansion(6, thermal, random));
  EXPECT_LT((frames_of(state).tip_mm - foot - 1.0001 * before).norm(), 1e-10);
}

TEST(ThermalExpansion, GivesEachLinkItsTemperature) {
  RandomStream random(1);
  const ThermalExpansion thermal{.expansion_per_K = 1e-5, .temperature_K = 3, .u_temperature_K = 1};
  const auto growth = drawn_expansion(2000, thermal, random);
  double sum = 0.0;
  double sum2 = 0.0;
  for (const double each : growth) {
    sum += each / 1e-5;
    sum2 += (each / 1e-5 - 3.0) * (each / 1e-5 - 3.0);
  }
  EXPECT_NEAR(sum / 2000.0, 3.0, 0.1);
  EXPECT_NEAR(std::sqrt(sum2 / 2000.0), 1.0, 0.06);
}

}  // namespace
}  // namespace armcal
