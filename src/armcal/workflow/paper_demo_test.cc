// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/paper_demo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::HasSubstr;

TEST(PaperDemo, TellsTheThreeFindingsWithTheirNumbers) {
  const std::string text = run_paper_demo().text;
  EXPECT_THAT(
      text,
      HasSubstr(
          "l_PP3 = 104.070 contradicts a5 = 78.312 and b3 = 747.489; 104.700 agrees with both."));
  EXPECT_THAT(text, HasSubstr("b7 = 178.383 contradicts the readings, which give 176.484"));
  EXPECT_THAT(text, HasSubstr("2 fit equally well, being mirror images of each other"));
  EXPECT_THAT(text, HasSubstr("0.3836 %"));
  EXPECT_THAT(text, HasSubstr("checked by nothing"));
}

TEST(PaperDemo, RecomputesTable2) {
  const Json json = run_paper_demo().json;
  const Json& adjusted = json["as_meant"]["adjusted"];
  EXPECT_NEAR(adjusted["a5"]["value"].get<double>(), 78.312, 0.001);
  EXPECT_NEAR(adjusted["a7"]["value"].get<double>(), -25.962, 0.001);
  EXPECT_NEAR(adjusted["b3"]["value"].get<double>(), 747.489, 0.001);
  EXPECT_NEAR(adjusted["b5"]["value"].get<double>(), 531.880, 0.001);
  EXPECT_NEAR(adjusted["b7"]["value"].get<double>(), 176.484, 0.001);
  EXPECT_NEAR(json["consistent_chain"]["b3"].get<double>(), 747.489, 0.001);
  EXPECT_EQ(json["literal_chain"]["b7"], 178.383);
  ASSERT_EQ(json["findings"].size(), 3u);  // documented, and once missing
  EXPECT_THAT(json["findings"][0].get<std::string>(), HasSubstr("104.700 agrees with both"));
  EXPECT_THAT(json["findings"][1].get<std::string>(), HasSubstr("same length as the reading R"));
  EXPECT_THAT(json["findings"][2].get<std::string>(), HasSubstr("mirror images"));
  EXPECT_EQ(json["as_meant"]["consistent"], false);  // the compared arm, as printed, contradicts
  for (const Json& reading : json["as_meant"]["readings"]) {
    EXPECT_NEAR(reading["predicted"].get<double>(), reading["value"].get<double>(), 0.001 + 1e-9);
  }
}

}  // namespace
}  // namespace armcal
