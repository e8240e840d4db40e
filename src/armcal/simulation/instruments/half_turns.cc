// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/half_turns.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "armcal/geometry/circle.h"
#include "armcal/observations/empty_group.h"

namespace armcal {
namespace {

constexpr int kHalfTurnAttempts = 500;

Eigen::VectorXd turned(const Eigen::VectorXd& posture, int joint, double turn_rad) {
  Eigen::VectorXd other = posture;
  other(joint - 1) += turn_rad;
  return other;
}

int joint_of(const std::vector<int>& joints, int row) {
  return joints[static_cast<std::size_t>(row) % joints.size()];
}

// Angles by which a joint is turned from where it stands, ascending.
using Turns = std::vector<double>;

// How far a joint may stand about with all of its turns between its stops; not positive where
// they do not leave room.
double room_for(const Joint& joint, const Turns& turns_rad) {
  return joint.max_rad - joint.min_rad - (turns_rad.back() - turns_rad.front());
}

std::vector<int> or_all_with_room(const std::vector<int>& joints, const ArmModel& arm, int last,
                                  const Turns& turns_rad) {
  if (!joints.empty()) return joints;
  constexpr double kRoom_rad = radians_from_degrees(1.0);
  std::vector<int> all;
  for (int joint = 1; joint <= last; ++joint) {
    if (room_for(arm.joints[static_cast<std::size_t>(joint - 1)], turns_rad) > kRoom_rad) {
      all.push_back(joint);
    }
  }
  if (all.empty())
    throw Impossible(fmt::format("no joint can be turned by {:.1f} deg",
                                 degrees_from_radians(turns_rad.back() - turns_rad.front())));
  return all;
}

// A posture from which the joint can be turned by all these angles.
Eigen::VectorXd posture_to_turn(Laboratory& laboratory, int joint, const Turns& turns_rad,
                                const std::string& gesture) {
  const Joint& stops = laboratory.arm().truth().joints[static_cast<std::size_t>(joint - 1)];
  if (!(room_for(stops, turns_rad) > 0.0)) {
    throw Impossible(fmt::format("{} of joint {} is impossible: its stops are {:.1f} deg apart",
                                 gesture, joint,
                                 degrees_from_radians(stops.max_rad - stops.min_rad)));
  }
  std::string reason;
  for (int attempt = 0; attempt < kHalfTurnAttempts; ++attempt) {
    Eigen::VectorXd posture = laboratory.free_posture();
    const double low = stops.min_rad - turns_rad.front();
    const double high = stops.max_rad - turns_rad.back();
    // Between two stops few of the free angles leave room.
    if (std::isfinite(high - low)) posture(joint - 1) = laboratory.random().uniform(low, high);
    std::optional<std::string> obstacle;
    for (const double turn_rad : turns_rad) {
      obstacle = laboratory.arm().obstacle(turned(posture, joint, turn_rad));
      if (obstacle) break;
    }
    if (!obstacle) return posture;
    reason = *obstacle;
  }
  throw Impossible(fmt::format("{} of joint {}: none of {} random postures leaves room for it: {}",
                               gesture, joint, kHalfTurnAttempts, reason));
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const HalfTurns& half_turns) {
  using std::numbers::pi;
  const int joint_count = laboratory.arm().truth().joint_count();
  const Turns turns_rad = {0.0, pi};
  const std::vector<int> joints =
      or_all_with_room(half_turns.joints, laboratory.arm().truth(), joint_count - 1, turns_rad);
  ObservationGroup group = empty_group(ReferenceKind::reversal, half_turns.name, half_turns.count,
                                       joint_count, half_turns.u_mm);
  group.encoder_end_rad.resize(joint_count, half_turns.count);
  group.value_mm.resize(half_turns.count);
  for (int i = 0; i < half_turns.count; ++i) {
    const int joint = joint_of(joints, i);
    const Eigen::VectorXd posture =
        posture_to_turn(laboratory, joint, turns_rad, half_turns.name + ": half turn");
    const TakenReading before = laboratory.take(posture);
    const TakenReading after = laboratory.take(turned(posture, joint, pi));
    group.joint.push_back(joint);
    group.encoder_rad.col(i) = before.encoder_rad;
    group.encoder_end_rad.col(i) = turned(before.encoder_rad, joint, pi);
    group.value_mm(i) =
        (before.tip_mm - after.tip_mm).norm() + half_turns.u_mm * laboratory.random().normal();
  }
  return {group};
}

std::vector<ObservationGroup> measure(Laboratory& laboratory, const CircleRadii& circles) {
  const int joint_count = laboratory.arm().truth().joint_count();
  ObservationGroup group = empty_group(ReferenceKind::circle_radius, circles.name, circles.count,
                                       joint_count, circles.u_mm);
  group.value_mm.resize(circles.count);
  constexpr int kSteps = 8;
  Turns turns_rad;
  for (int k = 0; k <= kSteps; ++k) {
    turns_rad.push_back(circles.arc_rad * (static_cast<double>(k) / kSteps - 0.5));
  }
  const std::vector<int> joints =
      or_all_with_room(circles.joints, laboratory.arm().truth(), joint_count, turns_rad);
  for (int i = 0; i < circles.count; ++i) {
    const int joint = joint_of(joints, i);
    const Eigen::VectorXd posture =
        posture_to_turn(laboratory, joint, turns_rad, circles.name + ": circle");
    std::vector<Eigen::Vector3d> arc;
    for (const double turn_rad : turns_rad) {
      const TakenReading taken = laboratory.take(turned(posture, joint, turn_rad));
      arc.push_back(taken.tip_mm);
      if (turn_rad == 0.0) group.encoder_rad.col(i) = taken.encoder_rad;
    }
    group.joint.push_back(joint);
    group.value_mm(i) = fit_circle(arc).radius_mm + circles.u_mm * laboratory.random().normal();
  }
  return {group};
}

}  // namespace armcal
