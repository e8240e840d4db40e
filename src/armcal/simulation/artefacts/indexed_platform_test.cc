// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/indexed_platform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/same_poses.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

TEST(IndexedPlatform, IsAJointBeforeTheArmThatStandsOnIt) {
  RandomStream random(1, 0);
  const ArmModel arm = testing::random_arm(6, random);
  ArmModel both = on_platform(arm, {.radius_mm = 120.0});
  ASSERT_EQ(both.joint_count(), 7);
  testing::expect_same_poses(without_platform(both), arm);

  // At index 0 both have the same base; turned, the tip goes round the platform's axis.
  const auto posture = testing::random_posture(6, random);
  std::vector<double> turned = {0.0};
  turned.insert(turned.end(), posture.begin(), posture.end());
  const Eigen::Vector3d tip = ForwardKinematics(arm).tip_in_base(posture);
  EXPECT_LT((ForwardKinematics(both).tip_in_base(turned) - tip).norm(), 1e-9);
  turned[0] = 1.0;
  const RigidTransform first_from_base = arm.base_from_first_joint.inverse();
  const Eigen::Vector3d before = first_from_base * tip + 120.0 * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d after = first_from_base * ForwardKinematics(both).tip_in_base(turned) +
                                120.0 * Eigen::Vector3d::UnitX();
  EXPECT_LT((after - rotation_from_vector(Eigen::Vector3d::UnitZ()) * before).norm(), 1e-9);

  // What a calibration finds of the platform goes into the base of the arm.
  Eigen::VectorXd values = parameter_values(both);
  values.head(12) += 1e-3 * Eigen::VectorXd::Ones(12);
  both = with_parameter_values(both, values);
  const ArmModel alone = without_platform(both);
  turned[0] = 0.0;
  EXPECT_LT(
      (ForwardKinematics(alone).tip_in_base(posture) - ForwardKinematics(both).tip_in_base(turned))
          .norm(),
      1e-9);
}

TEST(IndexedPlatform, BringsTheArmToTheSamePointsFromOtherSides) {
  const ArmModel arm = testing::nominal_romer();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 2);
  const ObservationGroup group =
      measure(laboratory, IndexedPlatform{.points = 4, .postures = 2}).front();
  EXPECT_EQ(group.encoder_rad.rows(), 7);
  std::map<std::string, std::set<double>> indices;
  for (Eigen::Index i = 0; i < group.count(); ++i) {
    indices[group.feature[static_cast<std::size_t>(i)]].insert(group.encoder_rad(0, i));
  }
  ASSERT_EQ(indices.size(), 4u);
  for (const auto& [point, seen_from] : indices) {
    EXPECT_GE(seen_from.size(), 2u) << point;
    for (const double index_rad : seen_from) {
      const double steps = index_rad / (std::numbers::pi / 3.0);
      EXPECT_NEAR(steps, std::round(steps), 1e-12);
    }
  }
}

TEST(IndexedPlatform, RefusesPositionsThatHaveNoPointInCommon) {
  const ArmModel arm = testing::nominal_romer();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 3);
  try {
    static_cast<void>(measure(laboratory, IndexedPlatform{.positions = 2, .radius_mm = 3000.0}));
    FAIL();
  } catch (const Impossible& impossible) {
    EXPECT_STREQ(impossible.what(),
                 "platform: none of 100 places for point P1 is within reach from 2 of the 2 "
                 "positions");
  }
}

}  // namespace
}  // namespace armcal
