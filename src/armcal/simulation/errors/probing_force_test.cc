// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/probing_force.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

using Eigen::Vector3d;

TEST(ProbingForce, PushesTheTipBack) {
  const ProbingForce probing{.force_N = 2.0, .arm_mm_per_N = 0.01};
  EXPECT_EQ(yield_to(probing, Vector3d::UnitX(), Vector3d::UnitZ()), Vector3d(-0.02, 0.0, 0.0));
  EXPECT_EQ(yield_to(probing, Vector3d::Zero(), Vector3d::UnitZ()), Vector3d::Zero());
}

TEST(ProbingForce, BendsAStylusAcrossItsAxisOnly) {
  const ProbingForce probing{.force_N = 2.0, .stylus_mm_per_N = 0.01};
  EXPECT_EQ(yield_to(probing, Vector3d::UnitX(), Vector3d::UnitZ()), Vector3d(-0.02, 0.0, 0.0));
  EXPECT_EQ(yield_to(probing, Vector3d::UnitZ(), Vector3d::UnitZ()).norm(), 0.0);
  const Vector3d slanting = yield_to(probing, Vector3d(0.6, 0.0, 0.8), Vector3d::UnitZ());
  EXPECT_LT((slanting - Vector3d(-0.012, 0.0, 0.0)).norm(), 1e-15);
}

TEST(ProbingForce, TypicalMakesASphereTooSmallByThePublishedAmount) {
  // Touched from both sides, with the stylus across to along the direction of probing.
  const ProbingForce probing = ProbingForce::typical();
  const double least = 2.0 * yield_to(probing, Vector3d::UnitX(), Vector3d::UnitX()).norm();
  const double most = 2.0 * yield_to(probing, Vector3d::UnitX(), Vector3d::UnitZ()).norm();
  EXPECT_NEAR(least, 0.024, 1e-12);
  EXPECT_NEAR(most, 0.040, 1e-12);
}

}  // namespace
}  // namespace armcal
