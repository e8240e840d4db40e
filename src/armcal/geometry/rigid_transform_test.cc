// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/rigid_transform.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "armcal/core/random.h"
#include "armcal/testing/random_geometry.h"

namespace armcal {
namespace {

using std::numbers::pi;
using testing::random_direction;

TEST(RigidTransform, NamesCancel) {
  RandomStream random(1);
  const RigidTransform a_from_b{rotation_from_vector(2.0 * random_direction(random)), {1, 2, 3}};
  const RigidTransform b_from_c{rotation_from_vector(0.5 * random_direction(random)), {-4, 5, 6}};
  const Eigen::Vector3d point_in_c(7, -8, 9);
  EXPECT_NEAR((a_from_b * b_from_c * point_in_c - a_from_b * (b_from_c * point_in_c)).norm(), 0,
              1e-14);
  EXPECT_NEAR((a_from_b.inverse() * (a_from_b * point_in_c) - point_in_c).norm(), 0, 1e-14);
}

TEST(RotationVector, RoundTripsFromTinyAnglesToHalfTurns) {
  RandomStream random(2);
  for (const double angle : {0.0, 1e-300, 1e-14, 1e-9, 9.9e-5, 1.01e-4, 0.1, 1.0, 3.0, pi - 1e-9}) {
    const Eigen::Vector3d vector = angle * random_direction(random);
    const Eigen::Matrix3d rotation = rotation_from_vector(vector);
    EXPECT_NEAR((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 2e-15);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-15);
    EXPECT_NEAR((vector_from_rotation(rotation) - vector).norm(), 0, 1e-15 + 1e-14 * angle)
        << angle;
  }
}

TEST(RotationVector, HalfTurnIsFoundUpToItsSign) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -2) / 3.0;
  const Eigen::Vector3d found = vector_from_rotation(rotation_from_vector(pi * axis));
  EXPECT_NEAR(found.norm(), pi, 1e-15);
  EXPECT_NEAR(std::abs(found.dot(axis)), pi, 1e-14);
}

TEST(RotationVector, AgreesWithEigenAngleAxis) {
  RandomStream random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d axis = random_direction(random);
    const double angle = random.uniform(0.0, pi);
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_NEAR((rotation_from_vector(angle * axis) - expected).norm(), 0, 3e-15);
  }
}

TEST(RollPitchYaw, IsTheProductOfFixedAxisRotations) {
  const Eigen::Vector3d rpy(0.3, -0.7, 2.1);
  const Eigen::Matrix3d expected = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  EXPECT_NEAR((rotation_from_roll_pitch_yaw(rpy) - expected).norm(), 0, 1e-15);
  EXPECT_NEAR((roll_pitch_yaw_from_rotation(expected) - rpy).norm(), 0, 1e-15);
}

TEST(RollPitchYaw, GivesTheSameRotationWhereTheAnglesAreNotUnique) {
  for (const double pitch : {pi / 2, -pi / 2}) {
    const Eigen::Matrix3d rotation = rotation_from_roll_pitch_yaw({0.4, pitch, 1.1});
    const Eigen::Vector3d found = roll_pitch_yaw_from_rotation(rotation);
    EXPECT_NEAR((rotation_from_roll_pitch_yaw(found) - rotation).norm(), 0, 1e-15);
  }
}

TEST(RollPitchYaw, KeepsTheRotationHoweverNearItsAnglesAreToNotUnique) {
  // Of matrices with rounding, as products have. Roll and yaw by themselves, each from its own
  // entries, missed by 1e-16 / cos(pitch): 0.35 rad at the worst.
  RandomStream random(5);
  for (double off = 1e-17; off < 1.0; off *= 3.0) {
    for (int i = 0; i < 50; ++i) {
      const Eigen::Matrix3d turn = testing::random_transform(random, 1.0).rotation;
      const Eigen::Matrix3d rotation =
          turn.transpose() *
          (turn * rotation_from_roll_pitch_yaw(
                      {random.uniform(-3, 3), pi / 2 - off, random.uniform(-3, 3)}));
      const Eigen::Vector3d found = roll_pitch_yaw_from_rotation(rotation);
      EXPECT_NEAR((rotation_from_roll_pitch_yaw(found) - rotation).norm(), 0, 1e-14) << off;
    }
  }
}

TEST(PerpendicularPair, CompletesARightHandedTriad) {
  RandomStream random(4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d axis = random_direction(random);
    const auto [first, second] = perpendicular_pair(axis);
    EXPECT_NEAR((first.cross(second) - axis).norm(), 0, 1e-15);
    EXPECT_NEAR(first.norm(), 1, 1e-15);
  }
}

TEST(RotationBetween, TurnsOneDirectionOntoAnotherByTheLeastAngle) {
  RandomStream random(31);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector3d from = testing::random_normal_vector(random).normalized();
    const Eigen::Vector3d onto = testing::random_normal_vector(random).normalized();
    const Eigen::Matrix3d rotation = rotation_between(from, onto);
    EXPECT_LT((rotation * from - onto).norm(), 1e-14);
    EXPECT_NEAR(vector_from_rotation(rotation).norm(), std::acos(from.dot(onto)), 1e-7);
  }
}

TEST(RotationBetween, OppositeDirectionsIsHalfATurnAndEqualOnesNone) {
  const Eigen::Vector3d from = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  EXPECT_LT((rotation_between(from, -from) * from + from).norm(), 1e-14);
  EXPECT_LT((rotation_between(from, from) - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace armcal
