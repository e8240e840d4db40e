// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/verification_report.h"
#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::words_of;

constexpr const char* kVerificationCommand = "verify iso10360-12";

TestResult length_errors(const std::vector<double>& errors_mm) {
  TestResult result;
  result.name = "length error, unidirectional";
  result.standard = "ISO 10360-12:2016";
  result.definition =
      "measured minus calibrated length, both ends touched from the same direction; of all lengths "
      "the one that takes the largest share of its limit, without a limit the largest by magnitude";
  result.symbol = "E_Uni";
  for (std::size_t i = 0; i < errors_mm.size(); ++i) {
    const double length_mm = 200.0 * static_cast<double>(i + 1);
    result.parts.push_back({.name = "at P1, repeat 1",
                            .value_mm = errors_mm[i],
                            .length_mm = length_mm,
                            .readings = 2,
                            .where = "bar.csv:7"});
    result.parts.back().name.insert(0, std::to_string(static_cast<int>(length_mm)) + " mm ");
  }
  result.value_mm = largest_by_magnitude(result.parts);
  return result;
}

VerifiedStatistic statistic_of(const TestResult& result,
                               const std::optional<MaximumPermissibleError>& mpe) {
  TestBudget budget{"1000.0000 mm", {}};
  budget.uncertainty.contributions = {
      {.name = "certificate", .source = UncertaintySource::certificate, .u = 0.003},
      {.name = "temperature of the artefact",
       .source = UncertaintySource::temperature,
       .u = 0.004}};
  VerifiedStatistic statistic;
  statistic.test = "length_uni";
  statistic.title = result.name;
  if (mpe) statistic.limit = mpe->text();
  statistic.as_found = judge(result, mpe, ExpandedUncertainty{0.005, 2.0}, {});
  statistic.budgets = {budget};
  statistic.mpe = mpe;
  return statistic;
}

/// Errors in five lengths against 20 um + L/50; U = 10 um.
Verification verification_example(const std::vector<double>& errors_mm) {
  Verification verification;
  verification.name = "arm 123";
  verification.standard = "ISO 10360-12:2016";
  verification.arm_file = "found.arm.toml";
  verification.reach_mm = 1500.0;
  verification.statistics = {
      statistic_of(length_errors(errors_mm), MaximumPermissibleError::linear(0.020, 50.0))};
  return verification;
}

const std::vector<double> kGood = {0.002, -0.004, 0.006, 0.011, -0.009};
const std::vector<double> kBad = {0.002, -0.004, 0.006, 0.0811, -0.009};

Page verification_page_of_example(const Verification& verification,
                                  const std::string& language = "en") {
  return page_in(language, document_of(kVerificationCommand, json_result(verification)));
}

TEST(VerificationPage, ShowsValueLimitUncertaintyAndVerdictAsTheDocumentHasThem) {
  const Page page = verification_page_of_example(verification_example(kBad));
  EXPECT_EQ(page.title, "Verification to ISO 10360-12:2016");
  EXPECT_EQ(page.subtitle, "arm 123");
  EXPECT_EQ(page.stamp.word, "Fail");
  EXPECT_EQ(page.stamp.tone, Tone::bad);
  // At 800 mm the limit is 20 um + 800/50 um.
  EXPECT_THAT(words_of(page), HasSubstr("length error, unidirectional | E_Uni | 0.0811 | 0.0360 | "
                                        "0.0100 | 225 | fail | "));
  EXPECT_THAT(words_of(page),
              HasSubstr("length error, unidirectional | 800 mm at P1, repeat 1 | bar.csv:7 | "
                        "20 \u00b5m + L/50 | "));
}

TEST(VerificationPage, SaysTheDecisionRuleWithItsCoverageFactor) {
  EXPECT_THAT(
      section_of(verification_page_of_example(verification_example(kGood)), "judgement").lead,
      HasSubstr("by the expanded uncertainty U of the test (k = 2)"));
  Verification guarded = verification_example(kGood);
  guarded.rule = {.kind = DecisionKind::guard_band, .guard_factor = 0.5};
  guarded.coverage_factor = 3.0;
  // Inside the guard band results fail; nothing is left open.
  const Section judged = section_of(verification_page_of_example(guarded), "judgement");
  for (const Block& block : judged.blocks) {
    if (const auto* figures = std::get_if<Figures>(&block)) {
      EXPECT_THAT(figures->items.at(0).svg, HasSubstr("guard band: fails"));
      EXPECT_THAT(figures->items.at(0).svg, Not(HasSubstr("neither proven")));
    }
  }
  EXPECT_THAT(section_of(verification_page_of_example(guarded), "judgement").lead,
              HasSubstr("passes inside the limit by 0.5 U (k = 3), else fails"));
}

