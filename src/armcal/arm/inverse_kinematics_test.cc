// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/inverse_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

VectorXd posture(int joint_count, RandomStream& random, double range_rad = pi) {
  const std::vector<double> angles = testing::random_posture(joint_count, random, range_rad);
  return Eigen::Map<const VectorXd>(angles.data(), joint_count);
}

Vector3d tip(const ForwardKinematics& kinematics, const VectorXd& e) {
  return kinematics.tip_in_base(as_span(e));
}

// Two links of 300 and 200 mm in a plane: what a person can work out.
ArmModel planar_arm() {
  ArmModel arm;
  arm.name = "planar";
  arm.joints.resize(2);
  arm.links = {{.a_mm = 300.0}};
  arm.tip.a_mm = 200.0;
  return arm;
}

TEST(InverseKinematics, PutsTheTipsOfRandomArmsOnPointsThatTheyReach) {
  RandomStream random(1);
  for (int joints = 3; joints <= 8; ++joints) {
    int found = 0;
    const int trials = 40;
    for (int i = 0; i < trials; ++i) {
      const ForwardKinematics kinematics(testing::random_arm(joints, random));
      const VectorXd goal = posture(joints, random);
      const Vector3d point = tip(kinematics, goal);
      // From near a posture that reaches it, always; from anywhere, mostly.
      const VectorXd beside = goal + 0.1 * posture(joints, random) / pi;
      const PostureSearch near = find_posture(kinematics, point, beside);
      EXPECT_TRUE(near.found) << joints << " joints, missed by " << near.miss_mm;
      EXPECT_LT((tip(kinematics, near.encoder_rad) - point).norm(), 1e-9);
      const VectorXd anywhere = posture(joints, random);
      found += find_posture(kinematics, point, anywhere).found ? 1 : 0;
      const PostureSearch patient = find_posture(kinematics, point, anywhere, {.restarts = 20});
      EXPECT_TRUE(patient.found) << joints << " joints, missed by " << patient.miss_mm;
    }
    // Of 1,000 it finds 846, 965, 987, 999, 1,000, 1,000 with 3 to 8 joints.
    EXPECT_GE(found, trials * (joints == 3 ? 7 : 8) / 10) << joints << " joints";
  }
}

TEST(InverseKinematics, StaysWhereTheTipIsThereAlready) {
  RandomStream random(2);
  const ForwardKinematics kinematics(testing::random_arm(6, random));
  const VectorXd start = posture(6, random);
  const PostureSearch search = find_posture(kinematics, tip(kinematics, start), start);
  EXPECT_TRUE(search.found);
  EXPECT_EQ(search.encoder_rad, start);
}

TEST(InverseKinematics, MovesNoMoreThanItMust) {
  // Of all postures of a redundant arm near the start, the one found is the nearest to first order:
  // the way to it has nothing in the directions that do not move the tip.
  RandomStream random(3);
  const ForwardKinematics kinematics(testing::random_arm(7, random));
  const VectorXd start = posture(7, random);
  const Vector3d point = tip(kinematics, start) + 0.1 * Vector3d(1.0, -2.0, 0.5);
  const PostureSearch search = find_posture(kinematics, point, start);
  ASSERT_TRUE(search.found);
  const Eigen::MatrixXd jacobian = kinematics.linearise({start.data(), 7}).J_tip_encoder;
  const VectorXd way = search.encoder_rad - start;
  const VectorXd idle =
      way - jacobian.transpose() * (jacobian * jacobian.transpose()).inverse() * jacobian * way;
  EXPECT_LT(idle.norm(), 1e-3 * way.norm());
}

TEST(InverseKinematics, MovesOnlyTheJointsThatMay) {
  RandomStream random(4);
  const ForwardKinematics kinematics(testing::random_arm(6, random));
  for (int i = 0; i < 10; ++i) {
    const VectorXd start = posture(6, random);
    VectorXd goal = start;
    for (const int joint : {2, 3, 5}) goal(joint - 1) += random.uniform(-0.2, 0.2);
    const PostureSearch search =
        find_posture(kinematics, tip(kinematics, goal), start, {.joints = {2, 3, 5}});
    EXPECT_TRUE(search.found);
    for (const int joint : {1, 4, 6}) EXPECT_EQ(search.encoder_rad(joint - 1), start(joint - 1));
  }
}

TEST(InverseKinematics, FoldsAnArmThatIsStretchedStraight) {
  // Along the stretched arm no joint moves the tip, and no step of Newton leads away.
  const ForwardKinematics kinematics(planar_arm());
  const PostureSearch search =
      find_posture(kinematics, Vector3d(400.0, 0.0, 0.0), VectorXd::Zero(2));
  EXPECT_TRUE(search.found);
  const double elbow = std::acos((400.0 * 400.0 - 300.0 * 300.0 - 200.0 * 200.0) / 120000.0);
  EXPECT_NEAR(std::abs(search.encoder_rad(1)), elbow, 1e-9);
}

