// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/posture_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/core/random.h"

namespace armcal {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

double smallest_distance(const std::vector<VectorXd>& postures) {
  double smallest = HUGE_VAL;
  for (std::size_t i = 0; i < postures.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      smallest = std::min(smallest, joint_distance_rad(postures[i], postures[j]));
    }
  }
  return smallest;
}

std::vector<VectorXd> random_postures(int count) {
  RandomStream random(1);
  std::vector<VectorXd> postures;
  for (int i = 0; i < count; ++i) {
    VectorXd posture(4);
    for (double& angle : posture) angle = random.uniform(-pi, pi);
    postures.push_back(posture);
  }
  return postures;
}

TEST(JointRange, IsFromStopToStop) {
  const JointRange range = range_in_use({.min_rad = -1.0, .max_rad = 2.0});
  EXPECT_EQ(range.low_rad, -1.0);
  EXPECT_EQ(range.high_rad, 2.0);
}

TEST(JointRange, IsNeverMoreThanATurnAndNeverBeyondAStop) {
  const auto check = [](const Joint& joint, double low, double high) {
    EXPECT_NEAR(range_in_use(joint).low_rad, low, 1e-12);
    EXPECT_NEAR(range_in_use(joint).high_rad, high, 1e-12);
  };
  check({}, -pi, pi);
  check({.min_rad = 4.0}, 4.0, 4.0 + 2.0 * pi);
  check({.max_rad = -5.0}, -5.0 - 2.0 * pi, -5.0);
  check({.min_rad = 4.0, .max_rad = 6.0}, 4.0, 6.0);
  check({.min_rad = -10.0, .max_rad = 30.0}, 10.0 - pi, 10.0 + pi);
}

TEST(JointDistance, GoesTheShortWayRound) {
  const VectorXd one = VectorXd::Constant(4, pi - 0.1);
  const VectorXd other = VectorXd::Constant(4, 0.1 - pi + 4.0 * pi);
  EXPECT_NEAR(joint_distance_rad(one, other), 0.4, 1e-12);
}

TEST(MostDifferent, KeepsPosturesThatAreFarFromEachOther) {
  const auto all = random_postures(60);
  const auto chosen = most_different(all, 20);
  EXPECT_EQ(chosen.size(), 20U);
  EXPECT_EQ(chosen.front(), all.front());
  // Far better than the first that come.
  EXPECT_GT(smallest_distance(chosen),
            1.5 * smallest_distance(std::vector(all.begin(), all.begin() + 20)));
  for (const VectorXd& each : chosen) {
    EXPECT_EQ(std::count(all.begin(), all.end(), each), 1);
  }
}

TEST(MostDifferent, TakesTheFarthestNext) {
  const std::vector<VectorXd> line = {VectorXd::Constant(1, 0.0), VectorXd::Constant(1, 0.1),
                                      VectorXd::Constant(1, 1.0), VectorXd::Constant(1, 0.6)};
  const auto chosen = most_different(line, 3);
  EXPECT_EQ(chosen[1](0), 1.0);
  EXPECT_EQ(chosen[2](0), 0.6);
}

TEST(MostDifferent, OfAllAreAll) {
  EXPECT_EQ(most_different(random_postures(5), 5).size(), 5U);
  EXPECT_TRUE(most_different({}, 0).empty());
}

}  // namespace
}  // namespace armcal
