// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/comparison_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/comparison/methods/registry.h"
#include "armcal/report/comparison_report.h"
#include "armcal/report/paper_sphere_report.h"
#include "armcal/report/session_comparison_report.h"
#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::words_of;

Json drawn_arms() {
  Comparison comparison{*scenario_named("romer"), 5, 3, 0.0154, {}};
  ComparisonRow good{.name = "cmm",
                     .title = "least squares",
                     .reference = "Somebody 2007",
                     .needs = "a machine",
                     .readings = 120,
                     .arms = 3};
  good.score = {0.004, 0.0037, 0.008, 0.0032, 1.04, 63, 61};
  good.condition_number = 7.7;
  good.seconds = 0.0031;
  ComparisonRow partly = good;
  partly.title = "ball bar";
  partly.arms = 2;
  partly.problem = "out of reach";
  const ComparisonRow never{.name = "chain", .title = "chain", .problem = "for six joints"};
  comparison.rows = {good, partly, never};
  return document_of("compare", json_result(comparison));
}

Json session() {
  SessionComparison comparison{.arm_name = "arm 7", .fitted = 70, .held_out = 30, .rows = {}};
  SessionComparisonRow row{.name = "ls", .title = "least squares", .parameters = 21};
  row.fitted = RowFigures{{70, 0.01, 0.009, 0.02}, 1.0};
  row.held_out = RowFigures{{30, 0.011, 0.01, 0.021}, 1.1};
  row.seconds = 0.25;
  comparison.rows = {row, {.name = "no", .title = "no method", .problem = "too few"}};
  return document_of("compare", json_result(comparison));
}

Json effects() {
  NeglectedEffect effect{"twists", "0.025 deg", 400, {}, {}};
  effect.one_articulation = {0.002, 0.01, 0.0, 0.01};
  effect.five_articulations = {0.16, 0.9, 0.8, 0.5};
  return document_of("compare", json_result(std::vector<NeglectedEffect>{effect}));
}

// The one table of a page.
Table table_of(const Page& page) {
  for (const Section& section : page.sections) {
    for (const Block& block : section.blocks) {
      if (const auto* table = std::get_if<Table>(&block)) return *table;
    }
  }
  ADD_FAILURE() << "no table";
  return {};
}

TEST(ComparisonPage, HasTheNumbersOfItsMethods) {
  const std::string words = words_of(page_in("en", drawn_arms()));
  EXPECT_THAT(words, HasSubstr("1 | least squares | a machine | 120 | 0.0040 | 0.0037 | 0.0080 | "
                               "0.0032 | 1.04 | 61/63 | 0.0031 s | "));
  EXPECT_THAT(words, HasSubstr("out of reach | "));
  EXPECT_THAT(words, HasSubstr("3 | chain | "));
  EXPECT_THAT(words, HasSubstr("for six joints | "));
  EXPECT_THAT(words, HasSubstr("0.0154"));
}

TEST(ComparisonPage, OfASessionJudgesByRowsHeldOut) {
  const Page page = page_in("en", session());
  EXPECT_EQ(page.subtitle, "arm 7");
  EXPECT_THAT(words_of(page), HasSubstr("1 | least squares | 21 | 0.0100 | 0.0110 | 0.0100 | "
                                        "0.0210 | 1.10 | 0.25 s | "));
  EXPECT_THAT(words_of(page), HasSubstr("too few | "));
}

TEST(ComparisonPage, OfThePapersSphereSaysHowManyArmsReachItsError) {
  const std::string words = words_of(page_in("en", effects()));
  EXPECT_THAT(words, HasSubstr("twists | 0.025 deg | 400 | 0.0020 | 0.0100 | 0 % | 0.1600 | 0.9000 "
                               "| 80 % | 0.5000 | "));
}

// A method that found nothing has a cell under every title all the same.
TEST(ComparisonPage, HasACellUnderEveryTitle) {
  for (const Json& document : {drawn_arms(), session(), effects()}) {
    for (const char* language : {"en", "zh"}) {
      const Table table = table_of(page_in(language, document));
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
}

// The points of the charts have the numbers of the table.
TEST(ComparisonPage, NumbersPointsAsTheTableDoes) {
  const Page page = page_in("en", drawn_arms());
  const auto figures = std::get<Figures>(page.sections.at(0).blocks.back()).items;
  ASSERT_EQ(figures.size(), 2U);
  for (const Figure& figure : figures) {
    EXPECT_THAT(figure.svg, HasSubstr(">1<"));
    EXPECT_THAT(figure.svg, HasSubstr(">2<"));
    EXPECT_THAT(figure.svg, Not(HasSubstr(">3<")));
  }
}

TEST(ComparisonPage, BeginsWithTheSmallestErrorAndWhatItIsHeldAgainst) {
  Json document = drawn_arms();
  document["methods"].push_back(document["methods"][0]);
  document["methods"][3]["title"] = "nominal arm";
  document["methods"][3]["readings"] = 0;
  document["methods"][3]["point_rms_mm"] = 0.47;
  document["methods"][1]["point_rms_mm"] = 0.0033;
  const auto headlines =
      std::get<Headlines>(page_in("en", document).sections.at(0).blocks.front()).items;
  ASSERT_EQ(headlines.size(), 4U);
  EXPECT_EQ(headlines[0].value, "4");
  EXPECT_EQ(headlines[1].value, "0.4700");
  EXPECT_EQ(headlines[2].value, "0.0033");
  EXPECT_THAT(headlines[2].note, HasSubstr("ball bar"));
  EXPECT_EQ(headlines[3].value, "0.0154");
}

TEST(ComparisonPage, NamesEveryMethodInTheLanguageOfTheReader) {
  Comparison comparison{*scenario_named("romer"), 5, 3, 0.0154, {}};
  for (const Method& method : all_methods()) {
    comparison.rows.push_back({.name = method.name, .title = method.title, .needs = method.needs});
  }
  ASSERT_GT(comparison.rows.size(), 20U);
  const Page page = page_in("zh", document_of("compare", json_result(comparison)));
  for (const auto& row : table_of(page).rows) {
    for (const Cell& cell : row) EXPECT_THAT(cell.text, Not(::testing::ContainsRegex("[a-z]{4}")));
  }
}

TEST(ComparisonPage, KeepsTheLawsOfPages) {
  for (const Json& document : {drawn_arms(), session(), effects()}) {
    testing::expect_page_laws(document);
  }
}

}  // namespace
}  // namespace armcal
