// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/check_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/check_report.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/weekly_checks.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::words_of;

// A check a week from 2026-01-05 on.
CheckSummary check_example(const std::vector<double>& history_mm) {
  const std::vector<TouchedPlace> places = {
      {"A", {{0, 0, 0}, {0.03, 0, 0}, {-0.03, 0, 0}}},
      {"B", {{400.01, 0, 0}, {400.01, 0.03, 0}, {400.01, -0.03, 0}}}};
  InterimCheckOptions options;
  options.length_mm = 400.0;
  options.limits.deviation_mm = 0.02;
  options.limits.length_mm = 0.05;
  CheckSummary summary;
  summary.arm = "arm 7";
  summary.artefact = "bar 400";
  summary.time = 1767571200;
  summary.check = check_arm(places, options);
  summary.history = "checks.db";
  if (!history_mm.empty()) summary.trends = {testing::weekly_checks(history_mm)};
  return summary;
}

Page check_page_of_example(const CheckSummary& summary, const std::string& language = "en") {
  return page_in(language, document_of("check", json_result(summary)));
}

const std::vector<double> kQuiet = {0.00, 0.01, 0.00, 0.01, 0.005};
const std::vector<double> kRising = {0.000, 0.002, 0.004, 0.006, 0.030};

TEST(CheckPage, ShowsEachNumberAgainstItsLimit) {
  const Page page = check_page_of_example(check_example(kQuiet));
  EXPECT_EQ(page.stamp.word, "Fail");
  EXPECT_EQ(page.subtitle, "arm 7");
  EXPECT_THAT(words_of(page), HasSubstr("Largest deviation | 0.0300 | 0.0200 | 150 | fail | "));
  EXPECT_THAT(words_of(page), HasSubstr("Length error | 0.0100 | 0.0500 | 20 | pass | "));
  EXPECT_THAT(words_of(page), HasSubstr("Length | 400.0100 | – | – | – | "));
}

TEST(CheckPage, DrawsTheHistoryWithCentreLimitsAndDrift) {
  const Section section = section_of(check_page_of_example(check_example(kQuiet)), "trend-of-1");
  const Figure& figure = std::get<Figures>(section.blocks.at(0)).items.at(0);
  // Centre 0.005; sigma 0.01 / 1.128 of the first four.
  EXPECT_THAT(figure.text, HasSubstr("Centre 0.0050 mm and σ = 0.0089 mm come from the first 4"));
  for (const char* word : {"centre", "limit", "drift", "3 σ", "days since 2026-01-05"}) {
    EXPECT_THAT(figure.svg, HasSubstr(word));
  }
}

TEST(CheckPage, NamesBrokenRulesInTheLanguageOfTheReader) {
  EXPECT_THAT(
      words_of(check_page_of_example(check_example(kRising))),
      HasSubstr("5 | 2026-02-02 | 1 check more than 3 σ above the centre line (rule 1) | "));
  EXPECT_THAT(words_of(check_page_of_example(check_example(kRising), "zh")),
              HasSubstr("5 | 2026-02-02 | 1 次核查值位于中心线上方 3 σ 以外（准则 1） | "));
}

// Of a signed value near -limit the chart had no limit, and the text said that it lay beyond.
TEST(CheckPage, DrawsTheLimitThatIsNear) {
  const Page page = check_page_of_example(check_example({-0.045, -0.044, -0.046, -0.045, -0.060}));
  const Section section = section_of(page, "trend-of-1");
  const Figure& figure = std::get<Figures>(section.blocks.at(0)).items.at(0);
  EXPECT_THAT(figure.text, Not(HasSubstr("lies beyond this chart")));
  EXPECT_THAT(figure.svg, HasSubstr(">limit<"));
}

TEST(CheckPage, SaysTheDriftWithItsUncertainty) {
  const CheckSummary rising = check_example(kRising);
  const double slope = 30.0 * rising.trends[0].drift->mm_per_day;
  EXPECT_THAT(words_of(check_page_of_example(rising)),
              HasSubstr(fmt::format("+{:.4f} mm (u = ", slope)));
  EXPECT_THAT(words_of(check_page_of_example(check_example(kQuiet))),
              HasSubstr("No drift beyond chance"));
}

// What exceeds no limit may still have changed.
TEST(CheckPage, WarnsOfTheLastCheckBesideAPass) {
  CheckSummary summary = check_example(kRising);
  for (CheckValue& value : summary.check->values) {
    if (value.verdict == Verdict::fail) value.verdict = Verdict::pass;
  }
  const Page page = check_page_of_example(summary);
  EXPECT_EQ(page.stamp.word, "Pass");
  EXPECT_EQ(page.stamp.tone, Tone::warning);
}

TEST(CheckPage, StandsWithoutHistoryAndWithoutCheck) {
  CheckSummary alone = check_example({});
  alone.history.reset();
  EXPECT_THAT(words_of(check_page_of_example(alone)), HasSubstr("was not saved in a history"));

  CheckSummary look = check_example(kQuiet);
  look.check.reset();
  const Page page = check_page_of_example(look);
  EXPECT_EQ(page.stamp.word, "As usual");
  EXPECT_THAT(words_of(page), Not(HasSubstr("Values against their limits")));

  look.trends = {testing::weekly_checks({0.00, 0.01, 0.00, 0.01, 0.06})};
  const Page exceeded = check_page_of_example(look);
  EXPECT_EQ(exceeded.stamp.word, "Limit exceeded");
  EXPECT_THAT(exceeded.stamp.sentence, HasSubstr("At the last check a limit was exceeded"));
  EXPECT_THAT(words_of(exceeded), HasSubstr("0.0600 | 0.0500 | 5 | "));

  // One check: no centre line, no drift.
  EXPECT_THAT(words_of(check_page_of_example(check_example({0.01}))), HasSubstr("too few checks"));
}

TEST(CheckPage, SaysWhatTheCheckWasHeldAgainst) {
  CheckSummary summary = check_example({});
  summary.options.length_mm = 500.0012;
  summary.temperature_C = 20.8;
  summary.note = "after the move";
  const std::string words = words_of(check_page_of_example(summary));
  EXPECT_THAT(words, HasSubstr("Certified length: 500.0012 mm\n"));
  EXPECT_THAT(words, HasSubstr("Temperature: 20.8 \u00b0C\n"));
  EXPECT_THAT(words, HasSubstr("Note: after the move\n"));
  EXPECT_THAT(words, Not(HasSubstr("Tip diameter")));
}

TEST(CheckPage, RefusesATimeThatIsNone) {
  Json document = document_of("check", json_result(check_example(kQuiet)));
  document["trends"][0]["checks"][1]["time"] = "yesterday";
  try {
    (void)page_in("en", document);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("key trends[0].checks[1].time: is no time"));
  }
}

TEST(CheckPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_of("check", json_result(check_example(kRising))));
}

}  // namespace
}  // namespace armcal
