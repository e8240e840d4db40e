// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/tips_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::words_of;

Json tips(const std::string& command) {
  Json result;
  result["count"] = 2;
  result["tips_mm"] = {{47.87985665, 1.5566, 950.7578}, {-300.0, 400.0, 0.0}};
  if (command == "predict") result["u_mm"] = {{0.0106, 0.0141, 0.0071}, {0.012, 0.0, 0.009}};
  return document_of(command, result);
}

TEST(TipsPage, RoundsCoordinatesToTheirUncertainties) {
  const std::string words = words_of(page_in("en", tips("predict")));
  EXPECT_THAT(words, HasSubstr("1 | 47.880 | 1.557 | 950.7578 | 0.011 | 0.014 | 0.0071"));
  EXPECT_THAT(words, HasSubstr("0.0190 mm"));  // of the first tip: the root of its squares
}

TEST(TipsPage, ShowsEveryDigitThatMattersWhereNothingIsUncertain) {
  const std::string words = words_of(page_in("en", tips("fk")));
  EXPECT_THAT(words, HasSubstr("1 | 47.879857 | 1.556600 | 950.757800"));
  EXPECT_THAT(words, Not(HasSubstr("u(x)")));
  EXPECT_THAT(words, HasSubstr("952.0 mm"));  // the farther of the two
}

TEST(TipsPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(tips("fk"));
  testing::expect_page_laws(tips("predict"));
}

}  // namespace
}  // namespace armcal
