// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/circle_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/arm_from_axes.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/synthetic_readings.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::random_arm;
using testing::random_posture;

struct Arcs {
  ArmModel truth;
  Eigen::VectorXd home;
  RigidTransform reference_from_base;
  ObservationGroup group;
};

/// Points on arcs about every joint, evenly spread over `span_rad` about home.
Arcs arcs_of(const ArmModel& truth, const Eigen::VectorXd& home, RandomStream& random,
             double noise_mm = 0.0, double span_rad = 4.0, int points = 9) {
  Arcs arcs{truth, home, testing::random_transform(random, 1000.0), {}};
  const ForwardKinematics kinematics(truth);
  ObservationGroup& group = arcs.group;
  group.name = "arcs";
  group.kind = ReferenceKind::reference_points;
  const int rows = points * truth.joint_count();
  group.is_check.assign(static_cast<std::size_t>(rows), false);
  group.place.assign(static_cast<std::size_t>(rows), "cmm");
  group.u_mm = Eigen::VectorXd::Constant(rows, noise_mm > 0.0 ? noise_mm : 0.001);
  group.encoder_rad.resize(truth.joint_count(), rows);
  group.reference_mm.resize(3, rows);
  for (int row = 0; row < rows; ++row) {
    const int joint = row / points;
    Eigen::VectorXd e = home;
    e(joint) += span_rad * (static_cast<double>(row % points) / (points - 1) - 0.4);
    group.lines.push_back(row + 2);
    group.joint.push_back(joint + 1);
    group.encoder_rad.col(row) = e;
    group.reference_mm.col(row) = arcs.reference_from_base * kinematics.tip_in_base(as_span(e)) +
                                  noise_mm * testing::random_normal_vector(random);
  }
  return arcs;
}

/// A posture in which the tip is at least 50 mm away from every axis.
Eigen::VectorXd open_posture(const ArmModel& arm, RandomStream& random) {
  for (;;) {
    const std::vector<double> posture = random_posture(arm.joint_count(), random);
    const TipLinearisation at = ForwardKinematics(arm).linearise(posture);
    if (at.J_tip_encoder.colwise().norm().minCoeff() < 50.0) continue;
    return Eigen::Map<const Eigen::VectorXd>(posture.data(), arm.joint_count());
  }
}

Arcs romer_arcs(std::uint64_t seed, double noise_mm = 0.0) {
  RandomStream random(seed);
  const ArmModel truth = testing::perturbed(testing::consistent_romer(), random, 0.2, 5e-4);
  const Eigen::VectorXd home = open_posture(truth, random);
  return arcs_of(truth, home, random, noise_mm);
}

/// Rms distance of the tips of the arm found from the true ones over random postures.
double rms_off_mm(const CirclePointAnalysis& found, const Arcs& arcs) {
  const ForwardKinematics tip(found.arm);
  const ForwardKinematics true_tip(arcs.truth);
  RandomStream random(99);
  double squares = 0.0;
  constexpr int kPostures = 200;
  for (int i = 0; i < kPostures; ++i) {
    const std::vector<double> e = random_posture(arcs.truth.joint_count(), random);
    squares += (found.reference_from_base * tip.tip_in_base(e) -
                arcs.reference_from_base * true_tip.tip_in_base(e))
                   .squaredNorm();
  }
  return std::sqrt(squares / kPostures);
}

void expect_refused(const Arcs& arcs, CirclePointStatus status, const std::string& words,
                    const ArmModel& nominal = testing::consistent_romer()) {
  const CirclePointAnalysis found = analyse_circle_points(nominal, arcs.group);
  EXPECT_EQ(found.status, status) << explain(found.status) << ": " << found.detail;
  EXPECT_THAT(found.detail, HasSubstr(words));
}

TEST(CirclePoints, FindAnyArmFromArcsWithoutNoise) {
  RandomStream random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const int joints = 6 + trial % 2;
    const ArmModel nominal =
        random_arm(joints, random, {.arbitrary_twists = trial % 4 < 2, .beta = trial % 8 < 4});
    const ArmModel truth = testing::perturbed(nominal, random, 0.5, 2e-3);
    const Arcs arcs = arcs_of(truth, open_posture(truth, random), random);
    const CirclePointAnalysis found = analyse_circle_points(nominal, arcs.group);
    ASSERT_TRUE(found.ok()) << trial << ": " << explain(found.status) << ": " << found.detail;
    // Rounding of the coordinates (2e-13 mm at 1 to 2 m) over the smallest circle (50 mm), at a
    // reach of 3 m and seven times over.
    EXPECT_LT(rms_off_mm(found, arcs), 1e-9) << trial;
    EXPECT_LT(found.rms_mm, 1e-9);
    EXPECT_TRUE(found.reversed.empty());
  }
}

