// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/population_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "armcal/comparison/objective.h"
#include "armcal/identification/calibration.h"
#include "armcal/testing/synthetic_readings.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

constexpr PopulationMethod kMethods[] = {PopulationMethod::annealing, PopulationMethod::genetic,
                                         PopulationMethod::particle_swarm,
                                         PopulationMethod::differential_evolution};

// A valley: twenty times steeper across than along.
double valley(const Eigen::VectorXd& x) {
  const Eigen::VectorXd aside = x - Eigen::VectorXd::LinSpaced(x.size(), 0.2, 0.7);
  return aside.squaredNorm() + 400.0 * aside.sum() * aside.sum();
}

class EveryPopulationMethod : public ::testing::TestWithParam<PopulationMethod> {
 protected:
  void SetUp() override {
    if (!has_population_search()) GTEST_SKIP() << "built without pagmo2";
  }
};

TEST_P(EveryPopulationMethod, FindsTheBottomOfAValley) {
  const PopulationSearch found =
      search_population(GetParam(), valley, Eigen::VectorXd::Zero(4), Eigen::VectorXd::Ones(4),
                        {.evaluations = 20000});
  EXPECT_LT(found.objective, 1e-2 * found.objective_at_start);
  EXPECT_EQ(found.objective, valley(found.best));
  EXPECT_EQ(found.objective_at_start, valley(Eigen::VectorXd::Zero(4)));
}

TEST_P(EveryPopulationMethod, StaysInItsBoxAndWithinItsEvaluations) {
  const Eigen::Vector3d start(10.0, -20.0, 5.0);
  const Eigen::Vector3d widths(0.5, 0.1, 2.0);
  std::int64_t calls = 0;
  const auto outside = [&](const Eigen::VectorXd& x) {
    ++calls;
    EXPECT_TRUE(((x - start).array().abs() <= widths.array() + 1e-12).all()) << x.transpose();
    return (x - start - 3.0 * widths).squaredNorm();
  };
  const PopulationSearch found =
      search_population(GetParam(), outside, start, widths, {.evaluations = 3000});
  EXPECT_EQ(found.evaluations, calls);
  EXPECT_LE(calls, 3000);
  EXPECT_GT(calls, 2400);
  EXPECT_LT((found.best - start - widths).cwiseQuotient(widths).cwiseAbs().maxCoeff(), 0.5);
}

TEST_P(EveryPopulationMethod, FindsTheSameDigitsWithTheSameSeed) {
  const auto run = [&](std::uint64_t seed) {
    return search_population(GetParam(), valley, Eigen::VectorXd::Zero(5), Eigen::VectorXd::Ones(5),
                             {.evaluations = 2000, .seed = seed});
  };
  const PopulationSearch one = run(7);
  EXPECT_EQ(one.best, run(7).best);
  EXPECT_NE(one.best, run(8).best);
}

TEST_P(EveryPopulationMethod, TellsHowTheBestFell) {
  const PopulationSearch found = search_population(GetParam(), valley, Eigen::VectorXd::Zero(4),
                                                   Eigen::VectorXd::Ones(4), {.evaluations = 4000});
  ASSERT_GE(found.history.size(), 3U);
  EXPECT_EQ(found.history.front().evaluations, 1);
  EXPECT_EQ(found.history.front().objective, found.objective_at_start);
  EXPECT_EQ(found.history.back().evaluations, found.evaluations);
  EXPECT_EQ(found.history.back().objective, found.objective);
  for (std::size_t i = 1; i < found.history.size(); ++i) {
    EXPECT_LE(found.history[i].objective, found.history[i - 1].objective);
    EXPECT_GT(found.history[i].evaluations, found.history[i - 1].evaluations);
  }
}

