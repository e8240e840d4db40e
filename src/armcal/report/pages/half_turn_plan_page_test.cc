// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/half_turn_plan_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/io/arm_file.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using testing::page_in;
using testing::section_of;
using testing::words_of;

/// Two half turns of the paper's arm; figures as `armcal plan symmetric-point` gives them.
Json document() {
  Json result;
  result["arm"] = arm_text(testing::nominal_romer());
  result["rank"] = 21;
  result["condition_number"] = 8.44;
  result["length_error_mm"] = 0.00448;
  result["least_redundancy"] = 0.152;
  result["candidates"] = 1365;
  result["wishes"] = {
      {"u_mm", 0.0042}, {"u_encoder_arcsec", 2.0}, {"repeats", 5}, {"grid_deg", 45.0}};
  result["parameters"] = {{{"name", "b3"}, {"unit", "mm"}, {"u", 0.00312}},
                          {{"name", "alpha3"}, {"unit", "rad"}, {"u", 2.1e-6}}};
  result["readings"] = Json::array();
  for (const int joint : {1, 2}) {
    Json a = Json::array({90.0, 0.0, -90.0, 0.0, 90.0, 0.0});
    Json b = a;
    b[static_cast<std::size_t>(joint - 1)] =
        a[static_cast<std::size_t>(joint - 1)].get<double>() - 180.0;
    result["readings"].push_back({{"name", "h0" + std::to_string(joint)},
                                  {"joint", joint},
                                  {"posture_deg", a},
                                  {"posture_end_deg", b},
                                  {"distance_mm", 1742.3961},
                                  {"u_mm", 0.006},
                                  {"redundancy", 0.351}});
  }
  return document_of("plan symmetric-point", result);
}

TEST(HalfTurnPlanPage, TellsWhatIsPromisedAndWhatHasToBeRead) {
  const Page page = page_in("en", document());
  EXPECT_EQ(page.subtitle, testing::nominal_romer().name);
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("4.48"));  // um: the predicted error of a length
  EXPECT_THAT(words,
              HasSubstr("h01 | q1 | -90 | 90 | 0 | -90 | 0 | 90 | 0 | 1742.396 | 0.0060 | 0.351"));
  EXPECT_THAT(words, HasSubstr("u of a distance: 0.0042 mm\nu of an encoder: 2\u2033\n"
                               "Readings at each end: 5\nAngles are multiples of: 45\u00b0\n"));
  EXPECT_THAT(words, HasSubstr("b3 | 0.0031 | mm"));
  EXPECT_THAT(words, HasSubstr("alpha3 | 0.00012 | deg"));
}

TEST(HalfTurnPlanPage, DrawsEveryHalfTurn) {
  const Section postures = section_of(page_in("en", document()), "postures");
  const auto& figures = std::get<Figures>(postures.blocks.at(0));
  ASSERT_EQ(figures.items.size(), 2U);
  for (const Figure& figure : figures.items) EXPECT_THAT(figure.svg, HasSubstr("1742.396 mm"));
}

TEST(HalfTurnPlanPage, KeepsTheLawsOfPages) { testing::expect_page_laws(document()); }

}  // namespace
}  // namespace armcal
