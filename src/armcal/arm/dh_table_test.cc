// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/dh_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/diagnostics.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using std::numbers::pi;
using ::testing::Contains;
using ::testing::HasSubstr;

DhTable random_table(DhConvention convention, int rows, RandomStream& random) {
  DhTable table;
  table.convention = convention;
  for (int i = 0; i < rows; ++i) {
    table.rows.push_back({random.uniform(-pi, pi), 300.0 * random.normal(), 100.0 * random.normal(),
                          random.uniform(-pi, pi)});
  }
  table.base_from_first = testing::random_transform(random, 200.0);
  table.last_from_tool = testing::random_transform(random, 100.0);
  return table;
}

// Largest difference of two poses over random readings: mm, and rotation times one metre.
template <typename PoseA, typename PoseB>
double worst_pose_difference(int joints, const PoseA& a, const PoseB& b, RandomStream& random) {
  double worst = 0.0;
  for (int i = 0; i < 30; ++i) {
    const auto q = testing::random_posture(joints, random);
    const RigidTransform one = a(q);
    const RigidTransform other = b(q);
    worst = std::max(worst, (one.translation_mm - other.translation_mm).norm());
    worst = std::max(worst, 1000.0 * (one.rotation - other.rotation).norm());
  }
  return worst;
}

TEST(DhTable, BecomesAnArmWithTheSamePoses) {
  RandomStream random(1);
  for (const DhConvention convention : {DhConvention::classic, DhConvention::modified}) {
    for (int n = 2; n <= 8; ++n) {
      const DhTable table = random_table(convention, n, random);
      const ForwardKinematics kinematics(arm_from_dh(table));
      EXPECT_LT(worst_pose_difference(
                    n, [&](const auto& q) { return base_from_tool(table, q); },
                    [&](const auto& q) { return kinematics.base_from_tip(q); }, random),
                1e-10);
    }
  }
}

TEST(DhTable, ReturnsUnchangedFromAnArm) {
  RandomStream random(2);
  for (const DhConvention convention : {DhConvention::classic, DhConvention::modified}) {
    const DhTable table = random_table(convention, 6, random);
    const DhTable back = dh_from_arm(arm_from_dh(table), convention).table;
    for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
      EXPECT_EQ(back.rows[i].theta_rad, table.rows[i].theta_rad);
      EXPECT_EQ(back.rows[i].d_mm, table.rows[i].d_mm);
    }
    EXPECT_LT(worst_pose_difference(
                  6, [&](const auto& q) { return base_from_tool(table, q); },
                  [&](const auto& q) { return base_from_tool(back, q); }, random),
              1e-10);
  }
}

TEST(DhTable, LastRowAndToolComeBackWhereATableHasThem) {
  DhTable classic;
  classic.rows = {{0.1, 376.5, -0.02, -1.57}, {0.2, 1.0, 62.1, 1.57}, {0.3, 15.07, 0.5, -0.4}};
  const DhTable back = dh_from_arm(arm_from_dh(classic), DhConvention::classic).table;
  EXPECT_EQ(back.rows[2].d_mm, 15.07);
  EXPECT_EQ(back.rows[2].a_mm, 0.5);
  EXPECT_DOUBLE_EQ(back.rows[2].alpha_rad, -0.4);
  EXPECT_TRUE(back.last_from_tool.rotation.isIdentity(0.0));
  DhTable modified = classic;
  modified.convention = DhConvention::modified;
  const DhTable again = dh_from_arm(arm_from_dh(modified), DhConvention::modified).table;
  EXPECT_EQ(again.rows[2].d_mm, 15.07);
  EXPECT_TRUE(again.last_from_tool.translation_mm.isZero(0.0));
}

TEST(DhTable, ExpressesAnyArmByCommonNormals) {
  // b, beta, joints that count backwards, a mount and a turned flange: none of them exists in a D-H
  // table.
  RandomStream random(3);
  for (int n = 2; n <= 8; ++n) {
    ArmModel arm = testing::random_arm(n, random, {.harmonics = 0});
    for (Link& link : arm.links) {
      // Keep clear of nearly parallel axes, which are the subject of the next tests.
      link.alpha_rad = random.uniform(0.3, 2.8) * (random.below(2) == 0 ? 1 : -1);
    }
    const ForwardKinematics kinematics(arm);
    for (const DhConvention convention : {DhConvention::classic, DhConvention::modified}) {
      const DhConversion conversion = dh_from_arm(arm, convention);
      EXPECT_TRUE(conversion.lost.empty());
      EXPECT_LT(worst_pose_difference(
                    n, [&](const auto& q) { return base_from_tool(conversion.table, q); },
                    [&](const auto& q) { return kinematics.base_from_tip(q); }, random),
                1e-10)
          << n;
    }
  }
}

TEST(DhTable, TakesParallelAndAntiparallelAxes) {
  RandomStream random(4);
  ArmModel arm = testing::random_arm(4, random, {.beta = false, .harmonics = 0});
  arm.links[0].alpha_rad = 0.0;
  arm.links[1].alpha_rad = 0.0;
  arm.links[1].a_mm = arm.links[1].b_mm = 0.0;  // coincident axes
  arm.links[2].alpha_rad = pi;
  const ForwardKinematics kinematics(arm);
  const DhTable table = dh_from_arm(arm, DhConvention::classic).table;
  EXPECT_LT(worst_pose_difference(
                4, [&](const auto& q) { return base_from_tool(table, q); },
                [&](const auto& q) { return kinematics.base_from_tip(q); }, random),
            1e-10);
}

TEST(DhTable, RefusesNearlyParallelAxesByName) {
  // The trap of a published table of a calibrated UR robot, with an offset of 439 m.
  RandomStream random(5);
  ArmModel arm = testing::random_arm(3, random, {.beta = false, .harmonics = 0});
  arm.links[0] = {0.0, 0.0, 600.0, 0.0, 1e-6};
  try {
    static_cast<void>(dh_from_arm(arm, DhConvention::classic));
    FAIL() << "accepted";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("axes 1 and 2 are 5.73e-05 deg from parallel"));
    EXPECT_THAT(error.what(), HasSubstr("keep the arm file"));
  }
}

TEST(DhTable, SaysWhatItLeavesOut) {
  RandomStream random(6);
  ArmModel arm = testing::random_arm(3, random, {.beta = false, .harmonics = 0});
  arm.joints[1].harmonics = {{1e-4, 0}};
  arm.joints[2].min_rad = -1.0;
  const auto lost = dh_from_arm(arm, DhConvention::classic).lost;
  EXPECT_THAT(lost, Contains("encoder harmonics of joint 2"));
  EXPECT_THAT(lost, Contains("limits of joint 3"));
}

}  // namespace
}  // namespace armcal
