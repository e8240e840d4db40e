// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/forward_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/derivative_check.h"
#include "armcal/numerics/rank_analysis.h"
#include "armcal/testing/elementary_kinematics.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using std::numbers::pi;

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(ForwardKinematics, AgreesWithTheProductOfElementaryMatrices) {
  RandomStream random(1);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    for (int trial = 0; trial < 20; ++trial) {
      const ArmModel arm = testing::random_arm(n, random);
      const ForwardKinematics kinematics(arm);
      const auto posture = testing::random_posture(n, random);
      const Eigen::Vector3d expected =
          testing::elementary_tip<double>(arm, parameter_values(arm), vector_of(posture));
      EXPECT_NEAR((kinematics.tip_in_base(posture) - expected).norm(), 0, 1e-11) << n << " joints";
      EXPECT_NEAR((kinematics.linearise(posture).tip_mm - expected).norm(), 0, 1e-11);
      EXPECT_NEAR((kinematics.base_from_tip(posture).translation_mm - expected).norm(), 0, 1e-11);
    }
  }
}

TEST(ForwardKinematics, LinkMatrixIsThatOfTheTheory) {
  // mathematics of one link, entry by entry: theory/kinematics.md eq. (1), with the sign of entry
  // (2,3).
  ArmModel arm;
  arm.joints.resize(2);
  arm.links = {{7.0, 3.0, 2.0, 0.6, 0.0}};
  arm.tip = {.d_mm = 1.0};  // one step along the z axis that leaves the link
  const double t = 0.9;
  const double ct = std::cos(t), st = std::sin(t), ca = std::cos(0.6), sa = std::sin(0.6);
  const Eigen::Vector3d expected(st * sa + 2 * ct - 3 * st, -ct * sa + 2 * st + 3 * ct, ca + 7);
  const std::vector<double> posture = {t, 0.4};
  EXPECT_NEAR((ForwardKinematics(arm).tip_in_base(posture) - expected).norm(), 0, 1e-15);
}

TEST(ForwardKinematics, TipOrientationTurnsWithTheLastJoint) {
  RandomStream random(2);
  ArmModel arm = testing::random_arm(6, random);
  const auto posture = testing::random_posture(6, random);
  const RigidTransform with = ForwardKinematics(arm).base_from_tip(posture);
  const Eigen::Matrix3d flange = rotation_from_roll_pitch_yaw(arm.tip.roll_pitch_yaw_rad);
  arm.tip.roll_pitch_yaw_rad.setZero();
  const RigidTransform without = ForwardKinematics(arm).base_from_tip(posture);
  EXPECT_NEAR((with.rotation - without.rotation * flange).norm(), 0, 1e-14);
  EXPECT_NEAR((with.rotation * with.rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 0,
              1e-14);
}

TEST(ForwardKinematics, JacobianIsExactForEveryParameterAndEveryReading) {
  RandomStream random(3);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    for (int trial = 0; trial < 5; ++trial) {
      const ArmModel arm = testing::random_arm(n, random);
      const auto posture = testing::random_posture(n, random);
      const TipLinearisation at = ForwardKinematics(arm).linearise(posture);
      const Eigen::VectorXcd values = parameter_values(arm).cast<std::complex<double>>();
      const Eigen::VectorXcd readings = vector_of(posture).cast<std::complex<double>>();
      const auto by_parameters = jacobian_by_complex_step(
          [&](const Eigen::VectorXcd& x) -> Eigen::VectorXcd {
            return testing::elementary_tip<std::complex<double>>(arm, x, readings);
          },
          parameter_values(arm));
      const auto by_readings = jacobian_by_complex_step(
          [&](const Eigen::VectorXcd& x) -> Eigen::VectorXcd {
            return testing::elementary_tip<std::complex<double>>(arm, values, x);
          },
          vector_of(posture));
      EXPECT_LT(worst_relative_difference(at.J_tip_parameters, by_parameters), 1e-9) << n;
      EXPECT_LT(worst_relative_difference(at.J_tip_encoder, by_readings), 1e-9) << n;
    }
  }
}

TEST(ForwardKinematics, AWorkspaceCanBeReusedForAnotherArm) {
  RandomStream random(4);
  TipLinearisation workspace;
  for (const int n : {6, 9, 3}) {
    const ArmModel arm = testing::random_arm(n, random);
    const auto posture = testing::random_posture(n, random);
    const ForwardKinematics kinematics(arm);
    kinematics.linearise(posture, workspace);
    EXPECT_EQ(workspace.J_tip_parameters, kinematics.linearise(posture).J_tip_parameters);
  }
}

TEST(ForwardKinematics, JointAxesAreWhatTheJointsTurnAbout) {
  // Turning joint k leaves the points of its axis where they are.
  RandomStream random(5);
  const ArmModel arm = testing::random_arm(7, random);
  const ForwardKinematics kinematics(arm);
  const auto posture = testing::random_posture(7, random);
  const TipLinearisation at = kinematics.linearise(posture);
  for (int k = 0; k < 7; ++k) {
    auto turned = posture;
    turned[static_cast<std::size_t>(k)] += 0.7;
    const Eigen::Vector3d moved = kinematics.tip_in_base(turned);
    const Eigen::Vector3d axis = at.joint_axes.col(k);
    const Eigen::Vector3d origin = at.joint_origins_mm.col(k);
    EXPECT_NEAR(axis.dot(moved - origin), axis.dot(at.tip_mm - origin), 1e-10);
    EXPECT_NEAR(axis.cross(moved - origin).norm(), axis.cross(at.tip_mm - origin).norm(), 1e-10);
  }
}

TEST(ForwardKinematics, PositionsIdentifyFourNMinusThreeParameters) {
  // Rank of the Jacobian over many postures with the base frame free: 4n - 3 (21 for six joints, 25
  // for seven).
  RandomStream random(6);
  for (int n = 2; n <= 8; ++n) {
    const ArmModel arm = testing::random_arm(n, random, {.beta = false, .harmonics = 0});
    const ForwardKinematics kinematics(arm);
    const ParameterTable table(arm);
    const int postures = 60;
    Eigen::MatrixXd jacobian(3 * postures, 6 + table.size());
    for (int i = 0; i < postures; ++i) {
      const TipLinearisation at = kinematics.linearise(testing::random_posture(n, random));
      jacobian.block<3, 3>(3 * i, 0).setIdentity();
      jacobian.block<3, 3>(3 * i, 3) = -skew(at.tip_mm);
      jacobian.block(3 * i, 6, 3, table.size()) = at.J_tip_parameters;
    }
    for (const int beta : table.matching("beta*")) jacobian.col(6 + beta).setZero();
    std::vector<int> order;
    for (int c = 0; c < 6 + table.size(); ++c) order.push_back(c);
    EXPECT_EQ(analyse_rank(jacobian, order).rank, 6 + 4 * n - 3) << n << " joints";
  }
}

TEST(ForwardKinematics, RefusesAnUnsoundArmByName) {
  ArmModel arm;
  arm.name = "broken";
  try {
    const ForwardKinematics kinematics(arm);
    FAIL() << "an arm without joints was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("arm \"broken\": 0 joints"), std::string::npos);
  }
}

}  // namespace
}  // namespace armcal
