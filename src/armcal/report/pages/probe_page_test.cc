// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/probe_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using testing::page_in;
using testing::words_of;

/// The keys that the page reads; the whole document is tried on the examples.
Json document_with_probe(const Json& limit_mm, const std::string& verdict) {
  Json result;
  result["arm_name"] = "arm 7";
  result["groups"] = {{{"name", "stylus"}, {"count", 25}, {"rms_mm", 0.0049}, {"max_mm", 0.0123}}};
  result["stated"] = {{"sphere_diameter_mm", 15.8754},
                      {"tip_diameter_mm", 6.0},
                      {"u_mm", 0.02},
                      {"u_encoder_arcsec", 0.0}};
  result["dof"] = 72;
  result["sigma0"] = 0.28;
  result["chi2_probability"] = 1.0;
  result["tip"] = {{{"name", "a7"},
                    {"old_mm", -25.962},
                    {"value_mm", -25.92146},
                    {"u_mm", 0.0086},
                    {"change_in_u", 4.7},
                    {"swing_deg", 120.0}},
                   {{"name", "d7"},
                    {"old_mm", 0.0},
                    {"value_mm", 0.0016},
                    {"u_mm", 0.0097},
                    {"change_in_u", 0.2},
                    {"swing_deg", 12.0}}};
  result["U_mm"] = 0.0252;
  result["change_mm"] = 0.0406;
  result["change_in_u"] = 4.7;
  result["limit_mm"] = limit_mm;
  result["verdict"] = verdict;
  return document_of("probe", result);
}

TEST(ProbePage, ShowsTheTipBeforeAndAfterRoundedToItsUncertainty) {
  const Page page = page_in("en", document_with_probe(0.03, "pass"));
  EXPECT_EQ(page.stamp.word, "Qualified");
  EXPECT_THAT(words_of(page), HasSubstr("25 readings; largest 0.0123 mm"));
  EXPECT_THAT(words_of(page), HasSubstr("Diameter of the sphere: 15.8754 mm\nTip diameter: 6 mm\n"
                                        "Stated u of a point: 0.02 mm\n"));
  EXPECT_THAT(page.stamp.sentence, HasSubstr("another stylus, or a bent one"));
  EXPECT_THAT(words_of(page),
              HasSubstr("a7 | -25.9620 | -25.9215 | 0.0405 | 0.0086 | 0.0172 | 4.7 | 120 | "));
}

TEST(ProbePage, MarksACoordinateThatTheReadingsShowBadly) {
  const Page page = page_in("en", document_with_probe(0.03, "pass"));
  const auto& table = std::get<Table>(page.sections.at(0).blocks.at(2));
  EXPECT_EQ(table.rows[0].back().tone, Tone::neutral);
  EXPECT_EQ(table.rows[1].back().tone, Tone::warning);
}

TEST(ProbePage, JudgesOnlyAgainstALimit) {
  EXPECT_EQ(page_in("en", document_with_probe(0.01, "fail")).stamp.word, "Not qualified");
  const Page page = page_in("zh", document_with_probe(nullptr, "not_judged"));
  EXPECT_EQ(page.stamp.word, "未判定");
  EXPECT_THAT(page.stamp.sentence, HasSubstr("未给定限值"));
}

TEST(ProbePage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_with_probe(0.03, "pass"));
}

}  // namespace
}  // namespace armcal
