// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/fit_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::HasSubstr;
using Points = std::vector<Eigen::Vector3d>;

const Points kOnSphere = {{10, 0, 0},  {-10, 0, 0},  {0, 10, 0},
                          {0, -10, 0}, {0, 0, 10.3}, {0, 0, -10.3}};

TEST(FitReport, HasTheKeysThatProgramsRelyOn) {
  const Json sphere = json_result(fit_sphere(kOnSphere));
  for (const char* key : {"center_mm", "radius_mm", "rms_mm", "form_mm", "count", "covariance",
                          "covariance_of", "status"}) {
    EXPECT_TRUE(sphere.contains(key)) << key;
  }
  EXPECT_EQ(sphere["center_mm"].size(), 3u);
  EXPECT_EQ(sphere["covariance"].size(), 4u);
  EXPECT_EQ(sphere["status"], "converged");

  const Points flat = {{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.2}, {3, 2, 0}};
  EXPECT_TRUE(json_result(fit_plane(flat)).contains("normal"));
  EXPECT_TRUE(json_result(fit_line(flat)).contains("direction"));
  EXPECT_TRUE(json_result(fit_circle(flat)).contains("normal"));
  const Json registration = json_result(register_points(flat, flat));
  for (const char* key : {"rotation", "translation_mm", "scale", "rms_mm"}) {
    EXPECT_TRUE(registration.contains(key)) << key;
  }
}

TEST(FitReport, CovarianceIsNullWithoutDegreesOfFreedom) {
  const Json plane = json_result(fit_plane(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(plane["covariance"].is_null());
}

TEST(FitReport, TextNamesTheElementAndItsQuality) {
  const std::string text = text_result(fit_sphere(kOnSphere));
  EXPECT_THAT(text, HasSubstr("Least-squares sphere through 6 points"));
  EXPECT_THAT(text, HasSubstr("radius               10.100000 mm   u 0."));
  EXPECT_THAT(text, HasSubstr("form                  0.300000 mm"));
}

}  // namespace
}  // namespace armcal
