// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "armcal/comparison/methods/registry.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

Comparison compared(const std::string& scenario, std::vector<std::string> methods, int repeats = 1,
                    int threads = 1) {
  return compare_methods(*scenario_named(scenario),
                         {.methods = std::move(methods), .repeats = repeats, .threads = threads});
}

const ComparisonRow& row(const Comparison& comparison, const std::string& name) {
  for (const ComparisonRow& each : comparison.rows) {
    if (each.name == name) return each;
  }
  throw std::logic_error("no row " + name);
}

TEST(ComparingMethods, GivesTheSameDigitsOnOneAndTwoThreads) {
  const std::vector<std::string> methods = {"cmm", "cone", "circle-points", "paper-*"};
  const Comparison one = compared("romer", methods, 2, 1);
  const Comparison two = compared("romer", methods, 2, 2);
  ASSERT_EQ(one.rows.size(), 6u);
  EXPECT_EQ(one.noise_floor_mm, two.noise_floor_mm);
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    EXPECT_EQ(one.rows[i].score.point_rms_mm, two.rows[i].score.point_rms_mm);
    EXPECT_EQ(one.rows[i].score.length_rms_mm, two.rows[i].score.length_rms_mm);
    EXPECT_EQ(one.rows[i].score.noise_ratio, two.rows[i].score.noise_ratio);
    EXPECT_EQ(one.rows[i].score.inside, two.rows[i].score.inside);
    EXPECT_EQ(one.rows[i].readings, two.rows[i].readings);
  }
}

// Without noise every method that sees the whole arm finds it; the cone misses the scale, the
// paper's six readings miss what they take for perfect.
TEST(ComparingMethods, WithoutNoiseFindTheArmOrShowWhatTheyAreBlindTo) {
  Scenario scenario = *scenario_named("romer");
  scenario.errors.encoder_noise = {};
  scenario.u_reference_mm = 0.0;
  scenario.readings = 84;
  const Comparison comparison = compare_methods(
      scenario,
      {.methods = {"nominal", "cmm", "cone", "cone-and-length", "paper-*", "half-turns-40",
                   "sphere-plate", "straight-lines", "platform", "circle-points"}});
  for (const char* name : {"cmm", "half-turns-40", "sphere-plate", "straight-lines"}) {
    EXPECT_LT(row(comparison, name).score.point_max_mm, 1e-6) << name;
  }
  // Calibrated lengths of the bench (1 um) and the indices of the platform (0.5 arcsec) are not
  // exact.
  EXPECT_LT(row(comparison, "cone-and-length").score.length_rms_mm, 0.01);
  EXPECT_LT(row(comparison, "platform").score.length_rms_mm, 0.005);
  EXPECT_LT(row(comparison, "circle-points").score.point_max_mm, 1e-5);
  const double blind = row(comparison, "cone").score.length_rms_mm;
  EXPECT_GT(blind, 0.02);
  EXPECT_LT(blind, row(comparison, "nominal").score.length_rms_mm);
  EXPECT_GT(row(comparison, "paper-chain").score.point_rms_mm, 0.05);
  EXPECT_GT(row(comparison, "paper-as-printed").score.point_rms_mm, 100.0);
}

TEST(ComparingMethods, PutsTheReasonIntoTheRowOfAMethodThatCannotWorkHere) {
  const Comparison comparison = compared("seven-joint", {"paper-chain", "half-turns-24"});
  EXPECT_EQ(row(comparison, "paper-chain").arms, 0);
  EXPECT_EQ(row(comparison, "paper-chain").problem,
            "the procedure is for six joints, this arm has 7");
  EXPECT_EQ(row(comparison, "half-turns-24").problem,
            "24 half turns cannot determine 25 parameters");
}

TEST(ComparingMethods, RefusesFewerReadingsThanUnknownsWithTheReason) {
  Scenario scenario = *scenario_named("romer");
  scenario.readings = 8;
  const Comparison comparison = compare_methods(scenario, {.methods = {"cmm", "circle-points"}});
  for (const ComparisonRow& each : comparison.rows) {
    const bool says = !each.problem.empty() || each.score.point_rms_mm > 0.02;
    EXPECT_TRUE(says) << each.name;
  }
}

TEST(ComparingMethods, NamesTheMethodsWhereNoneIsMeant) {
  try {
    static_cast<void>(compared("romer", {"cnm"}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("no method matches \"cnm\""));
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"cmm\"?"));
  }
}

TEST(ComparingMethods, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      static_cast<void>(compare_methods(*scenario_named("romer"),
                                        {.methods = {"cmm"}, .monitor = {{}, stop.get_token()}})),
      Interrupted);
}

TEST(Methods, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Method& method : all_methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_FALSE(method.title.empty()) << method.name;
    EXPECT_FALSE(method.needs.empty()) << method.name;
  }
  EXPECT_GE(names.size(), 27u);
}

// A ball bar that turns about itself leaves one turn of each placement open; what is held for it
// must not make the rest look undetermined.
TEST(Methods, OfOpenTurnsAreWellConditioned) {
  const Comparison comparison = compared("romer", {"ball-bar", "straight-lines"});
  for (const ComparisonRow& each : comparison.rows) {
    EXPECT_LT(each.condition_number.value_or(1e9), 100.0) << each.name;
  }
}

TEST(Scenarios, DrawTheSameArmForTheSameSeed) {
  for (const std::string& name : scenario_names()) {
    const Scenario scenario = *scenario_named(name);
    const Eigen::VectorXd posture = Eigen::VectorXd::Constant(scenario.nominal.joint_count(), 0.4);
    EXPECT_EQ(bench_of(scenario, 5).arm.tip(posture), bench_of(scenario, 5).arm.tip(posture));
    EXPECT_NE(bench_of(scenario, 5).arm.tip(posture), bench_of(scenario, 6).arm.tip(posture));
  }
  EXPECT_FALSE(scenario_named("nobody").has_value());
}

}  // namespace
}  // namespace armcal
