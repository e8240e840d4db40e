// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/joint_arcs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/geometry/registration.h"
#include "armcal/identification/calibration.h"
#include "armcal/identification/circle_points.h"
#include "armcal/simulation/instruments/reference_cmm.h"
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

/// Rms distance of tips of an arm from the true ones, after the frames are brought together.
double rms_off_mm(const ArmModel& arm, const ArmModel& truth) {
  const ForwardKinematics tip(arm);
  const ForwardKinematics true_tip(truth);
  RandomStream random(99);
  std::vector<Eigen::Vector3d> found;
  std::vector<Eigen::Vector3d> wanted;
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> e = testing::random_posture(truth.joint_count(), random);
    found.push_back(tip.tip_in_base(e));
    wanted.push_back(true_tip.tip_in_base(e));
  }
  return register_points(found, wanted).rms_mm;
}

// One posture is all that circle points see. Over 20 arms the ratios are 0.7 and 5.3.
TEST(JointArcs, AreNoMatchForAsManyPointsAnywhere) {
  double by_circles = 0.0;
  double by_arcs = 0.0;
  double by_points = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const VirtualArm arm(testing::consistent_romer(), geometry_only(), seed);
    const std::vector<ObservationGroup> arcs = {arcs_of(arm, {}, seed)};
    const CirclePointAnalysis circles = analyse_circle_points(arm.nominal(), arcs[0]);
    ASSERT_TRUE(circles.ok()) << circles.detail;
    Laboratory laboratory(arm, 100 + seed);
    const auto points = measure(laboratory, ReferenceCmm{.count = 60});
    const auto square = [&](const ArmModel& found) {
      const double rms = rms_off_mm(found, arm.truth());
      return rms * rms;
    };
    by_circles += square(circles.arm);
    by_arcs += square(calibrate(arm.nominal(), arcs, {}).arm);
    by_points += square(calibrate(arm.nominal(), points, {}).arm);
  }
  EXPECT_LT(by_arcs, by_circles);
  EXPECT_LT(std::sqrt(by_points), 0.5 * std::sqrt(by_circles));
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