TEST(CirclePoints, FindTheAxesAndTheTipInTheHomePosture) {
  const Arcs arcs = romer_arcs(2);
  const CirclePointAnalysis found = analyse_circle_points(testing::consistent_romer(), arcs.group);
  ASSERT_TRUE(found.ok());
  const AxesAtPosture true_at = axes_at(arcs.truth, arcs.home);
  EXPECT_LT((found.home_rad - arcs.home).norm(), 1e-12);
  EXPECT_LT((found.tip_at_home_mm - arcs.reference_from_base * true_at.tip_mm).norm(), 1e-9);
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d direction = arcs.reference_from_base.rotation * true_at.axes[i].direction;
    const Eigen::Vector3d point = arcs.reference_from_base * true_at.axes[i].point_mm;
    EXPECT_LT((found.axes[i].direction - direction).norm(), 1e-12);
    EXPECT_LT((found.axes[i].center_mm - point).cross(direction).norm(), 1e-9);
    EXPECT_NEAR(found.axes[i].span_rad, 4.0, 1e-12);
  }
}

TEST(CirclePoints, KeepTheHarmonicsOfTheEncoders) {
  RandomStream random(3);
  const ArmModel truth = random_arm(6, random, {.arbitrary_twists = false, .harmonics = 2});
  const Arcs arcs = arcs_of(truth, open_posture(truth, random), random);
  const CirclePointAnalysis found = analyse_circle_points(truth, arcs.group);
  ASSERT_TRUE(found.ok()) << found.detail;
  EXPECT_LT(rms_off_mm(found, arcs), 1e-9);
}

TEST(CirclePoints, NameJointsThatCountAgainstTheNominalArm) {
  for (std::size_t joint = 0; joint < 6; ++joint) {
    ArmModel nominal = testing::consistent_romer();
    const Arcs arcs = romer_arcs(4);
    nominal.joints[joint].direction = -1;
    const CirclePointAnalysis found = analyse_circle_points(nominal, arcs.group);
    ASSERT_TRUE(found.ok()) << found.detail;
    EXPECT_THAT(found.reversed, ::testing::ElementsAre(static_cast<int>(joint) + 1));
    EXPECT_LT(rms_off_mm(found, arcs), 1e-9);
  }
}

TEST(CirclePoints, ErrInProportionToTheNoise) {
  double ratio = 0.0;
  constexpr int kTrials = 10;
  for (std::uint64_t seed = 10; seed < 10 + kTrials; ++seed) {
    const ArmModel nominal = testing::consistent_romer();
    const Arcs fine = romer_arcs(seed, 0.001);
    const Arcs coarse = romer_arcs(seed, 0.003);  // the same deviates, three times as large
    const CirclePointAnalysis one = analyse_circle_points(nominal, fine.group);
    const CirclePointAnalysis three = analyse_circle_points(nominal, coarse.group);
    ASSERT_TRUE(one.ok() && three.ok()) << one.detail << three.detail;
    ratio += rms_off_mm(three, coarse) / rms_off_mm(one, fine) / kTrials;
  }
  // What is left is the curvature of circles over a few micrometres.
  EXPECT_NEAR(ratio, 3.0, 0.01);
}

// Over 100 arcs each, squared errors over their variances average the degrees of freedom within
// 5 standard deviations: sqrt(2 * 2 / 100) * 5 = 1.
TEST(CirclePoints, KnowHowWellTheyKnowAnAxis) {
  double of_direction = 0.0;
  double of_center = 0.0;
  constexpr int kTrials = 100;
  for (std::uint64_t seed = 0; seed < kTrials; ++seed) {
    const Arcs arcs = romer_arcs(100 + seed, 0.003);
    const CirclePointAnalysis found =
        analyse_circle_points(testing::consistent_romer(), arcs.group);
    ASSERT_TRUE(found.ok()) << found.detail;
    const MeasuredAxis& axis = found.axes[2];
    const JointAxis truth = axes_at(arcs.truth, arcs.home).axes[2];
    const Eigen::Vector3d direction = arcs.reference_from_base.rotation * truth.direction;
    const Eigen::Vector3d off = axis.center_mm - arcs.reference_from_base * truth.point_mm;
    const auto [x, y] = perpendicular_pair(direction);
    Eigen::Matrix<double, 3, 2> across;
    across << x, y;
    const Eigen::Vector2d tilt = across.transpose() * axis.direction;
    const Eigen::Matrix2d cov_tilt =
        across.transpose() * axis.covariance.bottomRightCorner<3, 3>() * across;
    // The true line, where it passes the plane of the circle.
    const Eigen::Vector2d shift = across.transpose() * off;
    const Eigen::Matrix2d cov_shift =
        across.transpose() * axis.covariance.topLeftCorner<3, 3>() * across;
    of_direction += tilt.dot(cov_tilt.inverse() * tilt) / kTrials;
    of_center += shift.dot(cov_shift.inverse() * shift) / kTrials;
    EXPECT_GT(axis.u_direction_rad, 0.0);
    EXPECT_GE(axis.u_direction_rad * axis.u_direction_rad, cov_tilt.diagonal().maxCoeff() * 0.999);
  }
  EXPECT_NEAR(of_direction, 2.0, 1.0);
  EXPECT_NEAR(of_center, 2.0, 1.0);
}

