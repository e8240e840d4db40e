// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/touch_search.h"

#include <gtest/gtest.h>

#include "armcal/core/units.h"
#include "armcal/planning/verification/articulations.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::degrees;

// Upper arm, forearm and stylus of 400, 300 and 100 mm in a level plane; all axes upright.
ArmModel level_arm() {
  ArmModel arm;
  arm.joints.resize(4);
  arm.links = {{}, {.a_mm = 400.0}, {.a_mm = 300.0}};
  arm.tip.a_mm = 100.0;
  return arm;
}

TEST(TouchSearch, TheElbowIsLeftWhereItStandsOutToTheLeft) {
  const TouchSearch search(level_arm(), {});
  // 400 sin 45 deg; the tip lies straight ahead.
  EXPECT_NEAR(search.elbow_mm(degrees({0, 45, -90, 0})), 282.842712, 1e-6);
  EXPECT_NEAR(search.elbow_mm(degrees({0, -45, 90, 0})), -282.842712, 1e-6);
  EXPECT_NEAR(search.elbow_mm(degrees({77, 45, -90, 0})), 282.842712, 1e-6);
}

TEST(TouchSearch, TheStylusStandsOnTheFreeSide) {
  const TouchSearch search(level_arm(), {});
  const Eigen::VectorXd posture = degrees({0, 45, -90, 0});
  const Eigen::Vector3d tip = search.tip(posture);
  const Eigen::Vector3d back = -search.stylus_direction(posture);
  EXPECT_TRUE(search.posture_near({tip, back}, posture));
  EXPECT_FALSE(search.posture_near({tip, -back}, posture));
}

TEST(TouchSearch, SaysWhyNothingCanStandThere) {
  VerificationRoom room;
  room.surroundings = {.column_radius_mm = 60.0, .column_top_mm = 0.0, .bench_mm = -200.0};
  room.volume = MeasuringVolume{{-700.0, -700.0, -300.0}, {900.0, 700.0, 300.0}};
  const TouchSearch search(level_arm(), room);
  EXPECT_EQ(search.fault_at({500.0, 0.0, 0.0}), std::nullopt);
  EXPECT_EQ(search.fault_at({500.0, 0.0, -201.0}), "below the bench");
  EXPECT_EQ(search.fault_at({500.0, 0.0, -190.0}, 20.0), "below the bench");
  EXPECT_EQ(search.fault_at({40.0, 30.0, 100.0}), "too near the first axis");
  EXPECT_EQ(search.fault_at({0.0, 701.0, 0.0}), "outside the measuring volume");
  EXPECT_EQ(search.fault_at({790.0, 0.0, 0.0}), "out of reach");  // 97 % of 800 mm
}

Articulation articulation(double first_joint_deg, double elbow_mm) {
  Articulation result;
  result.postures_rad = {degrees({first_joint_deg, 0})};
  result.elbow_mm = elbow_mm;
  return result;
}

std::vector<double> elbows(const std::vector<Articulation>& articulations) {
  std::vector<double> list;
  for (const Articulation& each : articulations) list.push_back(each.elbow_mm);
  return list;
}

// The two lefts are farther from each other than either is from the right.
TEST(Articulations, HaveTheElbowOnEitherSideFirst) {
  const auto chosen = choose_articulations(
      {articulation(0, 10), articulation(170, 20), articulation(80, -30), articulation(2, 40)}, 3);
  EXPECT_EQ(elbows(chosen), (std::vector<double>{20, -30, 10}));
  EXPECT_NEAR(least_distance_rad(chosen), radians_from_degrees(80.0), 1e-12);
}

TEST(Articulations, OfAnArmWithItsElbowOnOneSideAreThoseThatDifferMost) {
  const auto chosen = choose_articulations(
      {articulation(0, 10), articulation(5, 20), articulation(90, 30), articulation(170, 40)}, 3);
  EXPECT_EQ(elbows(chosen), (std::vector<double>{10, 40, 30}));
}

}  // namespace
}  // namespace armcal
