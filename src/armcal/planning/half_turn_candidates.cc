// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/half_turn_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

constexpr double kPi = std::numbers::pi;
// Rounding of degrees: a limit of 90 deg admits a posture of 90 deg.
constexpr double kAngleRounding_rad = 1e-9;
// With the tip nearer to the axis than this share of the reach, the distance says little of the arm
// and its direction is at the mercy of the arm's own errors.
constexpr double kShortestShare = 0.01;
// Readings that differ by less than this in every angle are one reading.
constexpr double kAlike_rad = radians_from_degrees(0.5);
constexpr long kTriesPerCandidate = 200;
// After so many repetitions in a row for each one found, there are hardly any left to find.
constexpr long kRepetitions = 20;
constexpr long kLeastRepetitions = 1000;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

// What a joint may read; a joint without a stop stays within one turn, as people give angles.
Range range_of(const Joint& joint) {
  Range range{joint.min_rad - kAngleRounding_rad, joint.max_rad + kAngleRounding_rad};
  const bool open_below = !std::isfinite(joint.min_rad);
  const bool open_above = !std::isfinite(joint.max_rad);
  if (open_below && open_above) return {-kPi + kAngleRounding_rad, kPi + kAngleRounding_rad};
  if (open_below) range.low = joint.max_rad - 2.0 * kPi;
  if (open_above) range.high = joint.min_rad + 2.0 * kPi;
  return range;
}

// An angle of the range, on the grid; nothing where no multiple lies inside.
std::optional<double> draw(const Range& range, double grid_rad, RandomStream& random) {
  if (range.high < range.low) return std::nullopt;
  if (grid_rad <= 0.0) return random.uniform(range.low, range.high);
  const auto first = static_cast<long>(std::ceil(range.low / grid_rad));
  const auto last = static_cast<long>(std::floor(range.high / grid_rad));
  if (last < first) return std::nullopt;
  const auto count = static_cast<std::uint64_t>(last - first + 1);
  return grid_rad * static_cast<double>(first + static_cast<long>(random.below(count)));
}

// A half turn of the joint that starts and ends within its limits; joints without stops turn
// upwards or downwards as chance has it.
bool draw_half_turn(const Joint& joint, double grid_rad, RandomStream& random, double& start,
                    double& end) {
  const bool endless = !std::isfinite(joint.min_rad) && !std::isfinite(joint.max_rad);
  Range range = range_of(joint);
  // From low to high - pi upwards, or the same the other way round.
  if (!endless) range.high -= kPi;
  const auto low = draw(range, grid_rad, random);
  if (!low) return false;
  start = *low;
  end = *low + kPi;
  if (endless && start > kAngleRounding_rad) {
    end = start - kPi;
  } else if (!endless && random.below(2) == 1) {
    std::swap(start, end);
  }
  return true;
}

// What makes the distance: the joint that turns and the angles behind it, in steps too small to
// matter.
std::vector<long> identity_of(const HalfTurn& turn) {
  std::vector<long> identity = {turn.joint};
  const long whole_turn = std::lround(2.0 * kPi / kAlike_rad);
  for (Eigen::Index j = turn.joint; j < turn.posture_rad.size(); ++j) {
    const long steps = std::lround(turn.posture_rad(j) / kAlike_rad) % whole_turn;
    identity.push_back(steps < 0 ? steps + whole_turn : steps);
  }
  return identity;
}

bool lies_inside(const Eigen::Vector3d& point, const std::optional<MeasuringVolume>& volume) {
  return !volume || ((point.array() >= volume->low_mm.array()).all() &&
                     (point.array() <= volume->high_mm.array()).all());
}

class Search {
 public:
  Search(const ArmModel& arm, const HalfTurnRoom& room)
      : arm_(arm), room_(room), kinematics_(arm), shortest_mm_(kShortestShare * reach_mm(arm)) {}