TEST(VerificationPage, SetsAsFoundBesideAsLeft) {
  Verification verification = verification_example(kBad);
  verification.as_left_file = "left.arm.toml";
  verification.statistics[0].as_left = verification_example(kGood).statistics[0].as_found;
  const Page page = verification_page_of_example(verification);
  EXPECT_EQ(page.stamp.word, "Pass");
  EXPECT_THAT(page.stamp.sentence, HasSubstr("The arm as found: fail."));
  EXPECT_THAT(words_of(page), HasSubstr("| 0.0811 | 0.0110 | 0.0360 |"));
  EXPECT_THAT(words_of(page), HasSubstr("Arm as left: left.arm.toml"));
}

// A table of coordinates cannot be put through the arm as left.
TEST(VerificationPage, LeavesAsLeftBlankWhereOnlyAsFoundWasMeasured) {
  Verification verification = verification_example(kBad);
  verification.as_left_file = "left.arm.toml";
  verification.statistics[0].as_left = verification_example(kGood).statistics[0].as_found;
  verification.statistics.push_back(
      statistic_of(length_errors({0.0123, 0.0044}), MaximumPermissibleError::constant(0.040)));
  const std::string words = words_of(verification_page_of_example(verification));
  EXPECT_THAT(words, HasSubstr("| E_Uni | 0.0123 | – | 0.0400 | 0.0100 | 31 | pass | "));
  EXPECT_THAT(words, HasSubstr("| 400 mm at P1, repeat 1 | 0.0044 | – | bar.csv:7 | "));
}

TEST(VerificationPage, DrawsEachLengthBetweenItsLimits) {
  const Section values =
      section_of(verification_page_of_example(verification_example(kGood)), "values");
  ASSERT_EQ(values.blocks.size(), 2u);
  const Figure& figure = std::get<Figures>(values.blocks[0]).items.at(0);
  const Json live = Json::parse(figure.live);
  EXPECT_THAT(figure.live, HasSubstr("MPE"));
  // 20 um + 1000/50 um at the longest length, on both sides.
  EXPECT_THAT(figure.live, HasSubstr("0.04"));
  EXPECT_THAT(figure.live, HasSubstr("-0.04"));
  // Whoever cannot see it reads them below.
  const Table& table = std::get<Table>(values.blocks[1]);
  ASSERT_EQ(table.rows.size(), kGood.size());
  EXPECT_EQ(table.rows[1][1].text, "400 mm at P1, repeat 1");
  EXPECT_EQ(table.rows[1][2].text, "-0.0040");
}

// At other lengths the two arms have other limits.
TEST(VerificationPage, GivesTheArmAsFoundItsOwnLimit) {
  Verification verification = verification_example({0.002, -0.004, 0.006, 0.011, -0.089});
  verification.as_left_file = "left.arm.toml";
  verification.statistics[0].as_left =
      verification_example({0.023, -0.004, 0.006, 0.011, -0.009}).statistics[0].as_found;
  const Page page = verification_page_of_example(verification);
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("As found, mm | MPE as found, mm | As left, mm | MPE, mm"));
  EXPECT_THAT(words, HasSubstr("-0.0890 | 0.0400 | 0.0230 | 0.0240"));
  EXPECT_THAT(words, HasSubstr("unidirectional, as found | 1000 mm at P1, repeat 1"));
  EXPECT_THAT(words, HasSubstr("unidirectional, as left | 200 mm at P1, repeat 1"));
}

TEST(VerificationPage, SaysWhatWasMeasuredOnAndWhatWasNotTested) {
  Verification verification = verification_example(kGood);
  verification.environment = {20.8, 0.3};
  verification.not_performed = {"articulated location error"};
  verification.artefacts.resize(2);
  verification.artefacts[0].name = "ball A";
  verification.artefacts[0].diameter_mm = 25.40012;
  verification.artefacts[0].U_mm = 0.0004;
  verification.artefacts[0].form_mm = 0.0002;
  verification.artefacts[0].certificate = "DKD 0815";
  verification.artefacts[1].name = "bar";
  verification.artefacts[1].is_sphere = false;
  verification.artefacts[1].expansion_per_K = 11.5e-6;
  verification.artefacts[1].u_expansion_per_K = 1e-6;
  verification.artefacts[1].lengths = {{"1", 500.0012, 0.0006}};
  const Page page = verification_page_of_example(verification);
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("ball A, diameter | DKD 0815 | 25.40012 | 0.40 | 2 | 0.20 | "));
  EXPECT_THAT(words, HasSubstr("bar, 1 |  | 500.00120 | 0.60 | 2 | \u2013 | 11.50 \u00b1 1.00"));
  EXPECT_THAT(words, HasSubstr("20.8 \u00b0C, standard uncertainty 0.30 K"));
  EXPECT_THAT(words, HasSubstr("not performed\narticulated location error"));
  EXPECT_THAT(words_of(verification_page_of_example(verification, "zh")),
              HasSubstr("未进行的标准规定检测项目\n铰接位置误差"));
}

