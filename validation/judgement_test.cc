// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "judgement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "armcal/core/random.h"

namespace armcal::validation {
namespace {

// Trials as theory has them: normal errors, chi-squared of 50 degrees of freedom.
std::vector<Trial> perfect_trials(int count, double scale = 1.0, double shift = 0.0) {
  std::vector<Trial> trials;
  for (int i = 0; i < count; ++i) {
    RandomStream random(1, static_cast<std::uint64_t>(i));
    Trial trial;
    for (int k = 0; k < 4; ++k) {
      trial.error.push_back(0.1 * (shift + scale * random.normal()));
      trial.u.push_back(0.1);
    }
    trial.degrees_of_freedom = 50;
    for (int k = 0; k < 50; ++k) trial.chi_squared += std::pow(scale * random.normal(), 2);
    trial.squares_floor_mm2 = 1.0;
    trial.squares_mm2 = 1.05;
    trials.push_back(trial);
  }
  return trials;
}

class Judge : public ::testing::Test {
 protected:
  [[nodiscard]] bool passes(const std::vector<Trial>& trials, const std::string& what) const {
    bool all = true;
    int count = 0;
    for (const Finding& each : judge(plan_, trials)) {
      if (each.what.rfind(what, 0) != 0) continue;
      all = all && each.passes();
      ++count;
    }
    EXPECT_GT(count, 0) << what;
    return all;
  }

  Scenario scenario_;
  Plan plan_{.scenario = &scenario_, .names = {"a", "b", "c", "tip"}, .parameter_count = 3};
};

TEST_F(Judge, LetsPassWhatKeepsItsPromise) {
  for (const int count : {12, 100, 2000}) EXPECT_TRUE(passes(perfect_trials(count), "")) << count;
}

TEST_F(Judge, SeesUncertaintiesThatAreTooSmallOrTooLarge) {
  EXPECT_FALSE(passes(perfect_trials(2000, 1.2), "coverage of parameters"));
  EXPECT_FALSE(passes(perfect_trials(2000, 0.8), "coverage of parameters"));
  EXPECT_FALSE(passes(perfect_trials(2000, 1.2), "coverage, mean"));
  EXPECT_FALSE(passes(perfect_trials(2000, 1.02), "mean sigma0"));
  EXPECT_FALSE(passes(perfect_trials(12, 1.5), "mean sigma0"));
}

TEST_F(Judge, SeesABias) {
  EXPECT_FALSE(passes(perfect_trials(2000, 1.0, 0.25), "largest bias"));
  EXPECT_TRUE(passes(perfect_trials(2000, 1.0, 0.03), "largest bias"));
}

TEST_F(Judge, SeesOnePredictedCoordinateThatIsWrong) {
  std::vector<Trial> trials = perfect_trials(2000);
  for (Trial& trial : trials) trial.error.back() *= 1.3;
  EXPECT_FALSE(passes(trials, "coverage of predicted"));
  EXPECT_TRUE(passes(trials, "coverage of parameters"));
}

TEST_F(Judge, CountsFailuresAndOtherUnknowns) {
  std::vector<Trial> trials = perfect_trials(100);
  trials[7].problem = "no convergence";
  EXPECT_FALSE(passes(trials, "calibrations that failed"));
  EXPECT_TRUE(passes(trials, "calibrations of other unknowns"));
  trials[8].same_unknowns = false;
  EXPECT_FALSE(passes(trials, "calibrations of other unknowns"));
}

TEST_F(Judge, WantsToBeToldWhereTheModelIsTooSmall) {
  scenario_.model_is_complete = false;
  std::vector<Trial> trials = perfect_trials(100);
  EXPECT_FALSE(passes(trials, "reports that say so"));
  for (Trial& trial : trials) trial.says_scatter = true;
  EXPECT_TRUE(passes(trials, "reports that say so"));
}

// R: qbinom(c(0.0005, 0.9995), 1000, 0.95).
TEST(BinomialBand, IsThatOfTheDistribution) {
  EXPECT_NEAR(binomial_band(1000).fewest, 926, 1);
  EXPECT_NEAR(binomial_band(1000).most, 971, 1);
  EXPECT_EQ(binomial_band(12).most, 12);
}

TEST(ExpectedFigures, HaveTheirLimits) {
  // Many degrees of freedom: sigma0 is 1 within 1/sqrt(2 nu), half of the time widening a little.
  EXPECT_NEAR(expected_coverage(1e6), 0.95, 1e-3);
  EXPECT_NEAR(expected_sigma0(1e6), 1.0, 1e-6);
  // One degree: sigma0 is |z|, whose mean is sqrt(2/pi).
  EXPECT_NEAR(expected_sigma0(1.0), 0.7978845608, 1e-9);
  EXPECT_NEAR(expected_coverage(19.0), 0.959, 1e-3);
}

}  // namespace
}  // namespace armcal::validation
