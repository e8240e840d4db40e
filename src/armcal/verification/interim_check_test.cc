// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/interim_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "armcal/core/diagnostics.h"
#include "armcal/testing/random_geometry.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

const CheckValue& value(const InterimCheck& check, std::string_view name) {
  for (const CheckValue& each : check.values) {
    if (each.name == name) return each;
  }
  throw std::logic_error("no " + std::string(name));
}

bool has(const InterimCheck& check, std::string_view name) {
  for (const CheckValue& each : check.values) {
    if (each.name == name) return true;
  }
  return false;
}

// Mean (1, 2, 3), deviations 3, 3, 1, 1 by hand; s = sqrt(20 / 3).
TouchedPlace seat(const std::string& name, const Eigen::Vector3d& shift) {
  TouchedPlace place{name, {}};
  const std::vector<Eigen::Vector3d> offs = {{3, 0, 0}, {-3, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (const Eigen::Vector3d& off : offs) {
    place.points_mm.emplace_back(Eigen::Vector3d(1, 2, 3) + shift + off);
  }
  return place;
}

TouchedPlace sphere(const std::string& name, const Eigen::Vector3d& center, double radius_mm,
                    int count = 12) {
  RandomStream random(7);
  TouchedPlace place{name, {}};
  for (int i = 0; i < count; ++i) {
    place.points_mm.emplace_back(center + radius_mm * testing::random_direction(random));
  }
  return place;
}

TEST(InterimCheck, OfASeatAgreesWithACaseComputedByHand) {
  const std::vector<TouchedPlace> places = {seat("", {0, 0, 0})};
  const InterimCheck check =
      check_arm(places, {.limits = {.deviation_mm = 3.1, .twice_s_mm = 5.0}});
  EXPECT_EQ(check.kind, CheckKind::seat);
  EXPECT_NEAR(value(check, "max_deviation").value_mm, 3.0, 1e-12);
  EXPECT_NEAR(value(check, "two_s").value_mm, 2.0 * std::sqrt(20.0 / 3.0), 1e-12);
  EXPECT_NEAR(value(check, "half_range_x").value_mm, 3.0, 1e-12);
  EXPECT_NEAR(value(check, "half_range_y").value_mm, 1.0, 1e-12);
  EXPECT_NEAR(value(check, "half_range_z").value_mm, 0.0, 1e-12);
  EXPECT_EQ(value(check, "max_deviation").verdict, Verdict::pass);
  EXPECT_EQ(value(check, "two_s").verdict, Verdict::fail);
  EXPECT_EQ(value(check, "half_range_x").verdict, Verdict::not_judged);
  EXPECT_EQ(check.verdict(), Verdict::fail);
  EXPECT_FALSE(has(check, "length"));
}

TEST(InterimCheck, MeasuresTheLengthBetweenTwoSeats) {
  std::vector<TouchedPlace> places = {seat("A", {0, 0, 0}), seat("B", {300, 400, 0})};
  places[1].points_mm[0].x() += 0.4;  // moves the mean by 0.1
  const InterimCheck check = check_arm(places, {.length_mm = 500.0, .limits = {.length_mm = 0.05}});
  const double length = std::hypot(300.1, 400.0);
  EXPECT_NEAR(value(check, "length").value_mm, length, 1e-12);
  EXPECT_NEAR(value(check, "length_error").value_mm, length - 500.0, 1e-12);
  EXPECT_EQ(value(check, "length_error").verdict, Verdict::fail);
  EXPECT_NEAR(value(check, "max_deviation").value_mm, 3.3, 1e-12);  // of the worse seat
}

TEST(InterimCheck, OfSpheresTakesTheWorseOne) {
  const std::vector<TouchedPlace> places = {sphere("A", {0, 0, 0}, 15.51),
                                            sphere("B", {0, 0, 250}, 15.48)};
  const InterimCheck check = check_arm(
      places, {.diameter_mm = 25.0, .tip_diameter_mm = 6.0, .length_mm = 250.02, .limits = {}});
  EXPECT_EQ(check.kind, CheckKind::sphere);
  EXPECT_NEAR(value(check, "diameter_error").value_mm, -0.04, 1e-9);  // the sign is kept
  EXPECT_NEAR(value(check, "form_error").value_mm, 0.0, 1e-9);
  EXPECT_NEAR(value(check, "length_error").value_mm, -0.02, 1e-9);
  EXPECT_EQ(check.verdict(), Verdict::not_judged);
}

TEST(InterimCheck, DependsNeitherOnFrameNorOnOrder) {
  RandomStream random(2);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<TouchedPlace> places(2);
    for (TouchedPlace& place : places) {
      const Eigen::Vector3d center = 300.0 * testing::random_normal_vector(random);
      for (int i = 0; i < 10; ++i) {
        place.points_mm.emplace_back(center + 0.02 * testing::random_normal_vector(random));
      }
    }
    const RigidTransform moved = testing::random_transform(random, 500.0);
    std::vector<TouchedPlace> others = {places[1], places[0]};
    for (TouchedPlace& place : others) {
      for (Eigen::Vector3d& point : place.points_mm) point = moved * point;
    }
    const InterimCheck one = check_arm(places, {.length_mm = 400.0});
    const InterimCheck other = check_arm(others, {.length_mm = 400.0});
    for (const char* name : {"max_deviation", "two_s", "length_error"}) {
      EXPECT_NEAR(value(one, name).value_mm, value(other, name).value_mm, 1e-9) << name;
    }
  }
}

TEST(InterimCheck, NamesEverythingThatIsMissing) {
  const std::vector<TouchedPlace> few = {{"A", {{0, 0, 0}, {0, 0, 1}}}};
  const auto problems = problems_of(few, {.length_mm = 500.0, .limits = {.form_mm = 0.1}});
  EXPECT_THAT(problems,
              ::testing::ElementsAre(HasSubstr("whose certified diameter is missing"),
                                     "2 points in the seat A, at least 3 are needed, better 10",
                                     "a length lies between 2 seats, the readings are of 1"));
  EXPECT_THAT(problems_of(few, {.diameter_mm = -1.0}),
              ::testing::Contains("certified diameter -1 mm: must be larger than 0"));
  EXPECT_THAT(problems_of(few, {.limits = {.length_mm = 0.1}}),
              ::testing::Contains("a limit of the length error needs the certified length"));
  EXPECT_THROW(static_cast<void>(check_arm(few, {})), std::invalid_argument);
}

TEST(InterimCheck, RefusesPointsThatAreNoSphere) {
  TouchedPlace flat{"A", {}};
  for (int i = 0; i < 9; ++i) flat.points_mm.emplace_back(i, i * i, 0.0);
  try {
    static_cast<void>(check_arm(std::vector{flat}, {.diameter_mm = 25.0}));
    FAIL() << "accepted";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sphere A: the points lie in one plane"));
  }
}

}  // namespace
}  // namespace armcal
