// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/session_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/comparison/population_fit.h"
#include "armcal/comparison/population_search.h"
#include "armcal/comparison/redundant_fit.h"
#include "armcal/core/diagnostics.h"
#include "armcal/observations/check_split.h"
#include "armcal/testing/synthetic_readings.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::SyntheticReadings;

constexpr double kNoise_mm = 0.01;

ArmModel true_arm() {
  RandomStream random(11);
  return testing::perturbed(testing::consistent_romer(), random, 0.2, 3e-4);
}

std::vector<ObservationGroup> readings(const ArmModel& truth) {
  SyntheticReadings synthetic(truth, 4, kNoise_mm);
  std::vector<ObservationGroup> groups = {synthetic.reference_points(80, "cmm"),
                                          synthetic.reversals(30)};
  for (ObservationGroup& group : groups) group.u_mm.setConstant(kNoise_mm);
  hold_out(groups, 0.3, 1);
  return groups;
}

SessionComparison compared(std::vector<std::string> methods, int threads = 1) {
  return compare_on_session(testing::consistent_romer(), readings(true_arm()), {},
                            {.methods = std::move(methods), .threads = threads});
}

TEST(RowFigures, OfTheTrueArmAreTheNoise) {
  const ArmModel truth = true_arm();
  const auto groups = readings(truth);
  for (const bool held_out : {false, true}) {
    const RowFigures figures = row_figures(truth, groups, held_out);
    EXPECT_EQ(figures.residuals.count, held_out ? 33 : 77);
    // Six degrees of freedom of the frame are gone; 24 held-out points leave a scatter of 10 %.
    EXPECT_NEAR(figures.over_stated.value(), 1.0, 0.2);
  }
  EXPECT_GT(row_figures(testing::consistent_romer(), groups, true).residuals.rms_mm, 0.1);
}

TEST(RowFigures, OfHalfTurnsNeedNoPlace) {
  const ArmModel truth = true_arm();
  std::vector<ObservationGroup> groups = {SyntheticReadings(truth, 4, kNoise_mm).reversals(30)};
  hold_out(groups, 0.5, 1);
  const RowFigures figures = row_figures(truth, groups, true);
  EXPECT_EQ(figures.residuals.count, 15);
  EXPECT_NEAR(figures.residuals.rms_mm, kNoise_mm, 0.5 * kNoise_mm);
}

TEST(RowFigures, SayThatTheRowsAreTooFew) {
  std::vector<ObservationGroup> groups = {
      SyntheticReadings(true_arm(), 4, kNoise_mm).reference_points(40, "cmm")};
  groups[0].is_check[3] = true;
  try {
    static_cast<void>(row_figures(true_arm(), groups, true));
    FAIL();
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the rows cannot be placed: "));
  }
}

TEST(ComparingOnASession, PutsLeastSquaresNearTheNoiseAndTheNominalArmFarFromIt) {
  const SessionComparison comparison = compared({"nominal", "least-squares"});
  ASSERT_EQ(comparison.rows.size(), 2u);
  EXPECT_EQ(comparison.held_out, 33);
  EXPECT_EQ(comparison.fitted, 77);
  const auto& [nominal, fitted] = std::tie(comparison.rows[0], comparison.rows[1]);
  EXPECT_GT(nominal.held_out->over_stated.value(), 10.0);
  EXPECT_LT(fitted.held_out->over_stated.value(), 1.5);
  EXPECT_EQ(fitted.parameters, 21);
  EXPECT_LT(fitted.condition_number.value(), 100.0);
}

TEST(ComparingOnASession, GivesTheSameDigitsOnOneAndTwoThreads) {
  const std::vector<std::string> methods = {"nominal", "session", "least*"};
  const SessionComparison one = compared(methods, 1);
  const SessionComparison two = compared(methods, 2);
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    ASSERT_EQ(one.rows[i].held_out.has_value(), two.rows[i].held_out.has_value());
    if (!one.rows[i].held_out) continue;
    EXPECT_EQ(one.rows[i].held_out->residuals.rms_mm, two.rows[i].held_out->residuals.rms_mm);
  }
}

TEST(ComparingOnASession, WantsRowsToJudgeBy) {
  auto groups = readings(true_arm());
  for (ObservationGroup& group : groups) group.is_check.assign(group.is_check.size(), false);
  EXPECT_THROW(static_cast<void>(compare_on_session(true_arm(), groups, {}, {})),
               std::invalid_argument);
}

TEST(RedundantFit, PredictsAsWellButIsNoPoint) {
  const auto groups = readings(true_arm());
  const ArmModel nominal = testing::consistent_romer();
  const FoundArm found = redundant_fit(nominal, groups, {});
  EXPECT_EQ(found.free.size(), 29u);  // 5 n - 1
  EXPECT_EQ(found.u.size(), 0);
  EXPECT_GT(found.condition_number.value(), 1e12);
  const FoundArm reduced = found_arm(calibrate(nominal, groups, {}));
  EXPECT_NEAR(row_figures(found.arm, groups, true).residuals.rms_mm,
              row_figures(reduced.arm, groups, true).residuals.rms_mm, 1e-5);
}

// What papers call the failure of least squares: with the redundant columns in, an inverse that
// does not exist is taken.
TEST(PlainGaussNewton, IsNoMatchForTheSameLeastSquares) {
  const auto groups = readings(true_arm());
  const ArmModel nominal = testing::consistent_romer();
  const double damped =
      row_figures(redundant_fit(nominal, groups, {}).arm, groups, false).residuals.rms_mm;
  double undamped = std::numeric_limits<double>::infinity();
  try {
    undamped =
        row_figures(plain_gauss_newton(nominal, groups, {}).arm, groups, false).residuals.rms_mm;
  } catch (const NumericalError&) {
    // lost on the way, or nowhere near a place
  }
  EXPECT_GE(undamped, 0.999 * damped);
}

TEST(PopulationFit, ComesNearerThanTheNominalArm) {
  const auto groups = readings(true_arm());
  const ArmModel nominal = testing::consistent_romer();
  const PopulationFitOptions options{.evaluations = 2000};
  if (!has_population_search()) {
    EXPECT_THROW(static_cast<void>(population_fit(nominal, groups, options, {})), NumericalError);
    GTEST_SKIP() << "built without pagmo2";
  }
  SyntheticReadings synthetic(true_arm(), 4, kNoise_mm);
  std::vector<ObservationGroup> seats = {synthetic.fixed_points({"A", "B"}, 30)};
  seats.push_back(synthetic.length("A", "B"));
  const FoundArm found = population_fit(nominal, seats, options, {});
  EXPECT_LT(row_figures(found.arm, seats, false).residuals.rms_mm,
            row_figures(nominal, seats, false).residuals.rms_mm);
  EXPECT_THAT(found.remark, HasSubstr("21 parameters: "));
}

}  // namespace
}  // namespace armcal
