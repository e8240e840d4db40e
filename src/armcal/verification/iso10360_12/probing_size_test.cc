// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/probing_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/points_on_sphere.h"
#include "armcal/verification/iso10360_12/articulated_location.h"
#include "armcal/verification/iso10360_12/probing_form.h"

// The three tests on a sphere: size, form and articulated location.
namespace armcal::iso10360_12 {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr ReferenceSphere kSphere{25.0, 6.0};
const Eigen::Vector3d kNear(400.0, 100.0, 200.0);
const Eigen::Vector3d kFar(-900.0, 200.0, 50.0);

// A round sphere, too large by `error_mm`.
SpherePoints set(const std::string& name, const Eigen::Vector3d& center, double error_mm,
                 int count) {
  return {name, armcal::testing::points_on_sphere(center, 31.0 + error_mm, count, -0.3), ""};
}

std::vector<SpherePoints> two_positions() {
  return {set("A", kNear, 0.010, 25), set("B", kFar, -0.020, 25)};
}

TEST(ProbingSize, IsThatOfTheWorsePositionWithItsSign) {
  const TestResult result = probing_size(two_positions(), kSphere);
  EXPECT_EQ(result.symbol, "P_Size.Sph.1x25::Tact.AArm");
  EXPECT_EQ(result.standard, "ISO 10360-12:2016");
  EXPECT_TRUE(result.complete());
  EXPECT_NEAR(result.value_mm.value(), -0.020, 1e-11);
  ASSERT_EQ(result.parts.size(), 2u);
  EXPECT_EQ(result.parts[0].name, "position A");
  EXPECT_NEAR(result.parts[0].value_mm, 0.010, 1e-11);
  EXPECT_EQ(result.parts[0].readings, 25);
  EXPECT_TRUE(result.is_signed);
}

TEST(ProbingForm, IsTheThicknessOfTheThickerShell) {
  auto positions = two_positions();
  // The six ends of the axes, two of them 5 um outside and two 3 um inside: by symmetry the centre
  // stays.
  positions[1].points_mm.clear();
  const double radius = 15.5;
  for (const double sign : {1.0, -1.0}) {
    positions[1].points_mm.push_back(kFar + sign * (radius + 0.005) * Eigen::Vector3d::UnitX());
    positions[1].points_mm.push_back(kFar + sign * (radius - 0.003) * Eigen::Vector3d::UnitY());
    positions[1].points_mm.push_back(kFar + sign * radius * Eigen::Vector3d::UnitZ());
  }
  const TestResult result = probing_form(positions, kSphere);
  EXPECT_NEAR(result.value_mm.value(), 0.008, 1e-11);
  EXPECT_NEAR(result.parts.at(0).value_mm, 0.0, 1e-11);
  EXPECT_FALSE(result.is_signed);
  EXPECT_EQ(result.symbol, "");
  EXPECT_THAT(result.missing, ElementsAre("6 points at position B, 25 are asked for"));
  EXPECT_EQ(probing_form(two_positions(), kSphere).symbol, "P_Form.Sph.1x25::Tact.AArm");
}

TEST(ProbingForm, NeedsMorePointsThanEverySphereFits) {
  const std::vector<SpherePoints> four = {set("A", kNear, 0.0, 4)};
  EXPECT_FALSE(probing_form(four, kSphere).value_mm.has_value());
  EXPECT_TRUE(probing_size(four, kSphere).value_mm.has_value());
}

TEST(ArticulatedLocation, IsTheDiameterOfTheCloudOfCentres) {
  // Centres at the corners of a right triangle with legs 3 and 4 um, and two inside: 5 um.
  std::vector<SpherePoints> sets;
  const std::vector<Eigen::Vector3d> offsets = {
      {0, 0, 0}, {0.003, 0, 0}, {0, 0.004, 0}, {0.001, 0.001, 0}, {0.0015, 0.002, 0.001}};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    sets.push_back(set(std::to_string(i + 1), kNear + offsets[i], 0.1 * static_cast<double>(i), 5));
  }
  const TestResult result = articulated_location(sets, kSphere);
  EXPECT_EQ(result.symbol, "L_Dia.5x5:Art:Tact.AArm");
  EXPECT_NEAR(result.value_mm.value(), 0.005, 1e-10);
  EXPECT_NEAR(result.parts.at(1).value_mm, 0.0025, 1e-10);
  EXPECT_EQ(result.parts.at(1).name, "articulation 2");
  EXPECT_NEAR(result.parts.at(4).value_mm, 0.001, 1e-10);
}

TEST(TestsOnASphere, SayWhatIsMissing) {
  std::vector<SpherePoints> one = {set("B", kFar, 0.0, 24)};
  for (const TestResult& result : {probing_size(one, kSphere), probing_form(one, kSphere)}) {
    EXPECT_THAT(result.missing, ElementsAre("1 sphere position, 2 are asked for",
                                            "24 points at position B, 25 are asked for"));
    EXPECT_EQ(result.symbol, "");
    EXPECT_TRUE(result.value_mm.has_value());
    EXPECT_FALSE(result.complete());
  }
  const std::vector<SpherePoints> four(4, set("1", kNear, 0.0, 5));
  EXPECT_THAT(articulated_location(four, kSphere).missing,
              ElementsAre("4 articulations, 5 are asked for"));
  EXPECT_THAT(probing_size({}, kSphere).missing,
              ElementsAre("0 sphere positions, 2 are asked for"));
  EXPECT_FALSE(probing_size({}, kSphere).value_mm.has_value());
  EXPECT_FALSE(articulated_location({}, kSphere).value_mm.has_value());
}

TEST(TestsOnASphere, TellPointsThatCannotBeOnIt) {
  auto positions = two_positions();
  positions[1] = set("B", kFar, 5.0, 25);
  const TestResult another = probing_size(positions, kSphere);
  EXPECT_THAT(another.missing, IsEmpty());
  ASSERT_EQ(another.problems.size(), 1u);
  EXPECT_NE(another.problems[0].find("position B"), std::string::npos);
  EXPECT_EQ(another.symbol, "");
  for (auto& point : positions[1].points_mm) point.z() = 0.0;
  const TestResult flat = probing_form(positions, kSphere);
  EXPECT_THAT(flat.problems, ElementsAre("position B: the points lie in one plane"));
  EXPECT_EQ(flat.parts.size(), 1u);
  EXPECT_EQ(flat.symbol, "");
}

}  // namespace
}  // namespace armcal::iso10360_12
