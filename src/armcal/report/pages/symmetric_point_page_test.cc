// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/symmetric_point_report.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::words_of;

Json document_with_readings(double l_PP3, double R, bool with_claims) {
  SymmetricPointProcedure procedure;
  procedure.readings = testing::wang2016_readings(l_PP3, R);
  if (with_claims) procedure.claims = testing::wang2016_claims();
  Diagnostics diagnostics;
  const auto analysis =
      analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics);
  Json document = document_of("symmetric-point", json_result(*analysis));
  // The command names the arm's file.
  if (!document.contains("arm")) document["arm"] = "nominal.arm.toml";
  return document;
}

Json as_printed() { return document_with_readings(104.070, 178.383, true); }

TEST(SymmetricPointPage, SaysTheFindingOfThePaper) {
  for (const char* language : {"en", "zh"}) {
    const Page page = page_in(language, as_printed());
    const Notice& findings = std::get<Notice>(page.sections.at(0).blocks.at(1));
    std::string first = findings.lines.at(0);
    EXPECT_THAT(first, HasSubstr("l_PP3"));
    EXPECT_THAT(first, HasSubstr("104.700"));
    EXPECT_THAT(first, HasSubstr("78.312"));
    EXPECT_EQ(page.stamp.tone, Tone::bad);
  }
}

// Each of three readings that share one check was called wrong by itself.
TEST(SymmetricPointPage, AccusesNoReadingThatCannotBeToldFromOthers) {
  const Page page = page_in("en", document_with_readings(104.700, 178.483, false));
  const auto& headlines = std::get<Headlines>(page.sections.at(0).blocks.at(0)).items;
  EXPECT_EQ(headlines.at(0).note, "3 of them are checked by others; degrees of freedom: 1");
  EXPECT_EQ(headlines.at(2).note, "degrees of freedom: 1; probability 7e-194");
  EXPECT_EQ(headlines.at(3).value, "1");
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("The one check that l_PP1, l_PP2, R give each other fails"));
  EXPECT_THAT(words, HasSubstr("these readings cannot tell which"));
  EXPECT_THAT(words, Not(HasSubstr("does not agree with the other readings")));
}

// As many readings as parameters agree with anything.
TEST(SymmetricPointPage, CallsNothingConsistentThatNothingChecks) {
  Json document = document_with_readings(78.312, 178.483, false);
  document["consistent"] = true;
  document["claims"] = Json::array();
  EXPECT_EQ(page_in("en", document).stamp.sentence,
            "No reading that others check fails its check.");
  for (Json& reading : document["readings"]) {
    reading["normalised"] = nullptr;
    reading["flagged"] = false;
  }
  const Page page = page_in("en", document);
  EXPECT_EQ(page.stamp.word, "Not checked");
  EXPECT_EQ(page.stamp.tone, Tone::warning);
}

TEST(SymmetricPointPage, WritesADashWhereNoConditionNumberIsFinite) {
  Json document = as_printed();
  document["condition_number"] = nullptr;
  EXPECT_THAT(words_of(page_in("en", document)), HasSubstr("condition number \u2013"));
}

TEST(SymmetricPointPage, MarksClaimsByTheirVerdicts) {
  const Json document = as_printed();
  const Page page = page_in("en", document);
  const auto table = std::get<Table>(section_of(page, "claims").blocks.at(0));
  ASSERT_EQ(table.rows.size(), document["claims"].size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Json& claim = document["claims"][i];
    EXPECT_EQ(table.rows[i][0].text, claim["name"]);
    EXPECT_EQ(table.rows[i][1].text, fmt::format("{:.3f}", claim["claimed"].get<double>()));
    EXPECT_EQ(table.rows[i][5].tone, claim["agrees"].get<bool>() ? Tone::good : Tone::bad);
    if (!claim["agrees"].get<bool>()) ++wrong;
  }
  EXPECT_GT(wrong, 0U);
  const Headlines& headlines = std::get<Headlines>(page.sections.at(0).blocks.at(0));
  EXPECT_EQ(headlines.items.back().value, std::to_string(wrong));
}

TEST(SymmetricPointPage, DrawsThePostureOfEveryReading) {
  const Json document = as_printed();
  const Page page = page_in("zh", document);
  const auto postures = std::get<Figures>(section_of(page, "postures").blocks.at(0)).items;
  ASSERT_EQ(postures.size(), 6U);
  for (std::size_t i = 0; i < postures.size(); ++i) {
    EXPECT_EQ(postures[i].title, document["readings"][i]["name"]);
    EXPECT_EQ(postures[i].id, fmt::format("posture-{}", i + 1));
    EXPECT_THAT(postures[i].svg, HasSubstr("<svg"));
    EXPECT_THAT(postures[i].svg, Not(HasSubstr("nan")));
  }
}

TEST(SymmetricPointPage, MapsWhatAssumptionsDoToTheResult) {
  const Json document = as_printed();
  const auto map =
      std::get<Figures>(section_of(page_in("en", document), "leakage").blocks.at(0)).items.at(0);
  for (const Json& row : document["leakage_rows"]) {
    EXPECT_THAT(map.svg, HasSubstr(">" + row.get<std::string>() + "<"));
  }
}

TEST(SymmetricPointPage, HasNoClaimsWhereNothingIsClaimed) {
  const Page page = page_in("en", document_with_readings(104.700, 178.383, false));
  for (const Section& section : page.sections) EXPECT_NE(section.id, "claims");
}

TEST(SymmetricPointPage, SaysThatReadingsThatContradictEachOtherDo) {
  Json document = document_with_readings(104.700, 178.483, false);
  const Page page = page_in("en", document);
  EXPECT_EQ(page.stamp.tone, Tone::bad);
  EXPECT_THAT(words_of(page), HasSubstr("fails"));
}

TEST(SymmetricPointPage, RefusesAMapThatIsNoMatrix) {
  Json document = as_printed();
  document["leakage"][0].erase(0);
  EXPECT_THROW((void)page_in("en", document), InputError);
  document["leakage"].erase(0);
  try {
    (void)page_in("en", document);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("key leakage: has not as many rows as leakage_rows"));
  }
}

TEST(SymmetricPointPage, KeepsTheLawsOfPages) { testing::expect_page_laws(as_printed()); }

}  // namespace
}  // namespace armcal
