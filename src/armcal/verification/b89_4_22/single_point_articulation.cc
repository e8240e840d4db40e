// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/b89_4_22/single_point_articulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "armcal/verification/as_asked.h"
#include "armcal/verification/b89_4_22/standard.h"

namespace armcal::b89_4_22 {
namespace {

constexpr std::size_t kArticulations = 10;
constexpr double kNearBelow = 0.2;
constexpr double kFarAbove = 0.8;
// Reach is stated loosely; half as far again is another frame or another unit.
constexpr double kTooFarToReach = 1.5;
constexpr std::array kZones = {ReachZone::near, ReachZone::middle, ReachZone::far};

struct ZonedSeat {
  const SeatPoints* seat;
  SeatScatter scatter;
  ReachZone zone;
};

std::vector<std::string> missing_zones(const std::vector<ZonedSeat>& seats) {
  std::vector<std::string> missing;
  for (const ReachZone zone : kZones) {
    const bool has_seat = std::any_of(seats.begin(), seats.end(),
                                      [&](const ZonedSeat& each) { return each.zone == zone; });
    if (!has_seat) missing.push_back(fmt::format("no seat in the {} zone", to_string(zone)));
  }
  return missing;
}

std::vector<TestResult> results_of(const ZonedSeat& each, const TestResult& common) {
  const std::string place = fmt::format("single-point articulation, {} zone, seat {}",
                                        to_string(each.zone), each.seat->name);
  TestResult largest = common;
  largest.name = place + ": largest deviation";
  largest.definition =
      "largest distance in space of a point from the mean of the points of the seat";
  largest.value_mm = each.scatter.largest_mm;
  for (std::size_t i = 0; i < each.scatter.deviations_mm.size(); ++i) {
    largest.parts.push_back({.name = fmt::format("point {}", i + 1),
                             .value_mm = each.scatter.deviations_mm[i],
                             .readings = 1,
                             .where = each.seat->where});
  }
  TestResult twice_s = common;
  twice_s.name = place + ": 2 s";
  twice_s.definition =
      "twice the root of the sum of the squared distances in space from the mean of the points of "
      "the seat, over n - 1";
  if (each.seat->points_mm.size() > 1) twice_s.value_mm = each.scatter.twice_s_mm;
  return {std::move(largest), std::move(twice_s)};
}

bool all_finite(const SeatPoints& seat) {
  return std::all_of(seat.points_mm.begin(), seat.points_mm.end(),
                     [](const Eigen::Vector3d& point) { return point.allFinite(); });
}

}  // namespace

std::string_view to_string(ReachZone zone) {
  switch (zone) {
    case ReachZone::near:
      return "near";
    case ReachZone::middle:
      return "middle";
    case ReachZone::far:
      return "far";
  }
  return "unknown";
}

ReachZone zone_of(double distance_mm, double reach_mm) {
  if (distance_mm < kNearBelow * reach_mm) return ReachZone::near;
  return distance_mm > kFarAbove * reach_mm ? ReachZone::far : ReachZone::middle;
}

ArmReach reach_of(const ArmModel& arm) {
  return {arm.base_from_first_joint.translation_mm, reach_mm(arm)};
}

SeatScatter scatter_in_seat(std::span<const Eigen::Vector3d> points_mm) {
  if (points_mm.empty()) throw std::invalid_argument("scatter in a seat: there are no points");
  const double count = static_cast<double>(points_mm.size());
  SeatScatter scatter;
  // From the first point, so that rounding is that of the scatter and not of the coordinates.
  const Eigen::Vector3d first = points_mm.front();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points_mm) sum += point - first;
  const Eigen::Vector3d mean_from_first = sum / count;
  scatter.mean_mm = first + mean_from_first;
  double squares = 0.0;
  for (const Eigen::Vector3d& point : points_mm) {
    const double deviation = (point - first - mean_from_first).norm();
    scatter.deviations_mm.push_back(deviation);
    scatter.largest_mm = std::max(scatter.largest_mm, deviation);
    squares += deviation * deviation;
  }
  if (points_mm.size() > 1) scatter.twice_s_mm = 2.0 * std::sqrt(squares / (count - 1.0));
  return scatter;
}

std::vector<TestResult> single_point_articulation(std::span<const SeatPoints> seats,
                                                  const ArmReach& arm) {
  if (!(std::isfinite(arm.reach_mm) && arm.reach_mm > 0.0)) {
    throw std::invalid_argument(fmt::format("reach {} mm: must be larger than 0", arm.reach_mm));
  }
  TestResult common;
  common.standard = kStandard;
  common.is_signed = false;
  std::vector<ZonedSeat> zoned;
  for (const SeatPoints& seat : seats) {
    add_unless_as_asked(common.missing, seat.points_mm.size(), kArticulations, "articulation",
                        " in seat " + seat.name);
    if (seat.points_mm.empty()) continue;
    if (!all_finite(seat)) {
      common.problems.push_back("seat " + seat.name + ": a coordinate is not a finite number");
      continue;
    }
    SeatScatter scatter = scatter_in_seat(seat.points_mm);
    const double distance_mm = (scatter.mean_mm - arm.first_axis_origin_mm).norm();
    const ReachZone zone = zone_of(distance_mm, arm.reach_mm);
    if (distance_mm > kTooFarToReach * arm.reach_mm) {
      common.problems.push_back(fmt::format(
          "seat {}: {:.1f} mm from the first axis, the arm reaches {:.1f} mm; are units mixed?",
          seat.name, distance_mm, arm.reach_mm));
    }
    zoned.push_back({&seat, std::move(scatter), zone});
  }
  for (std::string& each : missing_zones(zoned)) common.missing.push_back(std::move(each));
  std::vector<TestResult> results;
  for (const ZonedSeat& each : zoned) {
    for (TestResult& result : results_of(each, common)) results.push_back(std::move(result));
  }
  if (results.empty()) results.push_back(common);
  return results;
}

}  // namespace armcal::b89_4_22
