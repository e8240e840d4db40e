// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/half_turns.h"

#include <fmt/format.h>

#include <numbers>
#include <numeric>
#include <optional>

#include "armcal/geometry/circle.h"
#include "armcal/simulation/empty_group.h"

namespace armcal {
namespace {

constexpr int kAttempts = 500;

Eigen::VectorXd turned(const Eigen::VectorXd& posture, int joint, double turn_rad) {
  Eigen::VectorXd other = posture;
  other(joint - 1) += turn_rad;
  return other;
}

std::vector<int> or_first(const std::vector<int>& joints, int count) {
  if (!joints.empty()) return joints;
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 1);
  return all;
}

int joint_of(const std::vector<int>& joints, int row) {
  return joints[static_cast<std::size_t>(row) % joints.size()];
}

// A posture from which the joint can be turned by all these angles.
Eigen::VectorXd posture_to_turn(Laboratory& laboratory, int joint,
                                const std::vector<double>& turns_rad, const std::string& gesture) {
  std::string reason;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Eigen::VectorXd posture = laboratory.free_posture();
    std::optional<std::string> obstacle;
    for (const double turn_rad : turns_rad) {
      obstacle = laboratory.arm().obstacle(turned(posture, joint, turn_rad));
      if (obstacle) break;
    }
    if (!obstacle) return posture;
    reason = *obstacle;
  }
  throw Impossible(fmt::format("{} of joint {}: none of {} random postures leaves room for it: {}",
                               gesture, joint, kAttempts, reason));
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const HalfTurns& half_turns) {
  using std::numbers::pi;
  const int joint_count = laboratory.arm().truth().joint_count();
  const std::vector<int> joints = or_first(half_turns.joints, joint_count - 1);
  ObservationGroup group = empty_group(ReferenceKind::reversal, half_turns.name, half_turns.count,
                                       joint_count, half_turns.u_mm);
  group.encoder_end_rad.resize(joint_count, half_turns.count);
  group.value_mm.resize(half_turns.count);
  for (int i = 0; i < half_turns.count; ++i) {
    const int joint = joint_of(joints, i);
    const Eigen::VectorXd posture =
        posture_to_turn(laboratory, joint, {pi}, half_turns.name + ": half turn");
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
  const std::vector<int> joints = or_first(circles.joints, joint_count);
  ObservationGroup group = empty_group(ReferenceKind::circle_radius, circles.name, circles.count,
                                       joint_count, circles.u_mm);
  group.value_mm.resize(circles.count);
  constexpr int kSteps = 8;
  std::vector<double> turns_rad;
  for (int k = 0; k <= kSteps; ++k) {
    turns_rad.push_back(circles.arc_rad * (static_cast<double>(k) / kSteps - 0.5));
  }
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
