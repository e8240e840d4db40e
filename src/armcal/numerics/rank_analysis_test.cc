// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/rank_analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "armcal/core/random.h"

namespace armcal {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, RandomStream& random) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.normal(); });
}

std::vector<int> natural_order(Eigen::Index n) {
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

TEST(RankAnalysis, KeepsEverythingThatIsIndependent) {
  RandomStream random(1);
  const Eigen::MatrixXd jacobian = random_matrix(30, 8, random);
  const RankAnalysis analysis = analyse_rank(jacobian, natural_order(8));
  EXPECT_EQ(analysis.rank, 8);
  EXPECT_TRUE(analysis.dependent.empty());
  EXPECT_TRUE(analysis.unseen.empty());
  EXPECT_LT(analysis.condition_number, 10.0);
}

TEST(RankAnalysis, ExplainsADependentColumnInTheUnitsGiven) {
  RandomStream random(2);
  Eigen::MatrixXd jacobian = random_matrix(20, 4, random);
  jacobian.col(1) *= 1e6;
  jacobian.col(3) = 2.0 * jacobian.col(0) - 3e-6 * jacobian.col(1);
  const RankAnalysis analysis = analyse_rank(jacobian, {0, 1, 2, 3});
  ASSERT_EQ(analysis.rank, 3);
  ASSERT_EQ(analysis.dependent.size(), 1u);
  EXPECT_EQ(analysis.dependent[0].column, 3);
  EXPECT_NEAR(analysis.dependent[0].weights(0), 2.0, 1e-12);
  EXPECT_NEAR(analysis.dependent[0].weights(1), -3e-6, 1e-18);
  EXPECT_NEAR(analysis.dependent[0].weights(2), 0.0, 1e-12);
}

TEST(RankAnalysis, PreferenceDecidesWhichOneIsHeld) {
  RandomStream random(3);
  Eigen::MatrixXd jacobian = random_matrix(20, 3, random);
  jacobian.col(2) = jacobian.col(0);
  EXPECT_EQ(analyse_rank(jacobian, {0, 1, 2}).dependent.at(0).column, 2);
  EXPECT_EQ(analyse_rank(jacobian, {2, 1, 0}).dependent.at(0).column, 0);
  // Held early, before column 1 was taken: its weight there is zero, not missing.
  const RankAnalysis early = analyse_rank(jacobian, {0, 2, 1});
  EXPECT_EQ(early.dependent.at(0).weights.size(), 2);
  EXPECT_EQ(early.dependent.at(0).weights(1), 0.0);
}

TEST(RankAnalysis, TellsUnseenFromDependent) {
  RandomStream random(4);
  Eigen::MatrixXd jacobian = random_matrix(10, 3, random);
  jacobian.col(1).setZero();
  const RankAnalysis analysis = analyse_rank(jacobian, natural_order(3));
  EXPECT_EQ(analysis.rank, 2);
  EXPECT_EQ(analysis.unseen, std::vector<int>{1});
}

TEST(RankAnalysis, FewerRowsThanColumns) {
  RandomStream random(5);
  const RankAnalysis analysis = analyse_rank(random_matrix(3, 6, random), natural_order(6));
  EXPECT_EQ(analysis.rank, 3);
  EXPECT_EQ(analysis.dependent.size(), 3u);
}

TEST(RankAnalysis, NoRowsSeeNothing) {
  const RankAnalysis analysis = analyse_rank(Eigen::MatrixXd(0, 2), natural_order(2));
  EXPECT_EQ(analysis.rank, 0);
  EXPECT_EQ(analysis.unseen.size(), 2u);
}

TEST(RankAnalysis, ScalesColumnsBeforeItDecides) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Identity(2, 2);
  jacobian.col(1) *= 1e-12;
  EXPECT_EQ(analyse_rank(jacobian, natural_order(2)).rank, 2);
}

}  // namespace
}  // namespace armcal
