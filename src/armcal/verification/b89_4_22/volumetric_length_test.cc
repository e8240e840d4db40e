// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/b89_4_22/volumetric_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/testing/points_on_sphere.h"
#include "armcal/verification/b89_4_22/effective_diameter.h"

namespace armcal::b89_4_22 {
namespace {

using ::testing::ElementsAre;

std::vector<MeasuredLength> lengths(int count) {
  std::vector<MeasuredLength> found;
  for (int i = 0; i < count; ++i) {
    const double error = i == 3 ? -0.080 : (i % 2 == 0 ? 0.020 : -0.010);
    found.push_back({std::to_string(i + 1), 700.0, 700.0 + error, 0, ""});
  }
  return found;
}

TEST(VolumetricLength, FollowsByHand) {
  const auto results = volumetric_length(lengths(20));
  ASSERT_EQ(results.size(), 2u);
  EXPECT_TRUE(results[0].complete());
  EXPECT_NEAR(results[0].value_mm.value(), -0.080, 1e-12);
  EXPECT_EQ(results[0].parts.size(), 20u);
  // 10 of 20 um, 9 of 10 um, one of 80 um.
  const double squares = 10 * 400.0 + 9 * 100.0 + 6400.0;
  EXPECT_NEAR(results[1].value_mm.value(), 2e-3 * std::sqrt(squares / 20.0), 1e-12);
  EXPECT_TRUE(results[1].complete());
  EXPECT_EQ(results[1].name, "volumetric length, 2 RMS");
}

TEST(VolumetricLength, AsksForExactlyTwenty) {
  EXPECT_THAT(volumetric_length(lengths(19))[0].missing,
              ElementsAre("19 lengths, 20 are asked for"));
  EXPECT_THAT(volumetric_length(lengths(21))[1].missing,
              ElementsAre("21 lengths, 20 are asked for"));
  EXPECT_FALSE(volumetric_length({})[0].value_mm.has_value());
  EXPECT_FALSE(volumetric_length({})[1].value_mm.has_value());
  auto wrong = lengths(20);
  wrong[0].measured_mm = 0.7;
  EXPECT_THAT(volumetric_length(wrong)[1].problems,
              ElementsAre("700 mm at 1: 0.7000 mm was measured: 1000 times too small, as if in "
                          "metres"));
}

std::vector<SpherePoints> fits(std::initializer_list<double> errors_mm, int points) {
  std::vector<SpherePoints> found;
  for (const double error : errors_mm) {
    found.push_back({std::to_string(found.size() + 1),
                     testing::points_on_sphere({100, 200, 300}, 31.0 + error, points), ""});
  }
  return found;
}

TEST(EffectiveDiameter, FollowsByHand) {
  const auto results = effective_diameter(fits({0.010, 0.020, 0.060}, 9), {25.0, 6.0});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_NEAR(results[0].value_mm.value(), 0.030, 1e-11);
  // deviations -20, -10, 30 um: sqrt(1400 / 2).
  EXPECT_NEAR(results[1].value_mm.value(), 1e-3 * std::sqrt(700.0), 1e-11);
  EXPECT_TRUE(results[0].complete());
  EXPECT_TRUE(results[0].is_signed);
  EXPECT_FALSE(results[1].is_signed);
  EXPECT_NEAR(results[0].parts.at(2).value_mm, 0.060, 1e-11);
}

TEST(EffectiveDiameter, SaysWhatIsMissing) {
  const auto results = effective_diameter(fits({0.010}, 8), {25.0, 6.0});
  EXPECT_THAT(results[0].missing,
              ElementsAre("1 fit, 3 are asked for", "8 points in fit 1, 9 are asked for"));
  EXPECT_TRUE(results[0].value_mm.has_value());
  EXPECT_FALSE(results[1].value_mm.has_value());  // no scatter of one
  EXPECT_TRUE(effective_diameter(fits({0, 0, 0, 0, 0}, 9), {25.0, 6.0})[0].complete());
  EXPECT_NE(effective_diameter(fits({4.0, 0, 0}, 9), {25.0, 6.0})[0].problems.size(), 0u);
}

}  // namespace
}  // namespace armcal::b89_4_22
