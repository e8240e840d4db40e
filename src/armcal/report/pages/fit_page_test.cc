// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/fit_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/geometry/circle.h"
#include "armcal/geometry/line.h"
#include "armcal/geometry/plane.h"
#include "armcal/geometry/registration.h"
#include "armcal/geometry/sphere.h"
#include "armcal/report/fit_report.h"
#include "armcal/report/number_format.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/points_on_sphere.h"
#include "armcal/testing/random_geometry.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::words_of;

std::vector<Eigen::Vector3d> noisy_sphere() {
  RandomStream random(4);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 25; ++i) {
    points.emplace_back(Eigen::Vector3d(100, 50, 200) + 12.7 * testing::random_direction(random));
  }
  return testing::with_noise(points, 0.002, random);
}

Json document_of_sphere() { return document_of("fit", json_result(fit_sphere(noisy_sphere()))); }

Json document_of_pairs() {
  RandomStream random(5);
  const std::vector<Eigen::Vector3d> first = noisy_sphere();
  const RigidTransform second_from_first = testing::random_transform(random, 300.0);
  std::vector<Eigen::Vector3d> second;
  for (const Eigen::Vector3d& p : first) second.emplace_back(second_from_first * p);
  return document_of(
      "register", json_result(register_points(first, testing::with_noise(second, 0.01, random))));
}

TEST(FitPage, HasValuesRoundedToTheirUncertainty) {
  const SphereFit fit = fit_sphere(noisy_sphere());
  const double u = std::sqrt((*fit.covariance)(3, 3));
  const int decimals = decimals_for_uncertainty(u);
  const Page page = page_in("en", document_of_sphere());
  EXPECT_EQ(page.title, "Best-fit sphere");
  EXPECT_THAT(words_of(page),
              HasSubstr("Radius | " + fixed(fit.radius_mm, decimals) + " | " + fixed(u, decimals)));
  EXPECT_THAT(words_of(page), HasSubstr("21 degrees of freedom"));
  const auto& headlines = std::get<Headlines>(page.sections.at(0).blocks.at(0)).items;
  EXPECT_EQ(headlines.at(0).value, fixed(fit.radius_mm, decimals));
}

TEST(FitPage, TellsElementsApart) {
  const std::vector<Eigen::Vector3d> points = noisy_sphere();
  EXPECT_EQ(page_in("en", document_of("fit", json_result(fit_circle(points)))).title,
            "Best-fit circle");
  EXPECT_EQ(page_in("en", document_of("fit", json_result(fit_plane(points)))).title,
            "Best-fit plane");
  EXPECT_EQ(page_in("en", document_of("fit", json_result(fit_line(points)))).title,
            "Best-fit line");
}

// Residuals of circles and lines are distances in space: their largest minus smallest is no form.
TEST(FitPage, DrawsNoLinesAtTheEndsOfDistancesWithoutASign) {
  const auto figure_of = [](const Json& document) {
    const Page page = page_in("en", document);
    return std::get<Figures>(testing::section_of(page, "points").blocks.at(0)).items.at(0);
  };
  const Figure line = figure_of(document_of("fit", json_result(fit_line(noisy_sphere()))));
  EXPECT_THAT(line.svg, Not(HasSubstr("smallest")));
  EXPECT_THAT(line.text, HasSubstr("Distance in space"));
  const Figure sphere = figure_of(document_of_sphere());
  EXPECT_THAT(sphere.svg, HasSubstr("smallest"));
  EXPECT_THAT(sphere.text, HasSubstr("the form error is"));
}

TEST(FitPage, OfARegistrationHasRotationTranslationAndPairs) {
  const Json document = document_of_pairs();
  const std::string words = words_of(page_in("en", document));
  EXPECT_THAT(words, HasSubstr("Translation x | "));
  EXPECT_THAT(words, HasSubstr("second = rotation \u00b7 first + translation"));
  const double yaw_deg = document["roll_pitch_yaw_deg"][2].get<double>();
  EXPECT_THAT(words, HasSubstr("Yaw (about z) | " + fixed(yaw_deg, 6)));
  Json scaled = document;
  scaled["scale"] = 1.0001;
  EXPECT_THAT(words_of(page_in("en", scaled)), HasSubstr("second = scale \u00b7 rotation"));
  EXPECT_THAT(words, HasSubstr(fixed(document["rotation"][0][0].get<double>(), 9) + " | " +
                               fixed(document["rotation"][0][1].get<double>(), 9)));
  EXPECT_THAT(words, HasSubstr(fixed(document["max_mm"].get<double>(), 4) + " mm"));
}

TEST(FitPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_of_sphere());
  testing::expect_page_laws(document_of_pairs());
}

}  // namespace
}  // namespace armcal
