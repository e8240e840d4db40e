// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/symmetric_point_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

SymmetricPointAnalysis analysis_of(double l_PP3, double R, bool with_claims) {
  SymmetricPointProcedure procedure;
  procedure.readings = testing::wang2016_readings(l_PP3, R);
  if (with_claims) procedure.claims = testing::wang2016_claims();
  Diagnostics diagnostics;
  return *analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics);
}

TEST(SymmetricPointReport, SaysTheFindingOfThePaperInOneSentence) {
  const auto found = findings(analysis_of(104.070, 178.383, true));
  EXPECT_THAT(
      found,
      Contains(
          "l_PP3 = 104.070 contradicts a5 = 78.312 and b3 = 747.489; 104.700 agrees with both."))
      << ::testing::PrintToString(found);
  EXPECT_THAT(found,
              Contains(HasSubstr("b7 = 178.383 contradicts the readings, which give 176.484")));
  EXPECT_THAT(found, Contains(HasSubstr("It is the same length as the reading R.")));
  EXPECT_THAT(
      found,
      Contains(
          "l_PP3, l_PP4 and l_PP5 are checked by nothing: an error of theirs goes whole into the "
          "result (a5, b5 and b3)."));
}

TEST(SymmetricPointReport, SaysThatItCannotTellWhichOfThreeIsWrong) {
  const auto found = findings(analysis_of(104.700, 178.483, false));
  EXPECT_THAT(found,
              Contains(HasSubstr("The one check that l_PP1, l_PP2 and R give each other fails")));
  EXPECT_THAT(found, Contains(HasSubstr("these readings cannot tell which")));
}

TEST(SymmetricPointReport, JsonHasTheKeysThatProgramsRelyOn) {
  const Json json = json_result(analysis_of(104.070, 178.383, true));
  EXPECT_NEAR(json["chain"]["b7"].get<double>(), 176.484, 1e-9);
  EXPECT_NEAR(json["adjusted"]["b7"]["value"].get<double>(), 176.484, 1e-3);
  EXPECT_GT(json["adjusted"]["b7"]["u"].get<double>(), 0.0);
  const Json& reading = json["readings"][2];
  EXPECT_EQ(reading["name"], "l_PP3");
  EXPECT_EQ(reading["redundancy"], 0.0);
  EXPECT_TRUE(reading["normalised"].is_null());
  EXPECT_TRUE(reading["smallest_detectable_mm"].is_null());
  EXPECT_EQ(reading["flagged"], false);
  EXPECT_EQ(json["claims"][0]["contradicted_by"], "l_PP3");
  EXPECT_NEAR(json["claims"][0]["reconciled_by_mm"].get<double>(), 104.7, 1e-6);
  EXPECT_EQ(json["leakage"].size(), json["leakage_rows"].size());
  EXPECT_EQ(json["leakage"][0].size(), json["leakage_columns"].size());
  EXPECT_EQ(json["consistent"], false);
}

TEST(SymmetricPointReport, TextHasEverySection) {
  const std::string text = text_result(analysis_of(104.070, 178.383, true));
  for (const char* part :
       {"Readings", "Parameters", "Claims", "Leakage of the chain", "Findings"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace armcal
