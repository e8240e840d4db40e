// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/d_optimal_exchange.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "armcal/core/random.h"
#include "armcal/planning/reliability.h"

namespace armcal {
namespace {

Eigen::MatrixXd random_design(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  RandomStream random(seed);
  Eigen::MatrixXd design(rows, columns);
  for (double& each : design.reshaped()) each = random.normal();
  return design;
}

double determinant(const Eigen::MatrixXd& design, const std::vector<int>& rows) {
  const Eigen::MatrixXd chosen = design(rows, Eigen::all);
  return (chosen.transpose() * chosen).determinant();
}

ExchangeOptions choose(int observations) {
  ExchangeOptions options;
  options.observations = observations;
  return options;
}

// Every choice of five of twelve, tried.
double largest_determinant_of_five(const Eigen::MatrixXd& design) {
  double best = 0.0;
  for (unsigned mask = 0; mask < (1U << 12U); ++mask) {
    std::vector<int> rows;
    for (int row = 0; row < 12; ++row) {
      if ((mask >> static_cast<unsigned>(row)) & 1U) rows.push_back(row);
    }
    if (rows.size() == 5) best = std::max(best, determinant(design, rows));
  }
  return best;
}

TEST(Exchange, FindsTheBestOfAllChoices) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Eigen::MatrixXd design = random_design(12, 3, seed);
    const auto chosen = choose_observations(design, Eigen::VectorXd::Ones(12), choose(5));
    ASSERT_EQ(chosen.rows.size(), 5u);
    EXPECT_NEAR(determinant(design, chosen.rows) / largest_determinant_of_five(design), 1.0, 1e-9)
        << seed;
  }
}

TEST(Exchange, NoSingleExchangeIsLeftThatGains) {
  const Eigen::MatrixXd design = random_design(150, 6, 3);
  const auto chosen = choose_observations(design, Eigen::VectorXd::Ones(150), choose(14));
  const double reached = determinant(design, chosen.rows);
  EXPECT_EQ(std::set<int>(chosen.rows.begin(), chosen.rows.end()).size(), 14u);
  for (std::size_t place = 0; place < chosen.rows.size(); ++place) {
    for (int row = 0; row < 150; ++row) {
      auto other = chosen.rows;
      if (std::find(other.begin(), other.end(), row) != other.end()) continue;
      other[place] = row;
      EXPECT_LE(determinant(design, other), reached * (1.0 + 1e-6));
    }
  }
}

// Millimetres or metres, arcseconds or radians: units must not choose the readings.
TEST(Exchange, DoesNotDependOnUnits) {
  const Eigen::MatrixXd design = random_design(80, 4, 5);
  const Eigen::Vector4d scales(1e3, 1e-3, 1.0, 1e6);
  const Eigen::VectorXd u = Eigen::VectorXd::Ones(80);
  EXPECT_EQ(choose_observations(design, u, choose(9)).rows,
            choose_observations(design * scales.asDiagonal(), u, choose(9)).rows);
}

TEST(Exchange, ThreadsNeverChangeTheChoice) {
  const Eigen::MatrixXd design = random_design(200, 7, 4);
  const Eigen::VectorXd u = Eigen::VectorXd::Ones(200);
  ExchangeOptions options = choose(16);
  options.limits.least_redundancy = 0.35;
  const auto alone = choose_observations(design, u, options);
  options.threads = 4;
  const auto together = choose_observations(design, u, options);
  EXPECT_EQ(alone.rows, together.rows);
  EXPECT_EQ(alone.log_determinant, together.log_determinant);
}

// One row is far from all others: D-optimal takes it once, and then nothing checks it.
TEST(Exchange, MendsAReadingThatNothingChecks) {
  Eigen::MatrixXd design = random_design(60, 3, 6);
  design.col(2) *= 1e-3;
  design(7, 2) = 30.0;
  design(9, 2) = 29.0;
  const Eigen::VectorXd u = Eigen::VectorXd::Ones(60);
  ExchangeOptions options = choose(8);
  const auto free = choose_observations(design, u, options);
  options.limits.least_redundancy = 0.3;
  const auto limited = choose_observations(design, u, options);
  EXPECT_TRUE(limited.keeps_limits);
  EXPECT_GE(limited.least_redundancy, 0.3);
  EXPECT_LE(limited.log_determinant, free.log_determinant + 1e-9);
}

TEST(Exchange, SaysWhenTheLimitsCannotBeKept) {
  const Eigen::MatrixXd design = random_design(60, 3, 6);
  ExchangeOptions options = choose(4);
  options.limits.least_redundancy = 0.3;  // the mean of four readings for three unknowns is 0.25
  const auto chosen = choose_observations(design, Eigen::VectorXd::Ones(60), options);
  EXPECT_FALSE(chosen.keeps_limits);
  EXPECT_EQ(chosen.rows.size(), 4u);
}

// Four rows see the third unknown. Two of them would determine it, but an error in one could not be
// told from one in the other.
TEST(Exchange, LimitsTheErrorThatStaysUnnamed) {
  Eigen::MatrixXd design = random_design(60, 3, 7);
  design.col(2) *= 1e-3;
  for (const int row : {7, 9, 11, 13}) design(row, 2) = 1.0;
  const Eigen::VectorXd u = Eigen::VectorXd::Constant(60, 0.005);
  ExchangeOptions options = choose(7);
  const auto free = choose_observations(design, u, options);
  options.limits.largest_unnamed = 0.06;
  const auto limited = choose_observations(design, u, options);
  EXPECT_GT(free.largest_unnamed, 0.06);
  EXPECT_TRUE(limited.keeps_limits);
  EXPECT_LE(limited.largest_unnamed, 0.06);
}

TEST(Exchange, RefusesFewerObservationsThanUnknowns) {
  const Eigen::MatrixXd design = random_design(20, 5, 1);
  EXPECT_THROW(static_cast<void>(choose_observations(design, Eigen::VectorXd::Ones(20), choose(4))),
               std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(choose_observations(design, Eigen::VectorXd::Ones(20), choose(21))),
      std::invalid_argument);
}

TEST(Exchange, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  ExchangeOptions options = choose(6);
  options.monitor.stop = source.get_token();
  EXPECT_THROW(static_cast<void>(choose_observations(random_design(20, 5, 1),
                                                     Eigen::VectorXd::Ones(20), options)),
               Interrupted);
}

}  // namespace
}  // namespace armcal
