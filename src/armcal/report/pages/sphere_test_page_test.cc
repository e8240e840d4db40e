// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/sphere_test_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/sphere_test_report.h"
#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using testing::page_in;
using testing::section_of;
using testing::words_of;

constexpr const char* kSphereCommand = "verify sphere";

/// Ends of the axes of a sphere of 20 mm, the one along z 0.04 mm too far out.
SphereTest sphere_example(const SphereTestOptions& options) {
  PointReadings readings;
  for (const double sign : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      const double radius_mm = axis == 2 && sign > 0.0 ? 10.04 : 10.0;
      readings.points_mm.push_back(sign * radius_mm * Eigen::Vector3d::Unit(axis));
    }
  }
  return test_sphere(readings, options);
}

Json document_for(const SphereTestOptions& options) {
  return document_of(kSphereCommand, json_result(sphere_example(options), options));
}

TEST(SphereTestPage, ShowsDiameterAndFormWithTheirLimits) {
  const SphereTestOptions options{20.0, 0.0, 0.05, 0.01};
  const Json document = document_for(options);
  const Page page = page_in("en", document);
  EXPECT_EQ(page.stamp.word, "Fail");
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("Diameter error | 0.0134 | 0.0500 | pass | "));
  EXPECT_NEAR(document["diameter_error_mm"].get<double>(), 0.0134, 5e-5);
  EXPECT_THAT(words, HasSubstr("Form error | 0.0200 | 0.0100 | fail | "));
  EXPECT_NEAR(document["form_error_mm"].get<double>(), 0.0200, 5e-5);
}

TEST(SphereTestPage, DrawsDeviationsInOrderAndByDirection) {
  const Page page = page_in("en", document_for({20.0, 0.0, {}, {}}));
  const auto figures = std::get<Figures>(section_of(page, "points").blocks.at(0)).items;
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_THAT(figures[1].svg, HasSubstr("upper half (z &gt; 0)"));
  EXPECT_EQ(page.stamp.word, "Not judged");
}

TEST(SphereTestPage, HasNoMapOfResultsWithoutDirections) {
  Json document = document_for({20.0, 0.0, {}, {}});
  document.erase("directions");
  const Page page = page_in("en", document);
  EXPECT_EQ(std::get<Figures>(section_of(page, "points").blocks.at(0)).items.size(), 1u);
}

TEST(SphereTestPage, RefusesDirectionsThatAreNotThoseOfThePoints) {
  Json document = document_for({20.0, 0.0, {}, {}});
  document["directions"].erase(0);
  try {
    (void)page_in("en", document);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("key directions: has another length"));
  }
}

// A test that could not have failed is no plain pass.
TEST(SphereTestPage, SaysWhatTheTestCouldNotHaveShown) {
  const SphereTestOptions options{20.0, 0.0, 0.05, {}};
  SphereTest test = sphere_example(options);
  test.joint_spans_rad = Eigen::VectorXd::Constant(6, 0.01);
  test.blind_spots = {{"b3", true, 0.0123}};
  const Json document = document_of(kSphereCommand, json_result(test, options));
  const Page page = page_in("zh", document);
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(words_of(page), HasSubstr("b3 | 0.012 | "));
  EXPECT_THAT(words_of(page), HasSubstr("q6 | 0.6 | "));
}

TEST(SphereTestPage, KeepsTheLawsOfPages) {
  const SphereTestOptions options{20.0, 3.0, 0.05, {}};
  SphereTest test = sphere_example(options);
  test.joint_spans_rad = Eigen::VectorXd::Constant(2, 0.01);
  test.blind_spots = {{"b3", true, 0.0123}};
  testing::expect_page_laws(document_of(kSphereCommand, json_result(test, options)));
}

}  // namespace
}  // namespace armcal