TEST(InverseKinematics, ArrivesAtTheEdgeOfReach) {
  // A micrometre inside it the posture is all but singular.
  const ForwardKinematics kinematics(planar_arm());
  RandomStream random(5);
  for (int i = 0; i < 20; ++i) {
    const double azimuth = random.uniform(-pi, pi);
    const Vector3d point = 499.999 * Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0);
    const PostureSearch search = find_posture(kinematics, point, posture(2, random));
    EXPECT_TRUE(search.found) << search.miss_mm;
  }
}

TEST(InverseKinematics, EndsNearestToAPointOutOfReach) {
  const ForwardKinematics kinematics(planar_arm());
  RandomStream random(6);
  for (int i = 0; i < 10; ++i) {
    const PostureSearch far =
        find_posture(kinematics, Vector3d(520.0, 390.0, 0.0), posture(2, random));
    EXPECT_FALSE(far.found);
    EXPECT_NEAR(far.miss_mm, 650.0 - 500.0, 1e-3);
    const PostureSearch aside =
        find_posture(kinematics, Vector3d(100.0, 300.0, 40.0), posture(2, random));
    EXPECT_FALSE(aside.found);
    EXPECT_NEAR(aside.miss_mm, 40.0, 1e-3);
  }
}

TEST(InverseKinematics, RefusesPointsThatAreNoNumbers) {
  const ForwardKinematics kinematics(planar_arm());
  const PostureSearch search =
      find_posture(kinematics, Vector3d(std::nan(""), 0.0, 0.0), VectorXd::Zero(2));
  EXPECT_FALSE(search.found);
  EXPECT_EQ(search.encoder_rad, VectorXd::Zero(2));
}

TEST(InverseKinematics, KeepsToTheLimits) {
  RandomStream random(7);
  ArmModel arm = testing::consistent_romer();
  for (Joint& joint : arm.joints) {
    joint.min_rad = -2.0;
    joint.max_rad = 1.5;
  }
  const ForwardKinematics kinematics(arm);
  const JointLimits limits = joint_limits(arm);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    VectorXd goal(6);
    for (double& angle : goal) angle = random.uniform(-2.0, 1.5);
    const PostureSearch search =
        find_posture(kinematics, tip(kinematics, goal), posture(6, random), {.limits = limits});
    EXPECT_TRUE((search.encoder_rad.array() >= limits.min_rad.array()).all());
    EXPECT_TRUE((search.encoder_rad.array() <= limits.max_rad.array()).all());
    found += search.found ? 1 : 0;
    const PostureSearch patient = find_posture(kinematics, tip(kinematics, goal), goal.reverse(),
                                               {.limits = limits, .restarts = 20});
    EXPECT_TRUE(patient.found) << patient.miss_mm;
    EXPECT_TRUE((patient.encoder_rad.array() >= limits.min_rad.array()).all());
    EXPECT_TRUE((patient.encoder_rad.array() <= limits.max_rad.array()).all());
  }
  EXPECT_GE(found, 70);
}

TEST(InverseKinematics, LetsOtherJointsMakeUpForOneAtItsLimit) {
  ArmModel arm = testing::consistent_romer();
  arm.joints[1].min_rad = 0.0;
  const ForwardKinematics kinematics(arm);
  const VectorXd start = testing::degrees({10, 0, 20, 40, 30, 50});
  VectorXd freely = start;
  freely(1) = -0.3;
  const PostureSearch search =
      find_posture(kinematics, tip(kinematics, freely), start, {.limits = joint_limits(arm)});
  EXPECT_TRUE(search.found);
  EXPECT_GE(search.encoder_rad(1), 0.0);
}

TEST(InverseKinematics, BringsReadingsInsideByWholeTurns) {
  JointLimits limits{VectorXd(5), VectorXd(5)};
  limits.min_rad << -3.0, -3.0, -HUGE_VAL, 4.0, -1.0;
  limits.max_rad << 3.0, 3.0, HUGE_VAL, HUGE_VAL, 1.0;
  VectorXd readings(5);
  readings << 2.0 + 6.0 * pi, -2.0 - 2.0 * pi, 100.0, -1.0, 1.2;
  const VectorXd inside = brought_inside(readings, limits);
  EXPECT_NEAR(inside(0), 2.0, 1e-12);
  EXPECT_NEAR(inside(1), -2.0, 1e-12);
  EXPECT_EQ(inside(2), 100.0);
  EXPECT_NEAR(inside(3), -1.0 + 2.0 * pi, 1e-12);
  EXPECT_EQ(inside(4), 1.0);  // no turn helps: to the nearer limit
}

}  // namespace
}  // namespace armcal
