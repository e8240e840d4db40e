// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/chosen_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/core/random.h"

namespace armcal {
namespace {

Eigen::MatrixXd random_design(Eigen::Index rows, Eigen::Index columns) {
  RandomStream random(1);
  Eigen::MatrixXd design(rows, columns);
  for (double& each : design.reshaped()) each = random.normal();
  return design;
}

TEST(ChosenRows, PredictWhatAnExchangeGains) {
  const Eigen::MatrixXd design = random_design(40, 5);
  const ChosenRows choice(design, {0, 3, 6, 9, 12, 15, 18});
  const Eigen::VectorXd gains = choice.gains(2);
  EXPECT_EQ(gains(9), 0.0);  // chosen already
  for (const int in : {1, 7, 39}) {
    ChosenRows other = choice;
    other.exchange(2, in);
    other.renew();
    EXPECT_NEAR(std::log(gains(in)), other.log_determinant() - choice.log_determinant(), 1e-9);
  }
}

TEST(ChosenRows, UpdatesAgreeWithTheRowsThemselves) {
  const Eigen::MatrixXd design = random_design(60, 6);
  ChosenRows updated(design, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  for (const auto& [place, in] : {std::pair{0, 20}, {3, 30}, {9, 55}, {0, 1}}) {
    if (!updated.is_taken(in)) updated.exchange(static_cast<std::size_t>(place), in);
  }
  const ChosenRows fresh(design, updated.rows());
  EXPECT_LT((updated.covariance() - fresh.covariance()).norm(), 1e-9 * fresh.covariance().norm());
  EXPECT_LT((updated.gains(4) - fresh.gains(4)).norm(), 1e-9 * fresh.gains(4).norm());
}

TEST(ChosenRows, KnowWhenTheyDoNotDetermineAll) {
  Eigen::MatrixXd design = random_design(20, 3);
  design.topRows(5).col(2).setZero();
  EXPECT_TRUE(ChosenRows(design, {0, 1, 2, 3}).is_singular());
  EXPECT_FALSE(ChosenRows(design, {0, 1, 2, 9}).is_singular());
}

// A row looks most after itself, and not at all after one that is orthogonal to it.
TEST(ChosenRows, LikenessFindsWhatLooksAfterARow) {
  const Eigen::MatrixXd design = (Eigen::MatrixXd(5, 2) << 1, 0, 0, 1, 2, 0, 0, 3, 1, 1).finished();
  const ChosenRows choice(design, {0, 1});
  const Eigen::VectorXd likeness = choice.likeness(0);
  EXPECT_EQ(likeness(1), 0.0);
  EXPECT_EQ(likeness(3), 0.0);
  EXPECT_GT(likeness(2), likeness(4));
}

}  // namespace
}  // namespace armcal
