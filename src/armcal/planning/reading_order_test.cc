// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/reading_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "armcal/planning/half_turn_walk.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::degrees;

HalfTurn turn(int joint, const Eigen::VectorXd& posture) {
  HalfTurn result{joint, posture, posture};
  result.posture_end_rad(joint - 1) += std::numbers::pi;
  return result;
}

std::vector<HalfTurn> candidates(const ArmModel& arm, int count) {
  Rejections rejections;
  return half_turn_candidates(arm, {}, count, 2, rejections);
}

std::vector<int> as_given(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// All eight settings of three joints can be gone through moving one joint at a time.
TEST(ReadingOrder, FindsTheGrayCode) {
  std::vector<HalfTurn> turns;
  for (const int number : {0, 7, 1, 6, 2, 5, 3, 4}) {
    turns.push_back(
        turn(1, degrees({0, 90.0 * (number & 1), 45.0 * (number & 2), 22.5 * (number & 4), 0, 0})));
  }
  const auto order = reading_order(turns);
  EXPECT_EQ(joints_to_set(turns, order), 7);
  EXPECT_GT(joints_to_set(turns, as_given(8)), 15);
}

TEST(ReadingOrder, ReadsEveryHalfTurnOnce) {
  const auto turns = candidates(testing::consistent_romer(), 30);
  auto order = reading_order(turns);
  EXPECT_LT(joints_to_set(turns, order), joints_to_set(turns, as_given(30)));
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, as_given(30));
}

TEST(ReadingOrder, TakesNoneAndOne) {
  EXPECT_TRUE(reading_order({}).empty());
  const std::vector<HalfTurn> one = {turn(2, degrees({0, 0, 0, 0, 0, 0}))};
  EXPECT_EQ(reading_order(one), as_given(1));
}

TEST(HalfTurnWalk, LeavesIdleJointsWhereTheyAre) {
  const std::vector<HalfTurn> turns = {turn(3, degrees({10, 20, 0, 90, 0, 0})),
                                       turn(3, degrees({-40, 80, 90, 90, 90, 0}))};
  const auto walk = walk_through(testing::consistent_romer(), {}, turns,
                                 [](const HalfTurn&, const HalfTurn&) { return true; });
  ASSERT_EQ(walk.size(), 2u);
  EXPECT_EQ(joints_moved(walk), 1);  // joint 5 alone
  EXPECT_NEAR((walk[1].posture_rad - degrees({10, 20, 180, 90, 90, 0})).norm(), 0.0, 1e-12);
  EXPECT_NEAR(walk[1].posture_end_rad(2), 0.0, 1e-12);
}

TEST(HalfTurnWalk, KeepsToStopsVolumeAndWhatIsAsGood) {
  const ArmModel arm = seven_joint_arm();
  const auto turns = candidates(arm, 40);
  HalfTurnRoom room;
  room.surroundings.bench_mm = -2000.0;
  const auto walk = walk_through(arm, room, turns, [](const HalfTurn& tried, const HalfTurn&) {
    return tried.posture_rad(0) < 3.0;
  });
  const auto strict =
      walk_through(arm, room, turns, [](const HalfTurn&, const HalfTurn&) { return false; });
  for (std::size_t i = 0; i < walk.size(); ++i) {
    EXPECT_FALSE(obstacle(arm, room, walk[i].posture_rad));
    EXPECT_FALSE(obstacle(arm, room, walk[i].posture_end_rad));
    EXPECT_EQ(walk[i].joint, turns[i].joint);
    for (Eigen::Index j = turns[i].joint; j < 7; ++j) {  // what makes the distance
      EXPECT_EQ(walk[i].posture_rad(j), turns[i].posture_rad(j));
    }
    EXPECT_EQ(strict[i].posture_rad, turns[i].posture_rad);
  }
  EXPECT_LT(joints_moved(walk), joints_moved(strict));
}

}  // namespace
}  // namespace armcal