  [[nodiscard]] std::optional<HalfTurn> attempt(int joint, RandomStream& random,
                                                Rejections& rejections) const {
    HalfTurn turn;
    turn.joint = joint;
    turn.posture_rad.resize(arm_.joint_count());
    for (Eigen::Index j = 0; j < turn.posture_rad.size(); ++j) {
      if (j == joint - 1) continue;
      const auto angle =
          draw(range_of(arm_.joints[static_cast<std::size_t>(j)]), room_.grid_rad, random);
      if (!angle) return rejected(rejections.beyond_limit);
      turn.posture_rad(j) = *angle;
    }
    double start = 0.0;
    double end = 0.0;
    if (!draw_half_turn(arm_.joints[static_cast<std::size_t>(joint - 1)], room_.grid_rad, random,
                        start, end)) {
      return rejected(rejections.beyond_limit);
    }
    turn.posture_end_rad = turn.posture_rad;
    turn.posture_rad(joint - 1) = start;
    turn.posture_end_rad(joint - 1) = end;
    const Eigen::Vector3d before = kinematics_.tip_in_base(as_span(turn.posture_rad));
    if (!lies_inside(before, room_.volume)) return rejected(rejections.outside_volume);
    const Eigen::Vector3d after = kinematics_.tip_in_base(as_span(turn.posture_end_rad));
    if (!lies_inside(after, room_.volume)) return rejected(rejections.outside_volume);
    if ((after - before).norm() < shortest_mm_) return rejected(rejections.no_distance);
    for (const Eigen::VectorXd* posture : {&turn.posture_rad, &turn.posture_end_rad}) {
      if (collision(kinematics_, as_span(*posture), room_.surroundings)) {
        return rejected(rejections.in_collision);
      }
    }
    return turn;
  }

 private:
  static std::optional<HalfTurn> rejected(long& count) {
    ++count;
    return std::nullopt;
  }

  const ArmModel& arm_;
  const HalfTurnRoom& room_;
  ForwardKinematics kinematics_;
  double shortest_mm_;
};

}  // namespace

std::string explain(const Rejections& rejections) {
  return fmt::format(
      "of {} half turns tried, {} were beyond a joint limit, {} left the measuring volume, {} ran "
      "into the column or the bench, {} had the tip on the axis, {} repeated another",
      rejections.tried, rejections.beyond_limit, rejections.outside_volume, rejections.in_collision,
      rejections.no_distance, rejections.repeated);
}

std::vector<HalfTurn> half_turn_candidates(const ArmModel& arm, const HalfTurnRoom& room, int count,
                                           std::uint64_t seed, Rejections& rejections,
                                           const Monitor& monitor) {
  std::vector<int> joints = room.joints;
  if (joints.empty()) {
    joints.resize(static_cast<std::size_t>(arm.joint_count()));
    std::iota(joints.begin(), joints.end(), 1);
  }
  for (const int joint : joints) {
    if (joint < 1 || joint > arm.joint_count()) {
      throw ImpossiblePlan(fmt::format("joint {} of an arm with {} joints cannot be turned", joint,
                                       arm.joint_count()));
    }
  }
  const Search search(arm, room);
  RandomStream random(seed);
  std::set<std::vector<long>> known;
  std::vector<HalfTurn> found;
  const long most_tries = kTriesPerCandidate * count;
  long repeated = 0;  // since the last one was found
  for (long tried = 0; tried < most_tries && std::ssize(found) < count; ++tried) {
    if (repeated > kLeastRepetitions + kRepetitions * std::ssize(found)) break;
    if (tried % 10000 == 0) {
      monitor.report("looking for half turns", static_cast<double>(std::ssize(found)) / count);
    }
    const int joint = joints[random.below(joints.size())];
    ++rejections.tried;
    auto turn = search.attempt(joint, random, rejections);
    if (!turn) continue;
    if (!known.insert(identity_of(*turn)).second) {
      ++rejections.repeated;
      ++repeated;
      continue;
    }
    found.push_back(std::move(*turn));
    repeated = 0;
  }
  return found;
}

std::optional<std::string> obstacle(const ArmModel& arm, const HalfTurnRoom& room,
                                    const Eigen::VectorXd& posture_rad) {
  const ForwardKinematics kinematics(arm);
  for (Eigen::Index j = 0; j < posture_rad.size(); ++j) {
    const Joint& joint = arm.joints[static_cast<std::size_t>(j)];
    if (posture_rad(j) < joint.min_rad - kAngleRounding_rad ||
        posture_rad(j) > joint.max_rad + kAngleRounding_rad) {
      return fmt::format("joint {} is beyond its limit", j + 1);
    }
  }
  if (!lies_inside(kinematics.tip_in_base(as_span(posture_rad)), room.volume)) {
    return "the tip is outside the measuring volume";
  }
  return collision(kinematics, as_span(posture_rad), room.surroundings);
}

}  // namespace armcal
