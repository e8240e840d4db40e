// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/joint_arcs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/identification/calibration.h"
#include "armcal/identification/circle_points.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

ErrorSources geometry_only() {
  ErrorSources errors;
  errors.geometry = GeometryErrors::typical();
  return errors;
}

ObservationGroup arcs_of(const VirtualArm& arm, const JointArcs& arcs, std::uint64_t seed) {
  Laboratory laboratory(arm, seed);
  return measure(laboratory, arcs).front();
}

TEST(JointArcs, TurnOneJointAfterTheOther) {
  const VirtualArm arm(testing::consistent_romer(), geometry_only(), 1);
  const ObservationGroup group = arcs_of(arm, {.points = 7}, 1);
  ASSERT_EQ(group.count(), 42);
  for (Eigen::Index row = 1; row < group.count(); ++row) {
    const int joint = group.joint[static_cast<std::size_t>(row)];
    EXPECT_EQ(joint, row / 7 + 1);
    if (row % 7 == 0) continue;
    const Eigen::VectorXd step = group.encoder_rad.col(row) - group.encoder_rad.col(row - 1);
    EXPECT_NEAR(step(joint - 1), radians_from_degrees(270.0 / 6.0), 1e-12);
    EXPECT_EQ((step.array() != 0.0).count(), 1);
  }
}

TEST(JointArcs, GiveBackTheArmWithoutNoise) {
  const VirtualArm arm(testing::consistent_romer(), geometry_only(), 2);
  const ObservationGroup group = arcs_of(arm, {.u_mm = 0.0}, 2);
  const CirclePointAnalysis found = analyse_circle_points(arm.nominal(), group);
  ASSERT_TRUE(found.ok()) << found.detail;
  EXPECT_LT(found.rms_mm, 1e-9);
  const Calibration calibration = calibrate(arm.nominal(), std::vector{group}, {});
  ASSERT_TRUE(calibration.ok());
  EXPECT_LT(calibration.groups[0].fit.rms_mm, 1e-9);
}

TEST(JointArcs, StayWithinTheLimitsOfTheJoints) {
  ArmModel nominal = testing::consistent_romer();
  nominal.joints[1].min_rad = -0.4;
  nominal.joints[1].max_rad = 1.1;
  nominal.joints[4].max_rad = 2.0;
  const VirtualArm arm(nominal, {}, 3);
  const ObservationGroup group = arcs_of(arm, {}, 3);
  EXPECT_GE(group.encoder_rad.row(1).minCoeff(), -0.4);
  EXPECT_LE(group.encoder_rad.row(1).maxCoeff(), 1.1);
  EXPECT_LE(group.encoder_rad.row(4).maxCoeff(), 2.0);
  EXPECT_TRUE(analyse_circle_points(nominal, group).ok());
}

TEST(JointArcs, AreImpossibleWhereTheTipIsOnTheLastAxis) {
  ArmModel nominal = testing::consistent_romer();
  nominal.tip = {.d_mm = 150.0};
  try {
    static_cast<void>(arcs_of(VirtualArm(nominal, {}, 4), {}, 4));
    FAIL() << "drew an arc about joint 6";
  } catch (const Impossible& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("joint 6 gets no farther than 0.000 mm"));
  }
}

}  // namespace
}  // namespace armcal
