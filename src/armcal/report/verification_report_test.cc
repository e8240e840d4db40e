// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A length error of `error_mm` on 1000 mm against 40 um, U = 10 um.
Judged length_error(double error_mm) {
  TestResult result;
  result.name = "length error";
  result.standard = "ISO 10360-12:2016";
  result.definition = "measured minus calibrated length";
  result.symbol = "E_Uni";
  result.value_mm = error_mm;
  result.parts = {{.name = "1000 mm at P1",
                   .value_mm = error_mm,
                   .length_mm = 1000.0,
                   .readings = 2,
                   .where = "bar.csv:7"}};
  return judge(result, MaximumPermissibleError::constant(0.040), ExpandedUncertainty{0.005, 2.0},
               {});
}

Verification verification_in_text() {
  TestBudget budget{"1000.0000 mm", {}};
  budget.uncertainty.contributions = {
      {.name = "certificate", .source = UncertaintySource::certificate, .u = 0.003},
      {.name = "temperature", .source = UncertaintySource::temperature, .u = 0.004}};
  Verification verification;
  verification.name = "arm 123";
  verification.standard = "ISO 10360-12:2016";
  verification.arm_file = "found.arm.toml";
  verification.statistics = {
      {"length_uni", "length error", "40 um", length_error(0.080), {}, {budget}}};
  return verification;
}

TEST(VerificationReport, TextNamesValueLimitUncertaintyAndReading) {
  const std::string text = text_result(verification_in_text());
  EXPECT_THAT(text, HasSubstr("Verification of arm 123 to ISO 10360-12:2016: fail"));
  EXPECT_THAT(text, HasSubstr("length error  E_Uni     0.0800  0.0400  0.0100     fail"));
  EXPECT_THAT(text, HasSubstr("length error: 1000 mm at P1 (from bar.csv:7), limit 40 um"));
  EXPECT_THAT(text, HasSubstr("length error: measured minus calibrated length"));
  EXPECT_THAT(text, HasSubstr("3.00     -         4.00          -              -  5.00  10.00"));
  EXPECT_THAT(text, Not(HasSubstr("as left")));
}

// As left counts, and stands beside as found.
TEST(VerificationReport, SetsAsFoundBesideAsLeft) {
  Verification verification = verification_in_text();
  verification.as_left_file = "left.arm.toml";
  verification.statistics.front().as_left = length_error(0.020);
  EXPECT_EQ(verification.verdict(), Verdict::pass);
  EXPECT_EQ(verification.as_found_verdict(), Verdict::fail);
  const std::string text = text_result(verification);
  EXPECT_THAT(text, HasSubstr("as found   found.arm.toml: fail"));
  EXPECT_THAT(text, HasSubstr("as left    left.arm.toml: pass"));
  EXPECT_THAT(text,
              HasSubstr("length error  E_Uni        0.0800     fail      0.0200  0.0400  0.0100"));
  const Json json = json_result(verification);
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["as_found_verdict"], "fail");
  EXPECT_EQ(json["tests"][0]["value_mm"], 0.020);
  EXPECT_EQ(json["tests"][0]["as_found"]["value_mm"], 0.080);
  EXPECT_THAT(text, HasSubstr("length error, as found: 1000 mm at P1"));
  EXPECT_THAT(text, HasSubstr("length error, as left: 1000 mm at P1"));
}

// What decides may be another length, with another limit.
TEST(VerificationReport, GivesTheArmAsFoundItsOwnLimit) {
  Verification verification = verification_in_text();
  verification.as_left_file = "left.arm.toml";
  verification.statistics.front().as_left = length_error(0.020);
  verification.statistics.front().as_found.mpe_mm = 0.055;
  EXPECT_THAT(text_result(verification),
              HasSubstr("length error  E_Uni        0.0800  0.0550     fail      0.0200  0.0400"));
}

TEST(VerificationReport, SaysWhatWasMeasuredOnAndWhatWasNotTested) {
  Verification verification = verification_in_text();
  EXPECT_THAT(text_result(verification), Not(HasSubstr("not performed")));
  verification.not_performed = {"articulated location error", "length error"};
  EXPECT_THAT(text_result(verification),
              HasSubstr("\nTests of the standard that were not performed: articulated location "
                        "error, length error\n"));
  verification.statistics.front().artefact = "bar";
  StatedArtefact bar;
  bar.name = "bar";
  bar.is_sphere = false;
  bar.certificate = "DKD 0815";
  bar.lengths = {{"1", 500.0012, 0.0006}};
  verification.artefacts = {bar};
  verification.environment = {20.8, 0.3};
  const Json json = json_result(verification);
  EXPECT_EQ(json["tests"][0]["artefact"], "bar");
  EXPECT_EQ(json["not_performed"].size(), 2U);
  EXPECT_EQ(json["environment"]["temperature_C"], 20.8);
  EXPECT_EQ(json["artefacts"][0]["certificate"], "DKD 0815");
  EXPECT_EQ(json["artefacts"][0]["lengths"][0]["U_mm"], 0.0006);
  EXPECT_FALSE(json["artefacts"][0].contains("diameter_mm"));
}

TEST(VerificationReport, JsonHasWhatProgramsRelyOn) {
  const Json json = json_result(verification_in_text());
  EXPECT_EQ(json["verdict"], "fail");
  const Json& test = json["tests"][0];
  EXPECT_EQ(test["name"], "length error");
  EXPECT_EQ(test["symbol"], "E_Uni");
  EXPECT_EQ(test["value_mm"], 0.080);
  EXPECT_EQ(test["mpe_mm"], 0.040);
  EXPECT_EQ(test["U_mm"], 0.010);
  EXPECT_EQ(test["verdict"], "fail");
  EXPECT_EQ(test["complete"], true);
  EXPECT_LT(test["conformance_probability"].get<double>(), 1e-9);  // 8 u beyond the limit
  EXPECT_EQ(test["decided_by"], "1000 mm at P1");
  EXPECT_EQ(test["parts"][0]["where"], "bar.csv:7");
  EXPECT_NEAR(test["budgets"][0]["u_mm"].get<double>(), 0.005, 1e-15);
}

TEST(VerificationReport, SaysWhatAnIncompleteTestLacksAndGivesNoSymbol) {
  Verification verification = verification_in_text();
  Judged& judged = verification.statistics.front().as_found;
  judged.result.symbol.clear();
  judged.result.missing = {"1 position, 7 are asked for"};
  const std::string text = text_result(verification);
  EXPECT_THAT(text, HasSubstr("Incomplete: not a test of the standard\n  length_uni: 1 position, 7 "
                              "are asked for"));
  EXPECT_THAT(text, Not(HasSubstr("E_Uni")));
  const Json test = json_result(verification)["tests"][0];
  EXPECT_TRUE(test["symbol"].is_null());
  EXPECT_EQ(test["complete"], false);
}

}  // namespace
}  // namespace armcal
