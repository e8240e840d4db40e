// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/estimability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using std::numbers::pi;

int place(const std::vector<int>& order, const ParameterTable& table, std::string_view name) {
  const int index = table.find(name).value();
  return static_cast<int>(std::find(order.begin(), order.end(), index) - order.begin());
}

TEST(WantedOrder, ConventionsComeLast) {
  RandomStream random(1);
  const ArmModel arm = testing::random_arm(6, random, {.arbitrary_twists = false, .harmonics = 0});
  const ParameterTable table(arm);
  const auto order = wanted_order(arm, table);
  ASSERT_EQ(order.size(), static_cast<std::size_t>(table.size()));
  const auto at = [&](std::string_view name) { return place(order, table, name); };
  EXPECT_EQ(at("zero1"), table.size() - 1);
  EXPECT_EQ(at("d2"), table.size() - 2);
  EXPECT_EQ(at("zero6"), table.size() - 3);
  EXPECT_LT(at("b3"), at("zero3"));
  EXPECT_LT(at("zero3"), at("d3"));
  EXPECT_LT(at("d3"), at("beta3"));
}

TEST(WantedOrder, BetaReplacesBAndDOnParallelAxes) {
  RandomStream random(2);
  ArmModel arm = testing::random_arm(6, random, {.arbitrary_twists = false, .harmonics = 0});
  arm.links[2].alpha_rad = pi + 0.01;  // link into joint 4
  const ParameterTable table(arm);
  const auto order = wanted_order(arm, table);
  const auto at = [&](std::string_view name) { return place(order, table, name); };
  EXPECT_LT(at("beta4"), at("zero3"));
  EXPECT_LT(at("beta4"), at("b4"));
  EXPECT_LT(at("b4"), at("d4"));
}

TEST(HeldByConvention, IsWhatOnlyMovesTheBaseFrame) {
  RandomStream random(3);
  ArmModel arm = testing::random_arm(6, random, {.arbitrary_twists = false, .harmonics = 0});
  const auto held = [&] {
    const ParameterTable table(arm);
    std::vector<std::string> names;
    for (const Parameter& each : table.parameters()) {
      if (held_by_convention(arm, each)) names.push_back(each.name);
    }
    return names;
  };
  EXPECT_THAT(held(),
              ::testing::ElementsAre("zero1", "d2", "beta2", "beta3", "beta4", "beta5", "beta6"));
  arm.links[0] = {.d_mm = 50.0, .b_mm = 1.0, .a_mm = 100.0, .alpha_rad = 0.01};
  EXPECT_THAT(held(),
              ::testing::ElementsAre("zero1", "d2", "b2", "beta3", "beta4", "beta5", "beta6"));
  arm.links[0].a_mm = arm.links[0].b_mm = 0.0;  // a turntable under the first axis
  EXPECT_THAT(held(), ::testing::ElementsAre("zero1", "d2", "beta3", "beta4", "beta5", "beta6"));
}

TEST(Describe, NamesThePartnersLargestFirst) {
  RankAnalysis analysis;
  analysis.basis = {0, 1, 2};
  const std::vector<std::string> names = {"a7", "b7", "d7", "zero6", "d2"};
  EXPECT_EQ(describe({3, Eigen::Vector3d(-2, 5, 0)}, analysis, names),
            "zero6 moves every reading like b7 and a7 together");
  EXPECT_EQ(describe({4, Eigen::Vector3d(0, 1e-9, 1)}, analysis, names),
            "d2 moves every reading like d7");
}

}  // namespace
}  // namespace armcal
