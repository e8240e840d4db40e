// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/half_turn_walk.h"

#include <cmath>
#include <numbers>

namespace armcal {
namespace {

// Joints without stops are kept within a turn, so that no cable is wound up and angles stay such as
// people give.
constexpr double kOneTurn_rad = std::numbers::pi + kSameAngle_rad;

bool is_endless(const Joint& joint) {
  return !std::isfinite(joint.min_rad) && !std::isfinite(joint.max_rad);
}

// The half turns that joint `turn.joint` can make from where it stands in `from`, with the joints
// before it as in `carried` and those behind it as planned.
std::vector<HalfTurn> from_here(const ArmModel& arm, const HalfTurn& planned,
                                const Eigen::VectorXd& carried, double start_rad) {
  std::vector<HalfTurn> turns;
  const Eigen::Index turned = planned.joint - 1;
  for (const double step : {std::numbers::pi, -std::numbers::pi}) {
    const double end = start_rad + step;
    const Joint& joint = arm.joints[static_cast<std::size_t>(turned)];
    if (is_endless(joint) && std::abs(end) > kOneTurn_rad) continue;
    HalfTurn turn = planned;
    turn.posture_rad.head(turned) = carried.head(turned);
    turn.posture_rad(turned) = start_rad;
    turn.posture_end_rad = turn.posture_rad;
    turn.posture_end_rad(turned) = end;
    turns.push_back(std::move(turn));
  }
  return turns;
}

// Ways to make the half turn, those that move least first.
std::vector<HalfTurn> ways(const ArmModel& arm, const HalfTurn& planned,
                           const Eigen::VectorXd& at) {
  const Eigen::Index turned = planned.joint - 1;
  std::vector<HalfTurn> all = from_here(arm, planned, at, at(turned));
  const auto append = [&](std::vector<HalfTurn> more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  append(from_here(arm, planned, at, planned.posture_rad(turned)));
  append(from_here(arm, planned, at, planned.posture_end_rad(turned)));
  append(from_here(arm, planned, planned.posture_rad, at(turned)));
  all.push_back(planned);
  HalfTurn backwards = planned;
  std::swap(backwards.posture_rad, backwards.posture_end_rad);
  all.push_back(backwards);
  std::stable_sort(all.begin(), all.end(), [&](const HalfTurn& one, const HalfTurn& other) {
    return joints_moved(at, one.posture_rad) < joints_moved(at, other.posture_rad);
  });
  return all;
}

}  // namespace

std::vector<HalfTurn> walk_through(
    const ArmModel& arm, const HalfTurnRoom& room, std::span<const HalfTurn> turns,
    const std::function<bool(const HalfTurn&, const HalfTurn&)>& is_as_good) {
  std::vector<HalfTurn> walk;
  for (const HalfTurn& planned : turns) {
    if (walk.empty()) {
      walk.push_back(planned);
      continue;
    }
    HalfTurn chosen = planned;
    for (const HalfTurn& way : ways(arm, planned, walk.back().posture_end_rad)) {
      if (obstacle(arm, room, way.posture_rad) || obstacle(arm, room, way.posture_end_rad))
        continue;
      if (!is_as_good(way, planned)) continue;
      chosen = way;
      break;
    }
    walk.push_back(std::move(chosen));
  }
  return walk;
}

int joints_moved(const Eigen::VectorXd& from_rad, const Eigen::VectorXd& to_rad) {
  return static_cast<int>(((from_rad - to_rad).array().abs() > kSameAngle_rad).count());
}

int joints_moved(std::span<const HalfTurn> walk) {
  int moved = 0;
  for (std::size_t i = 1; i < walk.size(); ++i) {
    moved += joints_moved(walk[i - 1].posture_end_rad, walk[i].posture_rad);
  }
  return moved;
}

}  // namespace armcal
