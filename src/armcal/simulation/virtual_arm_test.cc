// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/virtual_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr std::uint64_t kArmSeed = 20;

VectorXd posture(int joint_count, RandomStream& random) {
  const std::vector<double> angles = testing::random_posture(joint_count, random);
  return Eigen::Map<const VectorXd>(angles.data(), joint_count);
}

// Everything that can act acts: warm, pushed, on a foot that has moved.
Circumstances rough() {
  return {.time_s = 1000.0,
          .push = Vector3d(0.6, 0.0, -0.8),
          .base_movement = {rotation_from_vector({1e-6, 2e-6, -1e-6}), {0.001, -0.002, 0.001}}};
}

VirtualArm arm_with(const ErrorSource& source) {
  ErrorSources errors;
  source.switch_on(errors);
  return {testing::consistent_romer(), errors, kArmSeed};
}

TEST(VirtualArm, WithoutErrorsIsItsDrawing) {
  RandomStream random(1);
  for (int joints = 3; joints <= 8; ++joints) {
    const ArmModel drawing = testing::random_arm(joints, random);
    const VirtualArm arm(drawing, {}, kArmSeed);
    EXPECT_EQ(parameter_values(arm.truth()), parameter_values(drawing));
    const VectorXd e = posture(joints, random);
    const Vector3d tip = ForwardKinematics(drawing).tip_in_base(as_span(e));
    EXPECT_LT((arm.tip(e, rough()) - tip).norm(), 1e-11);
    EXPECT_EQ(arm.shown(e, random), e);
    ArmModel bare = drawing;
    bare.tip.roll_pitch_yaw_rad.setZero();
    const Eigen::Matrix3d turn = ForwardKinematics(bare).base_from_tip(as_span(e)).rotation;
    EXPECT_LT((arm.base_from_last_joint(e, rough()) - turn).norm(), 1e-13);
  }
}

TEST(VirtualArm, ErrorsOfNoSizeChangeNoDigit) {
  ErrorSources zero;
  zero.gravity_sag = GravitySag::typical();
  zero.gravity_sag.bending_per_N_mm2 = 0.0;
  zero.gravity_sag.torsion_per_N_mm2 = 0.0;
  zero.gravity_sag.bearing_rad_per_N_mm = 0.0;
  zero.thermal_expansion.expansion_per_K = 1e-5;
  zero.probing_force.force_N = 3.0;
  zero.base_movement.load_kg = 5.0;
  zero.warm_up_drift.time_constant_s = 100.0;
  zero.blunders.share = 0.5;
  const VirtualArm plain(testing::consistent_romer(), {}, kArmSeed);
  const VirtualArm same(testing::consistent_romer(), zero, kArmSeed);
  RandomStream random(2);
  for (int i = 0; i < 20; ++i) {
    const VectorXd e = posture(6, random);
    EXPECT_EQ(same.tip(e, rough()), plain.tip(e, rough()));
  }
}

TEST(VirtualArm, IsTheSameForTheSameSeed) {
  const ErrorSources errors = ErrorSources::typical();
  const VirtualArm one(testing::consistent_romer(), errors, kArmSeed);
  const VirtualArm same(testing::consistent_romer(), errors, kArmSeed);
  const VirtualArm other(testing::consistent_romer(), errors, kArmSeed + 1);
  RandomStream random(3);
  const VectorXd e = posture(6, random);
  EXPECT_EQ(one.tip(e, rough()), same.tip(e, rough()));
  EXPECT_GT((one.tip(e, rough()) - other.tip(e, rough())).norm(), 0.01);
}

TEST(VirtualArm, SourcesAddUp) {
  // Each source draws from its own stream and moves the tip by its own amount, whatever else is on:
  // all together are the sum, but for products of small numbers.
  const VirtualArm plain(testing::consistent_romer(), {}, kArmSeed);
  const VirtualArm full(testing::consistent_romer(), ErrorSources::typical(), kArmSeed);
  RandomStream random(4);
  for (int i = 0; i < 10; ++i) {
    const VectorXd e = posture(6, random);
    const Vector3d all = full.tip(e, rough()) - plain.tip(e, rough());
    Vector3d sum = Vector3d::Zero();
    for (const ErrorSource& source : error_source_list()) {
      sum += arm_with(source).tip(e, rough()) - plain.tip(e, rough());
    }
    EXPECT_LT((all - sum).norm(), 0.003) << all.norm();
  }
}

