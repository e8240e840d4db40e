// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/indexed_platform.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/contact.h"

namespace armcal {
namespace {

RigidTransform turn_about_z(double angle_rad) {
  return {rotation_about_z(angle_rad), Eigen::Vector3d::Zero()};
}

RigidTransform shift(double x_mm, double y_mm, double z_mm) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x_mm, y_mm, z_mm)};
}

// The platform at one index: what it shows, and how the base of the arm stands in the room.
struct Position {
  double index_rad;
  RigidTransform room_from_base;
};

std::vector<Position> positions_of(Laboratory& laboratory, const IndexedPlatform& platform) {
  const RigidTransform axis = on_platform(laboratory.arm().truth(), platform).base_from_first_joint;
  std::vector<Position> positions;
  for (int k = 0; k < platform.positions; ++k) {
    const double index_rad = 2.0 * std::numbers::pi * k / platform.positions;
    const double turned_rad = index_rad + platform.u_index_rad * laboratory.random().normal();
    positions.push_back({index_rad, axis * turn_about_z(turned_rad) * axis.inverse()});
  }
  return positions;
}

Feature as_seen(const Position& position, const Feature& in_room) {
  return placed(position.room_from_base.inverse(), in_room);
}

// A point of the gauge, and the positions from which the arm reaches it.
struct GaugePoint {
  Feature in_room;
  std::vector<const Position*> seen_from;
};

GaugePoint gauge_point(Laboratory& laboratory, const IndexedPlatform& platform,
                       const std::vector<Position>& positions, int number) {
  constexpr int kTries = 100;
  const auto enough = std::min<std::size_t>(2, positions.size());
  GaugePoint point;
  point.in_room.name = fmt::format("{}: P{}", platform.name, number);
  for (int i = 0; i < kTries; ++i) {
    const Position& middle = positions[laboratory.random().below(positions.size())];
    point.in_room.at_mm = middle.room_from_base * laboratory.convenient_point();
    point.seen_from.clear();
    for (const Position& position : positions) {
      const Feature seen = as_seen(position, point.in_room);
      if (obstruction(laboratory.arm(), seen.at_mm)) break;  // the column comes round to it
      if (is_within_reach(laboratory, seen)) point.seen_from.push_back(&position);
    }
    if (point.seen_from.size() >= enough) return point;
  }
  throw Impossible(
      fmt::format("{}: none of {} places for point P{} is within reach from {} of the "
                  "{} positions",
                  platform.name, kTries, number, enough, positions.size()));
}

}  // namespace

ArmModel on_platform(const ArmModel& arm, const IndexedPlatform& platform) {
  ArmModel both = arm;
  both.name = arm.name + " on an indexed platform";
  both.joints.insert(both.joints.begin(), Joint{});
  both.links.insert(both.links.begin(), Link{.a_mm = platform.radius_mm});
  both.base_from_first_joint = arm.base_from_first_joint * shift(-platform.radius_mm, 0.0, 0.0);
  return both;
}

ArmModel without_platform(const ArmModel& arm_on_platform) {
  const Link& link = arm_on_platform.links.front();
  ArmModel arm = arm_on_platform;
  arm.base_from_first_joint = arm_on_platform.base_from_first_joint *
                              turn_about_z(arm_on_platform.joints.front().zero_rad) *
                              shift(link.a_mm, link.b_mm, link.d_mm) *
                              RigidTransform{twist(link), Eigen::Vector3d::Zero()};
  arm.joints.erase(arm.joints.begin());
  arm.links.erase(arm.links.begin());
  return arm;
}

std::vector<ObservationGroup> measure(Laboratory& laboratory, const IndexedPlatform& platform) {
  const std::vector<Position> positions = positions_of(laboratory, platform);
  std::vector<Eigen::VectorXd> readings;
  std::vector<GaugePoint> points;
  std::vector<std::size_t> point_of_reading;
  for (int k = 1; k <= platform.points; ++k) {
    points.push_back(gauge_point(laboratory, platform, positions, k));
  }
  for (const Position& position : positions) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& seen_from = points[k].seen_from;
      if (std::find(seen_from.begin(), seen_from.end(), &position) == seen_from.end()) continue;
      const Feature seat = as_seen(position, points[k].in_room);
      const Eigen::MatrixXd encoder_rad =
          take_in_seat(laboratory, seat, seat.name, platform.postures, platform.u_mm);
      for (const auto& of_arm : encoder_rad.colwise()) {
        readings.emplace_back(of_arm.size() + 1);
        readings.back() << position.index_rad, of_arm;
        point_of_reading.push_back(k);
      }
    }
  }
  const int rows = static_cast<int>(readings.size());
  ObservationGroup group = empty_group(ReferenceKind::artefact, platform.name, rows,
                                       laboratory.arm().truth().joint_count() + 1, platform.u_mm);
  group.reference_mm.resize(3, rows);
  group.place.assign(readings.size(), platform.name + "-1");
  for (int row = 0; row < rows; ++row) {
    const std::size_t k = point_of_reading[static_cast<std::size_t>(row)];
    group.encoder_rad.col(row) = readings[static_cast<std::size_t>(row)];
    group.reference_mm.col(row) = points[k].in_room.at_mm;
    group.feature.push_back(fmt::format("P{}", k + 1));
  }
  return {group};
}

}  // namespace armcal
