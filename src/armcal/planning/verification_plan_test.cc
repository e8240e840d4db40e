// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/planning/verification/articulations.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

VerificationPlanWishes on_a_bench() {
  VerificationPlanWishes wishes;
  wishes.room.surroundings = {.column_radius_mm = 60.0, .column_top_mm = 0.0, .bench_mm = -200.0};
  return wishes;
}

VerificationPlanWishes of_iso_alone() {
  VerificationPlanWishes wishes = on_a_bench();
  wishes.b89_4_22 = false;
  return wishes;
}

VerificationPlanWishes of_b89_alone() {
  VerificationPlanWishes wishes = on_a_bench();
  wishes.iso10360_12 = false;
  return wishes;
}

// Planned once for all tests that look at them.
const VerificationPlan& plan_for_six_joints() {
  static const VerificationPlan plan = plan_verification(testing::consistent_romer(), on_a_bench());
  return plan;
}
const VerificationPlan& plan_for_seven_joints() {
  static const VerificationPlan plan = plan_verification(seven_joint_arm(), on_a_bench());
  return plan;
}

double distance_mm(const VerificationPlan& plan, const Eigen::Vector3d& point_mm) {
  return (point_mm - plan.arm.base_from_first_joint.translation_mm).norm();
}

// The laws of every plan: the arm is where it is said to be, breaks no limit and runs into nothing,
// and no stylus passes through the sphere that it touches.
void expect_sound(const VerificationPlan& plan) {
  const ForwardKinematics kinematics(plan.arm);
  for (const PlannedTest& test : plan.tests) {
    for (const PlannedTouch& row : test.touches) {
      const auto posture = as_span(row.encoder_rad);
      const TipLinearisation at = kinematics.linearise(posture);
      ASSERT_LT((at.tip_mm - row.touch.tip_mm).norm(), 1e-6) << test.name;
      ASSERT_EQ(broken_limit(plan.arm, posture), std::nullopt) << test.name;
      ASSERT_EQ(collision(kinematics, posture, plan.wishes.room.surroundings), std::nullopt)
          << test.name;
      // 1e-9: rounding of a unit vector.
      const Eigen::Vector3d last_joint = at.joint_origins_mm.rightCols<1>();
      ASSERT_GE(row.touch.outward.dot((last_joint - row.touch.tip_mm).normalized()), -1e-9)
          << test.name;
    }
  }
}

std::string refusal(const ArmModel& arm, const VerificationPlanWishes& wishes) {
  try {
    const VerificationPlan plan = plan_verification(arm, wishes);
    return "none";
  } catch (const ImpossiblePlan& impossible) {
    return impossible.what();
  }
}

TEST(VerificationPlan, HasAllPointsOfTheStandardsOnAnArmOfSixJoints) {
  const VerificationPlan& plan = plan_for_six_joints();
  expect_sound(plan);
  ASSERT_EQ(plan.tests.size(), 6u);
  EXPECT_EQ(plan.tests[0].touches.size(), 2u * 25u);
  EXPECT_EQ(plan.tests[1].touches.size(), 5u * 5u);
  EXPECT_EQ(plan.tests[2].touches.size(), 7u * 5u * 3u * 2u);
  EXPECT_EQ(plan.tests[3].touches.size(), 3u * 9u);
  EXPECT_EQ(plan.tests[4].touches.size(), 3u * 10u);
  EXPECT_EQ(plan.tests[5].touches.size(), 20u * 2u);
}

TEST(VerificationPlan, OfIsoPutsOneSphereNearAndOneFar) {
  const VerificationPlan& plan = plan_for_seven_joints();
  expect_sound(plan);
  const auto& spheres = plan.tests[0].spheres;
  ASSERT_EQ(spheres.size(), 2u);
  EXPECT_LT(distance_mm(plan, spheres[0].centre_mm), 0.45 * plan.reach_mm);
  EXPECT_GT(distance_mm(plan, spheres[1].centre_mm), 0.65 * plan.reach_mm);
  EXPECT_EQ(plan.tests[0].touches.front().position, "near");
  EXPECT_EQ(plan.tests[0].touches.back().position, "far");
  // The ball of the tip rolls on the sphere: 25 and 6 mm.
  for (const PlannedTouch& row : plan.tests[0].touches) {
    const auto& sphere = spheres[row.position == "near" ? 0 : 1];
    EXPECT_NEAR((row.touch.tip_mm - sphere.centre_mm).norm(), 15.5, 1e-9);
  }
}

