// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/diff_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::words_of;

Json change(const std::string& name, const std::string& unit, double before, double after, double u,
            bool held_in_one = false) {
  return {{"name", name},
          {"unit", unit},
          {"before", before},
          {"after", after},
          {"change", after - before},
          {"u", u},
          {"ratio", u > 0.0 ? Json((after - before) / u) : Json()},
          {"held_in_one", held_in_one},
          {"changed", !held_in_one && std::abs(after - before) > 3.0 * u}};
}

Json document_with_changes(const Json& changes) {
  Json result;
  result["changes"] = changes;
  return document_of("diff", result);
}

TEST(DiffPage, RoundsChangesToTheirUncertaintyAndShowsAnglesInDegrees) {
  const double rad = 3.14159265358979 / 180.0;
  const Page page = page_in(
      "en", document_with_changes({change("a5", "mm", 78.3121, 78.3149, 0.0021),
                                   change("zero2", "rad", 0.1 * rad, 0.102 * rad, 0.001 * rad)}));
  EXPECT_THAT(words_of(page), HasSubstr("a5 | 78.3121 | 78.3149 | 0.0028 | 0.0021 | mm | 1.3"));
  EXPECT_THAT(words_of(page), HasSubstr("zero2 | 0.1000 | 0.1020 | 0.0020 | 0.0010 | deg | 2.0"));
  EXPECT_EQ(page.stamp.tone, Tone::good);
}

TEST(DiffPage, CountsWhatChangedByMoreThanThreeTimesItsUncertainty) {
  const Page page =
      page_in("en", document_with_changes({change("a5", "mm", 78.0, 78.1, 0.01),
                                           change("b3", "mm", 5.0, 5.0, 0.01),
                                           change("d3", "mm", 0.0, 0.4, 0.01, true)}));
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(page.stamp.sentence, HasSubstr(": 1."));
  EXPECT_THAT(words_of(page), HasSubstr("held in one of them"));
}

// Where neither calibration estimated a parameter its ratio is infinite, null in the document: the
// page said "no notable change".
TEST(DiffPage, SaysThatSomethingChangedThatNeitherEstimated) {
  const Page page =
      page_in("en", document_with_changes(Json::array({change("b3", "mm", 450.0, 380.0, 0.0)})));
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(words_of(page), HasSubstr("b3 | 450.000000 | 380.000000 | -70.000000"));
  EXPECT_THAT(words_of(page), HasSubstr("changed"));
}

TEST(DiffPage, LeavesOutWhatNeitherEstimatedNorMoved) {
  const Page page = page_in("en", document_with_changes({change("beta2", "rad", 0.0, 0.0, 0.0),
                                                         change("a5", "mm", 78.0, 78.0, 0.01)}));
  EXPECT_THAT(words_of(page), Not(HasSubstr("beta2")));
}

TEST(DiffPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_with_changes(
      {change("a5", "mm", 78.0, 78.1, 0.01), change("zero2", "rad", 0.0, 0.0, 0.0)}));
}

}  // namespace
}  // namespace armcal
