// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/joint_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;

JointChain random_chain(int joints, RandomStream& random) {
  JointChain chain;
  for (int i = 0; i < joints; ++i) {
    chain.joints.push_back(
        {testing::random_transform(random, 300.0), testing::random_direction(random), -2.0, 1.0});
  }
  chain.last_from_tip = testing::random_transform(random, 100.0);
  return chain;
}

// Poses agree to 1e-9 mm and 1e-12 rad: the promise to the user, with room to spare.
void expect_same_poses(const JointChain& chain, const ArmModel& arm, const std::string& what) {
  ASSERT_THAT(problems_of(arm), ElementsAre()) << what;
  RandomStream random(99);
  const ForwardKinematics kinematics(arm);
  for (int i = 0; i < 30; ++i) {
    const auto q = testing::random_posture(arm.joint_count(), random);
    const RigidTransform a = base_from_tip(chain, q);
    const RigidTransform b = kinematics.base_from_tip(q);
    EXPECT_LT((a.translation_mm - b.translation_mm).norm(), 1e-10) << what;
    EXPECT_LT((a.rotation - b.rotation).norm(), 1e-13) << what;
  }
}

double longest_offset_mm(const ArmModel& arm) {
  double longest = 0.0;
  for (const Link& link : arm.links) {
    longest = std::max(longest, std::hypot(link.a_mm, link.b_mm, link.d_mm));
  }
  return longest;
}

TEST(JointChain, AnyAxesAnywhereBecomeAnArmWithTheSamePoses) {
  RandomStream random(1);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    for (int i = 0; i < 20; ++i) {
      const JointChain chain = random_chain(n, random);
      expect_same_poses(chain, arm_from_chain(chain), std::to_string(n) + " joints");
    }
  }
}

TEST(JointChain, AxesAlongCoordinatesInEitherSense) {
  RandomStream random(2);
  for (int i = 0; i < 50; ++i) {
    JointChain chain = random_chain(6, random);
    for (ChainJoint& joint : chain.joints) {
      joint.axis_in_joint = (random.below(2) == 0 ? 1.0 : -1.0) *
                            Eigen::Vector3d::Unit(static_cast<Eigen::Index>(random.below(3)));
    }
    expect_same_poses(chain, arm_from_chain(chain), "coordinate axes");
  }
}

TEST(JointChain, HowNearParallelAxesMayBeNoLinkBecomesLong) {
  RandomStream random(3);
  for (double tilt = 1e-17; tilt < 1.0; tilt *= 3.0) {
    for (const double turn : {0.0, pi}) {  // parallel, antiparallel
      JointChain chain = random_chain(5, random);
      for (std::size_t i = 1; i < chain.joints.size(); ++i) {
        const Eigen::Vector3d axis = chain.joints[i - 1].axis_in_joint;
        chain.joints[i].parent_from_joint.rotation =
            rotation_from_vector(tilt * testing::random_direction(random)) *
            rotation_from_vector(turn * perpendicular_pair(axis).first) *
            rotation_from_vector(random.uniform(-3, 3) * axis);
        chain.joints[i].axis_in_joint = axis;
      }
      const ArmModel arm = arm_from_chain(chain);
      expect_same_poses(chain, arm, std::to_string(tilt));
      double longest = 0.0;
      for (const ChainJoint& joint : chain.joints) {
        longest = std::max(longest, joint.parent_from_joint.translation_mm.norm());
      }
      EXPECT_LE(longest_offset_mm(arm), longest * (1.0 + 1e-12));
    }
  }
}

TEST(JointChain, AxesThatMeetOrCoincide) {
  RandomStream random(4);
  JointChain chain = random_chain(6, random);
  for (ChainJoint& joint : chain.joints) joint.parent_from_joint.translation_mm.setZero();
  chain.joints[2].parent_from_joint.rotation.setIdentity();
  chain.joints[2].axis_in_joint = chain.joints[1].axis_in_joint;
  chain.joints[3].parent_from_joint.rotation.setIdentity();
  chain.joints[3].axis_in_joint = -chain.joints[2].axis_in_joint;
  expect_same_poses(chain, arm_from_chain(chain), "meeting axes");
}

TEST(JointChain, BetaIsUsedOnlyBetweenNearlyParallelAxes) {
  RandomStream random(5);
  for (int i = 0; i < 50; ++i) {
    for (const Link& link : arm_from_chain(random_chain(6, random)).links) {
      const bool nearly_parallel = std::abs(std::sin(link.alpha_rad)) < std::sin(pi / 18.0);
      EXPECT_TRUE(nearly_parallel ? link.b_mm == 0.0 : link.beta_rad == 0.0);
    }
  }
}

TEST(JointChain, AnArmComesBackWithTheSamePoses) {
  RandomStream random(6);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    const ArmModel arm = testing::random_arm(n, random, {.harmonics = 0});
    const ChainConversion there = chain_from_arm(arm);
    EXPECT_THAT(there.lost, ElementsAre());
    expect_same_poses(there.chain, arm, "there");
    const ArmModel back = arm_from_chain(there.chain);
    expect_same_poses(there.chain, back, "back");
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      EXPECT_EQ(back.joints[i].direction, arm.joints[i].direction);
    }
  }
}

TEST(JointChain, LinksInStandardFormComeBackUnchanged) {
  RandomStream random(7);
  ArmModel arm = testing::random_arm(7, random, {.arbitrary_twists = false, .beta = false});
  for (Joint& joint : arm.joints) joint.zero_rad = 0.0;
  const ArmModel back = arm_from_chain(chain_from_arm(arm).chain);
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    EXPECT_NEAR(back.links[i].d_mm, arm.links[i].d_mm, 1e-12);
    EXPECT_NEAR(back.links[i].b_mm, arm.links[i].b_mm, 1e-12);
    EXPECT_NEAR(back.links[i].a_mm, arm.links[i].a_mm, 1e-12);
    EXPECT_NEAR(back.links[i].alpha_rad, arm.links[i].alpha_rad, 1e-15);
    EXPECT_EQ(back.links[i].beta_rad, 0.0);
  }
}

TEST(JointChain, SaysThatHarmonicsAreLost) {
  RandomStream random(8);
  ArmModel arm = testing::random_arm(3, random, {.harmonics = 0});
  arm.joints[1].harmonics = {{1e-4, 0.0}};
  EXPECT_THAT(chain_from_arm(arm).lost, ElementsAre("encoder harmonics of joint 2"));
}

}  // namespace
}  // namespace armcal