TEST(CirclePoints, DoNotCountRowsThatAreHeldOut) {
  Arcs arcs = romer_arcs(5);
  arcs.group.is_check[3] = true;
  arcs.group.reference_mm.col(3).setConstant(1e6);
  arcs.group.encoder_rad.col(3).setConstant(3.0);
  const CirclePointAnalysis found = analyse_circle_points(testing::consistent_romer(), arcs.group);
  ASSERT_TRUE(found.ok()) << found.detail;
  EXPECT_LT(rms_off_mm(found, arcs), 1e-9);
}

TEST(CirclePoints, RefuseAJointWithoutArc) {
  Arcs arcs = romer_arcs(6);
  for (std::size_t row = 0; row < arcs.group.joint.size(); ++row) {
    if (arcs.group.joint[row] == 4) arcs.group.is_check[row] = true;
  }
  expect_refused(arcs, CirclePointStatus::joint_without_arc, "joint 4 has 0 points");
}

TEST(CirclePoints, RefuseATipOnTheLastAxis) {
  RandomStream random(7);
  ArmModel nominal = testing::consistent_romer();
  nominal.tip = {.d_mm = 150.0};
  for (const double noise_mm : {0.0, 0.003}) {
    Eigen::VectorXd home(6);
    home << 0.1, 0.8, 0.3, 1.2, -0.4, 0.9;
    const Arcs arcs = arcs_of(nominal, home, random, noise_mm);
    expect_refused(arcs, CirclePointStatus::tip_on_axis, "joint 6, turned by 229.2 deg", nominal);
  }
}

TEST(CirclePoints, RefuseArcsThatAreTooShort) {
  RandomStream random(8);
  const ArmModel truth = testing::consistent_romer();
  const Eigen::VectorXd home = open_posture(truth, random);
  expect_refused(arcs_of(truth, home, random, 0.003, 0.02), CirclePointStatus::arc_too_short,
                 "joint 1, turned by 1.1 deg");
  expect_refused(arcs_of(truth, home, random, 0.0, 1e-9), CirclePointStatus::arc_too_short,
                 "joint 1, turned by 0.0 deg");
}

TEST(CirclePoints, RefuseAnArcDuringWhichAnotherJointMoved) {
  Arcs arcs = romer_arcs(9);
  arcs.group.encoder_rad(4, 20) += 0.01;
  expect_refused(arcs, CirclePointStatus::other_joint_moved,
                 "in line 22, where joint 3 turns, joint 5 is 0.56");
}

TEST(CirclePoints, RefuseArcsOfTheWrongJoints) {
  Arcs arcs = romer_arcs(10);
  for (int& joint : arcs.group.joint) joint = joint == 3 ? 5 : (joint == 5 ? 3 : joint);
  expect_refused(arcs, CirclePointStatus::other_joint_moved, "joint");
  // The encoders are confused with them: every arc is as it should be, but the arm is another.
  arcs.group.encoder_rad.row(2).swap(arcs.group.encoder_rad.row(4));
  expect_refused(arcs, CirclePointStatus::unlike_nominal, "mm, nominal are");
}

TEST(CirclePoints, RefusePointsOffTheirCircle) {
  Arcs arcs = romer_arcs(11);
  arcs.group.reference_mm(0, 12) += 150.0;
  expect_refused(arcs, CirclePointStatus::not_a_circle, "the points of joint 2 are");
}

TEST(CirclePoints, RefuseAnEncoderOfOtherUnits) {
  Arcs arcs = romer_arcs(12);
  arcs.group.encoder_rad.block(1, 9, 1, 9).array() =
      arcs.home(1) + 0.9 * (arcs.group.encoder_rad.block(1, 9, 1, 9).array() - arcs.home(1));
  expect_refused(arcs, CirclePointStatus::encoder_disagrees, "the points of joint 2 are");
}

TEST(CirclePoints, RefuseArcsFromTwoHomePostures) {
  Arcs arcs = romer_arcs(13);
  // The reference machine was moved by 5 mm after joint 3.
  for (Eigen::Index row = 27; row < 54; ++row) arcs.group.reference_mm(2, row) += 5.0;
  expect_refused(arcs, CirclePointStatus::arcs_disagree, "put the tip at home 2.500 mm from");
}

TEST(CirclePoints, RefuseGroupsThatAreNoArcs) {
  const ArmModel nominal = testing::consistent_romer();
  Arcs arcs = romer_arcs(14);
  const auto refused = [&](const ObservationGroup& group) {
    EXPECT_THROW(static_cast<void>(analyse_circle_points(nominal, group)), std::invalid_argument);
  };
  ObservationGroup group = arcs.group;
  group.joint.clear();
  refused(group);
  group = arcs.group;
  group.joint[0] = 7;
  refused(group);
  group = arcs.group;
  group.place[5] = "another";
  refused(group);
  group = arcs.group;
  group.encoder_rad.conservativeResize(5, Eigen::NoChange);
  refused(group);
}

}  // namespace
}  // namespace armcal