TEST(VerificationPlan, ArticulationsHoldTheStylusStillAndTheElbowOnEitherSide) {
  const VerificationPlan& plan = plan_for_seven_joints();
  const TouchSearch search(plan.arm, plan.wishes.room);
  std::map<int, Eigen::Vector3d> stylus;
  std::set<bool> left;
  for (const PlannedTouch& row : plan.tests[1].touches) {
    const Eigen::Vector3d direction = search.stylus_direction(row.encoder_rad);
    if (row.point == 1) stylus[row.articulation] = direction;
    if (row.point == 1) left.insert(search.elbow_mm(row.encoder_rad) > 0.0);
    EXPECT_GE(direction.dot(stylus[row.articulation]), kSteadyCosine);
  }
  EXPECT_EQ(stylus.size(), 5u);
  EXPECT_EQ(left.size(), 2u);
}

TEST(VerificationPlan, LengthsLieOnTheirBarsAlongAxesAndDiagonals) {
  const VerificationPlan& plan = plan_for_six_joints();
  const PlannedTest& test = plan.tests[2];
  ASSERT_EQ(test.bars.size(), 7u);
  EXPECT_GE(test.bars.front().lengths_mm.back(), 0.66 * plan.reach_mm);
  const Eigen::Vector3d x = (test.bars[0].to_mm - test.bars[0].from_mm).normalized();
  EXPECT_NEAR(std::abs(x.x()), 1.0, 1e-12);
  const Eigen::Vector3d diagonal = (test.bars[3].to_mm - test.bars[3].from_mm).normalized();
  EXPECT_NEAR(std::abs(diagonal.dot(Eigen::Vector3d::Ones().normalized())), 1.0, 1e-12);
  for (std::size_t i = 0; i < test.touches.size(); i += 2) {
    const PlannedTouch& a = test.touches[i];
    const PlannedTouch& b = test.touches[i + 1];
    EXPECT_EQ(a.end, 'A');
    EXPECT_EQ(b.end, 'B');
    EXPECT_EQ(a.repeat, b.repeat);
    EXPECT_NEAR((b.touch.tip_mm - a.touch.tip_mm).norm(), a.length_mm, 1e-9);
  }
}

TEST(VerificationPlan, SeatsOfB89StandInTheirZonesWithTenArticulationsEach) {
  for (const VerificationPlan& plan : {plan_for_six_joints(), plan_for_seven_joints()}) {
    const auto& seats = plan.tests[4].seats;
    ASSERT_EQ(seats.size(), 3u);
    EXPECT_LT(distance_mm(plan, seats[0].at_mm), 0.2 * plan.reach_mm);
    EXPECT_GT(distance_mm(plan, seats[1].at_mm), 0.2 * plan.reach_mm);
    EXPECT_LT(distance_mm(plan, seats[1].at_mm), 0.8 * plan.reach_mm);
    EXPECT_GT(distance_mm(plan, seats[2].at_mm), 0.8 * plan.reach_mm);
    std::map<std::string, int> count;
    for (const PlannedTouch& row : plan.tests[4].touches) ++count[row.position];
    EXPECT_EQ(count, (std::map<std::string, int>{{"near", 10}, {"middle", 10}, {"far", 10}}));
  }
}

TEST(VerificationPlan, BarsOfB89AreTwentyPlacementsOfTwoLengths) {
  const VerificationPlan& plan = plan_for_seven_joints();
  const PlannedTest& test = plan.tests[5];
  std::map<double, int> count;
  for (const PlannedBar& bar : test.bars) {
    ++count[bar.lengths_mm.front()];
    EXPECT_NEAR((bar.to_mm - bar.from_mm).norm(), bar.lengths_mm.front(), 1e-9);
  }
  EXPECT_EQ(count, (std::map<double, int>{{1050.0, 10}, {2100.0, 10}}));  // 60, 120 % of 1733 mm
  EXPECT_EQ(test.touches.size(), 40u);
  // The verification of a length that leaves joints still would prove little.
  EXPECT_GT(plan.joint_coverage.minCoeff(), 0.5);
}

