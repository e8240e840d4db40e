// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/bearing_run_out.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

ArmState one_joint(double angle_rad) {
  ArmState state;
  state.joints.resize(1);
  state.links.resize(1);
  state.joints[0].angle_rad = angle_rad;
  state.links[0].way_mm = {400.0, 0.0, 100.0};
  return state;
}

TEST(BearingRunOut, MovesTheTipAsItsWavesSay) {
  RunOutOfJoint run_out = RunOutOfJoint::Zero();
  run_out(4, 1) = 0.003;  // along the axis, sine once per turn
  run_out(0, 2) = 1e-6;   // tilt about x, cosine twice per turn
  const double angle = 0.7;
  const Vector3d tip = frames_of(one_joint(angle)).tip_mm;
  ArmState state = one_joint(angle);
  add_run_out(state, {run_out});
  const Vector3d expected = Vector3d(0.0, 0.0, 0.003 * std::sin(angle)) +
                            1e-6 * std::cos(2.0 * angle) * Vector3d::UnitX().cross(tip);
  EXPECT_LT((frames_of(state).tip_mm - tip - expected).norm(), 1e-8);
}

TEST(BearingRunOut, RepeatsEveryTurnAndAddsUpToNothing) {
  RandomStream random(1);
  const auto drawn = drawn_run_out(1, BearingRunOut::typical(), random);
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  for (int i = 0; i < 12; ++i) {
    ArmState state = one_joint(2.0 * pi * i / 12.0);
    ArmState turned = one_joint(2.0 * pi * (i / 12.0 - 3.0));
    add_run_out(state, drawn);
    add_run_out(turned, drawn);
    sum.head<3>() += state.joints[0].tilt_rad;
    sum.tail<3>() += state.joints[0].shift_mm;
    EXPECT_LT((state.joints[0].shift_mm - turned.joints[0].shift_mm).norm(), 1e-15);
    EXPECT_EQ(state.joints[0].tilt_rad.z(), 0.0);  // that would be an error of the angle
  }
  EXPECT_LT(sum.norm(), 1e-15);
}

}  // namespace
}  // namespace armcal