// A pass with readings missing is no pass of the standard.
TEST(VerificationPage, WarnsOfWhatIsMissing) {
  Verification verification = verification_example(kGood);
  TestResult& result = verification.statistics[0].as_found.result;
  result.symbol.clear();
  result.missing = {"length 200 mm at 1 position, 7 are asked for"};
  const Page page = verification_page_of_example(verification, "zh");
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(words_of(page),
              HasSubstr("长度测量误差（单向）：长度 200 mm 只有 1 个位置，要求 7 个"));
  EXPECT_EQ(page.stamp.word, "合格（不完整）");
  EXPECT_THAT(page.stamp.sentence, HasSubstr("缺少标准要求的读数"));
}

TEST(VerificationPage, SaysWhereNothingWasJudged) {
  Verification verification = verification_example(kGood);
  verification.statistics = {statistic_of(length_errors(kGood), {})};
  verification.statistics[0].budgets.clear();
  const Page page = verification_page_of_example(verification);
  EXPECT_EQ(page.stamp.word, "Not judged");
  EXPECT_EQ(page.stamp.tone, Tone::neutral);
  EXPECT_THAT(words_of(page), HasSubstr("| 0.0110 | – |"));
  EXPECT_THAT(words_of(page), Not(HasSubstr("Uncertainty of the tests")));
}

// A value that none of the readings could give.
TEST(VerificationPage, StandsWithoutAnyValue) {
  Verification verification = verification_example({});
  verification.statistics = {statistic_of(length_errors({}), {})};
  EXPECT_THAT(words_of(verification_page_of_example(verification)), HasSubstr("E_Uni | – | – |"));
}

TEST(VerificationPage, SpeaksChineseAndLeavesSymbolsAndNames) {
  const std::string words =
      words_of(verification_page_of_example(verification_example(kBad), "zh"));
  EXPECT_THAT(words, HasSubstr("长度测量误差（单向） | E_Uni | 0.0811"));
  EXPECT_THAT(words, HasSubstr("不合格"));
  EXPECT_THAT(words, HasSubstr("标准器温度"));
  EXPECT_THAT(words, Not(HasSubstr("measured minus")));
  EXPECT_THAT(words, HasSubstr("arm 123"));
}

TEST(VerificationPage, NamesTheKeyThatAnEditedDocumentLacks) {
  Json document = document_of(kVerificationCommand, json_result(verification_example(kGood)));
  document["tests"][0].erase("complete");
  try {
    (void)page_in("en", document);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("saved.json: error: key tests[0].complete: is missing"));
  }
  document = document_of(kVerificationCommand, json_result(verification_example(kGood)));
  document["decision"]["rule"] = "by mood";
  EXPECT_THROW((void)page_in("en", document), InputError);
  document = document_of(kVerificationCommand, json_result(verification_example(kGood)));
  document["verdict"] = "maybe";
  EXPECT_THROW((void)page_in("en", document), InputError);
}

// Results that were saved before these keys were there.
TEST(VerificationPage, ReadsOlderDocuments) {
  Json document = document_of(kVerificationCommand, json_result(verification_example(kGood)));
  Json& test = document["tests"][0];
  for (const char* key : {"title", "is_signed", "guard_mm"}) test.erase(key);
  for (Json& part : test["parts"]) part.erase("mpe_mm");
  EXPECT_EQ(page_in("en", document).stamp.word, "Pass");
}

TEST(VerificationPage, KeepsTheLawsOfPages) {
  Verification verification = verification_example({0.002, -0.004});
  verification.as_left_file = "left.arm.toml";
  verification.statistics[0].as_left = verification.statistics[0].as_found;
  testing::expect_page_laws(document_of(kVerificationCommand, json_result(verification)));
}

}  // namespace
}  // namespace armcal