TEST_P(EveryPopulationMethod, PassesOverPlacesWhereNothingCanBePlaced) {
  const auto half_defined = [](const Eigen::VectorXd& x) {
    return x(0) < -0.2 ? std::numeric_limits<double>::infinity() : valley(x);
  };
  const PopulationSearch found =
      search_population(GetParam(), half_defined, Eigen::VectorXd::Zero(3),
                        Eigen::VectorXd::Ones(3), {.evaluations = 4000});
  EXPECT_LT(found.objective, 0.1 * found.objective_at_start);
}

TEST_P(EveryPopulationMethod, ReportsAndStopsWhenAsked) {
  std::stop_source source;
  Monitor monitor;
  std::vector<double> fractions;
  monitor.stop = source.get_token();
  monitor.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.stage, to_string(GetParam()));
    fractions.push_back(progress.fraction);
    if (fractions.size() == 4) source.request_stop();
  };
  EXPECT_THROW(static_cast<void>(search_population(GetParam(), valley, Eigen::VectorXd::Zero(4),
                                                   Eigen::VectorXd::Ones(4),
                                                   {.evaluations = 100000, .monitor = monitor})),
               Interrupted);
  EXPECT_EQ(fractions.size(), 4U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

TEST_P(EveryPopulationMethod, NeverFallsBelowLeastSquaresAndImprovesOnTheStart) {
  RandomStream random(1);
  testing::SyntheticReadings arm(testing::perturbed(testing::consistent_romer(), random, 0.1, 2e-4),
                                 1, 0.005);
  const std::vector<ObservationGroup> groups = {arm.fixed_points({"A", "B"}, 20),
                                                arm.length("A", "B")};
  const ArmModel nominal = testing::consistent_romer();
  const Calibration least = calibrate(nominal, groups, {});
  ASSERT_TRUE(least.ok());
  const ArmObjective objective(nominal, groups, least.free);
  const ParameterTable table(nominal);
  Eigen::VectorXd widths(static_cast<Eigen::Index>(least.free.size()));
  for (Eigen::Index i = 0; i < widths.size(); ++i) {
    const bool is_length = table[least.free[static_cast<std::size_t>(i)]].unit == ParameterUnit::mm;
    widths(i) = is_length ? 1.0 : 2e-3;
  }
  const PopulationSearch found =
      search_population(GetParam(), [&](const Eigen::VectorXd& x) { return objective(x); },
                        objective.start(), widths, {.evaluations = 8000});
  EXPECT_GE(found.objective, least.chi_squared * (1.0 - 1e-9));
  EXPECT_LT(found.objective, 0.9 * found.objective_at_start);
}

TEST_P(EveryPopulationMethod, TakesAnOddPopulation) {
  const PopulationSearch found =
      search_population(GetParam(), valley, Eigen::VectorXd::Zero(3), Eigen::VectorXd::Ones(3),
                        {.evaluations = 2000, .population = 9});
  EXPECT_LT(found.objective, 0.5 * found.objective_at_start);
}

INSTANTIATE_TEST_SUITE_P(All, EveryPopulationMethod, ::testing::ValuesIn(kMethods),
                         [](const auto& method) {
                           std::string name(to_string(method.param));
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(PopulationSearch, RefusesWhatIsNoSearch) {
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(2);
  if (!has_population_search()) {
    EXPECT_THAT(
        [&] {
          static_cast<void>(search_population(PopulationMethod::genetic, valley, start,
                                              Eigen::VectorXd::Ones(2), {}));
        },
        ::testing::ThrowsMessage<std::runtime_error>("built without pagmo2: install libpagmo-dev"));
    return;
  }
  const auto refused = [&](const Eigen::VectorXd& widths, const PopulationSearchOptions& options) {
    EXPECT_THROW(static_cast<void>(
                     search_population(PopulationMethod::genetic, valley, start, widths, options)),
                 std::invalid_argument);
  };
  refused(Eigen::VectorXd::Ones(3), {});
  refused(Eigen::Vector2d(1.0, 0.0), {});
  refused(Eigen::VectorXd::Ones(2), {.population = 3});
  refused(Eigen::VectorXd::Ones(2), {.evaluations = 50});
}

}  // namespace
}  // namespace armcal