TEST(VirtualArm, TwiceTheSizeIsTwiceTheSameErrors) {
  ErrorSources single;
  single.geometry = {.u_twist_rad = 1e-6, .u_zero_rad = 1e-6, .u_length_mm = 1e-3};
  single.scale_eccentricity.u_first_rad = 1e-6;
  single.bearing_run_out.u_tilt_rad = 1e-6;
  single.warm_up_drift.u_zero_rad = 1e-6;
  ErrorSources twice = single;
  twice.geometry = {.u_twist_rad = 2e-6, .u_zero_rad = 2e-6, .u_length_mm = 2e-3};
  twice.scale_eccentricity.u_first_rad = 2e-6;
  twice.bearing_run_out.u_tilt_rad = 2e-6;
  twice.warm_up_drift.u_zero_rad = 2e-6;
  const VirtualArm plain(testing::consistent_romer(), {}, kArmSeed);
  const VirtualArm one(testing::consistent_romer(), single, kArmSeed);
  const VirtualArm two(testing::consistent_romer(), twice, kArmSeed);
  RandomStream random(6);
  const VectorXd e = posture(6, random);
  const Vector3d off = one.tip(e, rough()) - plain.tip(e, rough());
  EXPECT_LT((two.tip(e, rough()) - plain.tip(e, rough()) - 2.0 * off).norm(), 1e-3 * off.norm());
}

TEST(VirtualArm, EccentricScalesAreGeometryToBeFound) {
  ErrorSources errors;
  errors.scale_eccentricity = ScaleEccentricity::typical();
  const VirtualArm arm(testing::nominal_romer(), testing::consistent_romer(), errors, kArmSeed);
  EXPECT_EQ(arm.truth().joints[0].harmonics.size(), 2U);
  EXPECT_EQ(arm.truth().links[1].b_mm, testing::consistent_romer().links[1].b_mm);
  RandomStream random(7);
  const VectorXd e = posture(6, random);
  const Vector3d tip = ForwardKinematics(arm.truth()).tip_in_base({e.data(), 6});
  EXPECT_LT((arm.tip(e) - tip).norm(), 1e-11);
}

TEST(VirtualArm, PutsItsRealTipOnAPoint) {
  RandomStream random(8);
  for (int joints = 4; joints <= 8; ++joints) {
    const VirtualArm arm(testing::random_arm(joints, random), ErrorSources::typical(), kArmSeed);
    int found = 0;
    for (int i = 0; i < 10; ++i) {
      const Vector3d point = arm.tip(posture(joints, random), rough());
      const auto e = arm.posture_with_tip_at(point, posture(joints, random), rough());
      if (!e) continue;
      EXPECT_LT((arm.tip(*e, rough()) - point).norm(), 1e-9);
      ++found;
    }
    EXPECT_GE(found, 6) << joints;
  }
}

TEST(VirtualArm, KeepsPosturesInsideItsLimitsAndOutOfTheBench) {
  ArmModel drawing = testing::consistent_romer();
  for (Joint& joint : drawing.joints) {
    joint.min_rad = -2.5;
    joint.max_rad = 2.5;
  }
  drawing.joints[4].min_rad = -HUGE_VAL;
  drawing.joints[4].max_rad = HUGE_VAL;
  const VirtualArm arm(drawing, ErrorSources::typical(), kArmSeed,
                       {.column_radius_mm = 60.0, .bench_mm = -300.0});
  RandomStream random(9);
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    const VectorXd start = 4.0 * posture(6, random);  // up to two turns away
    const Vector3d point(random.uniform(300, 900), random.uniform(-500, 500), 200.0);
    const auto e = arm.posture_with_tip_at(point, start);
    if (!e) continue;
    ++found;
    EXPECT_FALSE(arm.obstacle(*e).has_value()) << *arm.obstacle(*e);
  }
  EXPECT_GT(found, 10);
}

TEST(VirtualArm, SaysWhatIsInTheWay) {
  ArmModel drawing = testing::consistent_romer();
  drawing.joints[3].max_rad = 1.0;
  const VirtualArm arm(drawing, {}, kArmSeed, {.bench_mm = 0.0});
  VectorXd e = VectorXd::Zero(6);
  e(3) = 1.2;
  EXPECT_EQ(arm.obstacle(e), "joint 4 at 68.8 deg is beyond its limit of 57.3 deg");
  RandomStream random(10);
  for (int i = 0; i < 50; ++i) {
    const VectorXd somewhere = 0.3 * posture(6, random);  // within the limits
    const double height = arm.tip(somewhere).z();
    const std::string reason = arm.obstacle(somewhere).value_or("none");
    EXPECT_TRUE(height >= 0.0 || reason.ends_with("below the bench")) << height << reason;
  }
}

}  // namespace
}  // namespace armcal