TEST(VerificationPlan, KeepsToStopsAndVolumeWhereverTheArmStands) {
  RandomStream random(5);
  ArmModel arm = testing::consistent_romer();
  for (Joint& joint : arm.joints) {
    joint.min_rad = -2.6;
    joint.max_rad = 2.6;
  }
  arm.base_from_first_joint = testing::random_transform(random, 1000.0);
  VerificationPlanWishes wishes = of_b89_alone();
  const Eigen::Vector3d foot = arm.base_from_first_joint.translation_mm;
  wishes.room.volume = MeasuringVolume{foot.array() - 1250.0, foot.array() + 1250.0};
  const VerificationPlan plan = plan_verification(arm, wishes);
  expect_sound(plan);
  for (const PlannedTest& test : plan.tests) {
    for (const PlannedTouch& row : test.touches) {
      EXPECT_LE((row.touch.tip_mm - foot).lpNorm<Eigen::Infinity>(), 1250.0);
    }
  }
}

TEST(VerificationPlan, OfATestDoesNotDependOnTheOthersButOnTheSeed) {
  VerificationPlanWishes alone = of_b89_alone();
  const auto& both = plan_for_six_joints();
  const auto same = plan_verification(testing::consistent_romer(), alone);
  alone.seed = 2;
  const auto other = plan_verification(testing::consistent_romer(), alone);
  for (std::size_t i = 0; i < same.tests[2].touches.size(); ++i) {
    EXPECT_EQ(both.tests[5].touches[i].encoder_rad, same.tests[2].touches[i].encoder_rad);
    EXPECT_NE(both.tests[5].touches[i].encoder_rad, other.tests[2].touches[i].encoder_rad);
  }
}

TEST(VerificationPlan, AnArmTooSmallForItsLengthsIsTold) {
  ArmModel small = testing::consistent_romer();
  for (Link& link : small.links) link.b_mm *= 0.2;
  VerificationPlanWishes wishes = of_iso_alone();
  wishes.lengths_mm = {100.0, 300.0, 500.0, 800.0, 1000.0};
  const std::string told = refusal(small, wishes);
  EXPECT_THAT(told, HasSubstr("length_uni: no place for a bar of 1000 mm along x: of 1000 places "
                              "tried"));
  EXPECT_THAT(told, HasSubstr("diagonal -x -y +z"));
  EXPECT_THAT(told, HasSubstr("out of reach"));
}

// Seats stand 45 deg above the level at most, so the far zone ends at 0.97 sin 45 deg = 0.69 of the
// reach above it.
TEST(VerificationPlan, ABenchThatHidesTheFarZoneIsTold) {
  VerificationPlanWishes wishes = of_b89_alone();
  wishes.room.surroundings.bench_mm = 0.7 * reach_mm(testing::consistent_romer());
  EXPECT_THAT(refusal(testing::consistent_romer(), wishes),
              AllOf(HasSubstr("no place for the far seat, 1"),
                    HasSubstr("of 3000 places tried, 3000 were below the bench")));
}

TEST(VerificationPlan, RefusesSizesThatAreNone) {
  const ArmModel arm = testing::consistent_romer();
  VerificationPlanWishes wishes;
  wishes.sphere_diameter_mm = -1.0;
  EXPECT_THROW((void)plan_verification(arm, wishes), std::invalid_argument);
  wishes = {};
  wishes.lengths_mm = {300.0, 300.0};
  EXPECT_THROW((void)plan_verification(arm, wishes), std::invalid_argument);
  wishes = {};
  wishes.reach_mm = std::nan("");
  EXPECT_THROW((void)plan_verification(arm, wishes), std::invalid_argument);
}

}  // namespace
}  // namespace armcal
