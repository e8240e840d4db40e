// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/b89_4_22/single_point_articulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "armcal/testing/random_geometry.h"
#include "armcal/verification/half_range.h"

// Two statistics of repeated points in a seat that must never be confused.
namespace armcal::b89_4_22 {
namespace {

using ::testing::ElementsAre;

constexpr double kReach = 1000.0;

// Ten points in a seat: four pairs about the middle along x, 3 um away, and one pair 5 um away
// along y.
SeatPoints seat(const std::string& name, const Eigen::Vector3d& place) {
  SeatPoints points{.name = name};
  for (int pair = 0; pair < 5; ++pair) {
    const Eigen::Vector3d offset =
        pair < 4 ? Eigen::Vector3d(0.003, 0, 0) : Eigen::Vector3d(0, 0.005, 0);
    points.points_mm.push_back(place + offset);
    points.points_mm.push_back(place - offset);
  }
  return points;
}

std::vector<SeatPoints> three_seats() {
  return {seat("a", {150, 0, 0}), seat("b", {0, 500, 0}), seat("c", {0, 0, 900})};
}

TEST(SinglePointArticulation, FollowsByHand) {
  // sum = 8 * 9 + 2 * 25 = 122 um^2; 2 s = 2 sqrt(122 / 9) um.
  const double twice_s = 2e-3 * std::sqrt(122.0 / 9.0);
  const auto results = single_point_articulation(three_seats(), {{0, 0, 0}, kReach});
  ASSERT_EQ(results.size(), 6u);
  EXPECT_EQ(results[0].name, "single-point articulation, near zone, seat a: largest deviation");
  EXPECT_EQ(results[3].name, "single-point articulation, middle zone, seat b: 2 s");
  EXPECT_EQ(results[4].name, "single-point articulation, far zone, seat c: largest deviation");
  for (std::size_t i = 0; i < results.size(); i += 2) {
    EXPECT_NEAR(results[i].value_mm.value(), 0.005, 1e-12);
    EXPECT_NEAR(results[i].parts.at(0).value_mm, 0.003, 1e-12);
    EXPECT_NEAR(results[i + 1].value_mm.value(), twice_s, 1e-12);
    EXPECT_TRUE(results[i].complete());
    EXPECT_TRUE(results[i].symbol.empty());
    EXPECT_FALSE(results[i].is_signed);
    EXPECT_EQ(results[i].standard, "ASME B89.4.22-2004");
  }
}

TEST(SinglePointArticulation, ZonesAreSharesOfTheReachFromTheFirstAxis) {
  EXPECT_EQ(zone_of(199.9, kReach), ReachZone::near);
  EXPECT_EQ(zone_of(200.0, kReach), ReachZone::middle);
  EXPECT_EQ(zone_of(800.0, kReach), ReachZone::middle);
  EXPECT_EQ(zone_of(800.1, kReach), ReachZone::far);
  // The arm stands 5 m from the origin.
  std::vector<SeatPoints> seats = {seat("a", {5000, 0, 850})};
  const auto results = single_point_articulation(seats, {{5000, 0, 0}, kReach});
  EXPECT_NE(results.at(0).name.find("far zone"), std::string::npos);
}

TEST(SinglePointArticulation, SaysWhatIsMissing) {
  auto seats = three_seats();
  seats.erase(seats.begin());
  seats[1].points_mm.resize(1);
  const auto results = single_point_articulation(seats, {{0, 0, 0}, kReach});
  ASSERT_EQ(results.size(), 4u);
  for (const TestResult& result : results) {
    EXPECT_THAT(result.missing, ElementsAre("1 articulation in seat c, 10 are asked for",
                                            "no seat in the near zone"));
    EXPECT_FALSE(result.complete());
  }
  EXPECT_FALSE(results[3].value_mm.has_value());  // no 2 s of one point
  const auto none = single_point_articulation({}, {{0, 0, 0}, kReach});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].missing.size(), 3u);
}

TEST(SinglePointArticulation, TellsPointsThatCannotBe) {
  auto seats = three_seats();
  seats[0].points_mm[0].x() = NAN;
  for (auto& point : seats[1].points_mm) point *= 25.4;
  const auto results = single_point_articulation(seats, {{0, 0, 0}, kReach});
  EXPECT_THAT(results.at(0).problems,
              ElementsAre("seat a: a coordinate is not a finite number",
                          "seat b: 12700.0 mm from the first axis, the arm reaches 1000.0 mm; are "
                          "units mixed?"));
  EXPECT_THROW(static_cast<void>(single_point_articulation(seats, {{0, 0, 0}, 0.0})),
               std::invalid_argument);
}

TEST(SinglePointArticulation, LosesNothingFarFromTheOrigin) {
  const auto here = scatter_in_seat(seat("", {0, 0, 0}).points_mm);
  const auto away = scatter_in_seat(seat("", {4096, 4096, 4096}).points_mm);
  EXPECT_NEAR(away.twice_s_mm, here.twice_s_mm, 4e-12);  // rounding of coordinates of 4 m
}

TEST(HalfRange, IsPerAxisAndFollowsByHand) {
  const TestResult result = half_range(seat("", {100, 200, 300}).points_mm, "seat a");
  EXPECT_EQ(result.name, "half range per axis, seat a");
  EXPECT_EQ(result.name.find("articulation"), std::string::npos);
  EXPECT_EQ(result.standard, "");
  ASSERT_EQ(result.parts.size(), 3u);
  EXPECT_EQ(result.parts[0].name, "x");
  EXPECT_NEAR(result.parts[0].value_mm, 0.003, 1e-12);
  EXPECT_NEAR(result.parts[1].value_mm, 0.005, 1e-12);
  EXPECT_NEAR(result.parts[2].value_mm, 0.0, 1e-12);
  EXPECT_NEAR(result.value_mm.value(), 0.005, 1e-12);
}

TEST(HalfRange, IsNotTheStatisticOfTheStandard) {
  // Normal scatter of 10 um per axis: 2 s is near 2 sqrt(3) 10 um, the half range of ten points
  // near 15 um. Means over many seats, good to about 1 um.
  RandomStream random(21);
  double half = 0.0;
  double twice_s = 0.0;
  constexpr int kSeats = 400;
  for (int i = 0; i < kSeats; ++i) {
    const auto points =
        testing::with_noise(std::vector<Eigen::Vector3d>(10, {1, 2, 3}), 0.010, random);
    half += half_range(points, "").parts[0].value_mm / kSeats;
    twice_s += scatter_in_seat(points).twice_s_mm / kSeats;
  }
  EXPECT_NEAR(half, 0.0154, 0.0005);
  EXPECT_NEAR(twice_s, 2.0 * std::sqrt(3.0) * 0.010, 0.001);
}

TEST(HalfRange, NeedsTwoFinitePoints) {
  const std::vector<Eigen::Vector3d> one = {{1, 2, 3}};
  EXPECT_THAT(half_range(one, "seat a").missing,
              ElementsAre("a range needs at least 2 points in seat a"));
  EXPECT_FALSE(half_range({}, "seat a").value_mm.has_value());
  const std::vector<Eigen::Vector3d> hole = {{1, 2, 3}, {1, NAN, 3}};
  EXPECT_THAT(half_range(hole, "seat a").problems,
              ElementsAre("seat a: a coordinate is not a finite number"));
}

}  // namespace
}  // namespace armcal::b89_4_22
