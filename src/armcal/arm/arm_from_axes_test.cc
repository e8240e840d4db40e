// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/arm_from_axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using testing::random_arm;
using testing::random_posture;

Eigen::VectorXd posture_of(int joints, RandomStream& random) {
  const std::vector<double> posture = random_posture(joints, random);
  return Eigen::Map<const Eigen::VectorXd>(posture.data(), joints);
}

AxesAtPosture moved(AxesAtPosture at, const RigidTransform& frame_from_base, RandomStream& random) {
  for (JointAxis& axis : at.axes) {
    axis.point_mm = frame_from_base *
                    Eigen::Vector3d(axis.point_mm + random.uniform(-500, 500) * axis.direction);
    axis.direction = frame_from_base.rotation * axis.direction;
  }
  at.tip_mm = frame_from_base * at.tip_mm;
  return at;
}

/// Largest distance of the tips of the arm found from those of the truth, over random postures.
double largest_difference_mm(const ArmFromAxes& found, const ArmModel& truth,
                             const RigidTransform& frame_from_base, RandomStream& random) {
  const ForwardKinematics found_tip(found.arm);
  const ForwardKinematics true_tip(truth);
  double largest = 0.0;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> e = random_posture(truth.joint_count(), random);
    const Eigen::Vector3d difference = found.frame_from_base * found_tip.tip_in_base(e) -
                                       frame_from_base * true_tip.tip_in_base(e);
    largest = std::max(largest, difference.norm());
  }
  return largest;
}

ArmModel with_errors(ArmModel arm, RandomStream& random, double u_mm, double u_rad) {
  const ParameterTable table(arm);
  Eigen::VectorXd values = table.nominal();
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].harmonic > 0) continue;
    values(i) += (table[i].unit == ParameterUnit::mm ? u_mm : u_rad) * random.normal();
  }
  return with_parameter_values(arm, values);
}

TEST(ArmFromAxes, MovesAsTheArmWhoseAxesItWasGiven) {
  RandomStream random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int joints = 2 + trial % 9;
    const ArmModel pattern = random_arm(joints, random, {.arbitrary_twists = trial % 2 == 0});
    ArmModel truth = with_errors(pattern, random, 1.0, 5e-3);
    for (std::size_t i = 0; i < truth.links.size(); ++i) {
      // Only the pattern's beta, or the axes may not be joined.
      truth.links[i].beta_rad = pattern.links[i].beta_rad;
    }
    const RigidTransform frame_from_base = testing::random_transform(random, 1000.0);
    const auto found = arm_from_axes(
        pattern, moved(axes_at(truth, posture_of(joints, random)), frame_from_base, random));
    ASSERT_TRUE(found) << trial;
    // Ten joints turn what rounding (1e-13 mm at 1 m) and twists of 10 deg (factor 6) leave.
    EXPECT_LT(largest_difference_mm(*found, truth, frame_from_base, random), 1e-9) << trial;
  }
}

TEST(ArmFromAxes, IsThePatternWhereTheAxesAreThePatterns) {
  RandomStream random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const int joints = 2 + trial % 9;
    const ArmModel pattern = random_arm(joints, random);
    const auto found = arm_from_axes(pattern, axes_at(pattern, posture_of(joints, random)));
    ASSERT_TRUE(found);
    EXPECT_LT((parameter_values(found->arm) - parameter_values(pattern)).cwiseAbs().maxCoeff(),
              1e-9);
    EXPECT_LT((found->frame_from_base.translation_mm).norm(), 1e-9);
  }
}

TEST(ArmFromAxes, KeepsWhatAxesCannotTell) {
  RandomStream random(3);
  const ArmModel pattern = random_arm(6, random, {.arbitrary_twists = false});
  const ArmModel truth = with_errors(pattern, random, 1.0, 1e-3);
  const auto found = arm_from_axes(pattern, axes_at(truth, posture_of(6, random)));
  ASSERT_TRUE(found);
  const ParameterTable nominal(pattern);
  const Eigen::VectorXd values = parameter_values(found->arm);
  int kept = 0;
  for (int i = 0; i < nominal.size(); ++i) {
    if (nominal[i].harmonic == 0 && values(i) == nominal[i].nominal) ++kept;
  }
  // zero1, zero6, d2 to d6, d7 (n + 2), and beta2 to beta6.
  EXPECT_EQ(kept, 6 + 2 + 5);
}

TEST(ArmFromAxes, TakesParallelAndCoincidentAxesAsTheyAre) {
  RandomStream random(4);
  for (const double apart_mm : {0.0, 200.0}) {
    ArmModel pattern = random_arm(6, random, {.arbitrary_twists = false, .beta = false});
    for (const std::size_t link : {std::size_t{0}, std::size_t{2}}) {
      pattern.links[link].alpha_rad = 0.0;
      pattern.links[link].a_mm = apart_mm;
      pattern.links[link].b_mm = 0.0;
    }
    const ArmModel truth = with_errors(pattern, random, 0.1, 5e-4);
    const Eigen::VectorXd posture = posture_of(6, random);
    for (const ArmModel& arm : {pattern, truth}) {
      const auto found = arm_from_axes(pattern, axes_at(arm, posture));
      ASSERT_TRUE(found);
      EXPECT_LT(largest_difference_mm(*found, arm, {}, random), 1e-9);
    }
  }
}

TEST(ArmFromAxes, KeepsAnglesNearThePatternsBeyondAWholeTurn) {
  RandomStream random(5);
  ArmModel pattern = random_arm(6, random, {.arbitrary_twists = false, .beta = false});
  pattern.links[1].alpha_rad += 2.0 * std::numbers::pi;
  pattern.joints[2].zero_rad -= 4.0 * std::numbers::pi;
  const ArmModel truth = with_errors(pattern, random, 0.1, 1e-3);
  const auto found = arm_from_axes(pattern, axes_at(truth, posture_of(6, random)));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->arm.links[1].alpha_rad, pattern.links[1].alpha_rad, 0.01);
  EXPECT_NEAR(found->arm.joints[2].zero_rad, pattern.joints[2].zero_rad, 0.01);
}

TEST(ArmFromAxes, RefusesALinkThatCannotJoinTwoAxes) {
  RandomStream random(6);
  ArmModel pattern = random_arm(3, random, {.beta = false});
  pattern.links[0].alpha_rad = 0.3;
  AxesAtPosture at = axes_at(pattern, posture_of(3, random));
  pattern.links[0].beta_rad = 0.5;
  EXPECT_FALSE(arm_from_axes(pattern, at));
}

}  // namespace
}  // namespace armcal
