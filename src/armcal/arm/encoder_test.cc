// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/encoder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/numerics/derivative_check.h"

namespace armcal {
namespace {

Joint eccentric_joint() {
  Joint joint;
  joint.zero_rad = 0.3;
  joint.direction = -1;
  joint.harmonics = {{2e-4, -1e-4}, {0.0, 3e-5}};
  return joint;
}

TEST(Encoder, CountsFromItsZeroInItsDirection) {
  Joint joint;
  EXPECT_EQ(joint_angle(joint, 1.5), 1.5);
  joint.zero_rad = 0.25;
  EXPECT_EQ(joint_angle(joint, 1.5), 1.75);
  joint.direction = -1;
  EXPECT_EQ(joint_angle(joint, 1.5), -1.75);
}

TEST(Encoder, AddsTheHarmonicsOfTheReading) {
  const double e = 0.8;
  EXPECT_DOUBLE_EQ(joint_angle(eccentric_joint(), e),
                   -(e + 0.3) + 2e-4 * std::cos(e) - 1e-4 * std::sin(e) + 3e-5 * std::sin(2 * e));
}

TEST(Encoder, SlopeIsTheDerivative) {
  const Joint joint = eccentric_joint();
  for (const double e : {-2.0, 0.0, 0.7, 3.0}) {
    const auto reference = jacobian_by_differences(
        [&](const Eigen::VectorXd& x) {
          return Eigen::VectorXd::Constant(1, joint_angle(joint, x(0)));
        },
        Eigen::VectorXd::Constant(1, e), Eigen::VectorXd::Constant(1, 0.1));
    EXPECT_NEAR(joint_angle_slope(joint, e), reference(0, 0), 1e-11);
  }
}

TEST(Encoder, InverseFindsTheReading) {
  const Joint joint = eccentric_joint();
  for (const double e : {-3.0, -0.4, 0.0, 1.9}) {
    EXPECT_NEAR(encoder_at_joint_angle(joint, joint_angle(joint, e), e + 0.1), e, 1e-14);
  }
  EXPECT_NEAR(encoder_at_joint_angle(Joint{}, 0.7, 0.0), 0.7, 1e-16);
}

}  // namespace
}  // namespace armcal
