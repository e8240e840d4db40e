// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/sphere_test_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::HasSubstr;

SphereTest sphere_in_text(const SphereTestOptions& options) {
  PointReadings readings;
  for (const double sign : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      readings.points_mm.push_back(sign * 15.8145 / 2 * Eigen::Vector3d::Unit(axis));
    }
  }
  return test_sphere(readings, options);
}

TEST(SphereTestReport, JsonHasTestsAndVerdict) {
  const SphereTestOptions options{15.8754, 0.0, 0.05, {}};
  const Json json = json_result(sphere_in_text(options), options);
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["tests"][0]["name"], "diameter error");
  EXPECT_NEAR(json["tests"][0]["value_mm"].get<double>(), -0.0609, 1e-9);
  EXPECT_EQ(json["tests"][0]["mpe_mm"], 0.05);
  EXPECT_EQ(json["tests"][1]["verdict"], "not_judged");
  EXPECT_TRUE(json["tests"][0]["symbol"].is_null());
}

TEST(SphereTestReport, TextShowsThePapersFigure) {
  const SphereTestOptions options{15.8754, 0.0, {}, {}};
  EXPECT_THAT(text_result(sphere_in_text(options), options),
              HasSubstr("relative error of the diameter -0.3836 %"));
}

TEST(SphereTestReport, WarnsInWords) {
  SphereTest test;
  EXPECT_EQ(blind_spot_warning(test), "");
  test.blind_spots = {{"b3", true, 0.01}, {"b5", true, 0.02}};
  EXPECT_THAT(blind_spot_warning(test),
              HasSubstr("an error of 1 mm in b3, b5 would show by less than 0.1 mm"));
}

}  // namespace
}  // namespace armcal
