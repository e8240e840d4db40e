// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/laboratory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/arm/inverse_kinematics.h"
#include "armcal/core/invariant.h"
#include "armcal/simulation/posture_choice.h"

namespace armcal {
namespace {

// Streams of the laboratory come after those of the arm.
constexpr std::uint64_t kFirstStream = 1000;
constexpr std::uint64_t kStreamsPerMeasurement = 4;

constexpr int kPostureAttempts = 2000;
constexpr int kFruitlessAttempts = 200;  // without any posture: the point is out of reach
constexpr int kCandidatesPerPosture = 3;
constexpr int kThingPlaces = 500;

std::uint64_t stream(int measurement, std::uint64_t purpose) {
  ARMCAL_INVARIANT(measurement >= 0);
  return kFirstStream + kStreamsPerMeasurement * static_cast<std::uint64_t>(measurement) + purpose;
}

std::string in_words(const Eigen::Vector3d& point_mm) {
  return fmt::format("({:.1f}, {:.1f}, {:.1f}) mm", point_mm.x(), point_mm.y(), point_mm.z());
}

}  // namespace

Laboratory::Chance::Chance(std::uint64_t seed, int measurement)
    : choice(seed, stream(measurement, 0)),
      encoders(seed, stream(measurement, 1)),
      foot(seed, stream(measurement, 2)),
      blunders(seed, stream(measurement, 3)) {}

Laboratory::Laboratory(VirtualArm arm, std::uint64_t seed)
    : arm_(std::move(arm)), seed_(seed), chance_(seed, 0) {}

void Laboratory::begin(int measurement) {
  chance_ = Chance(seed_, measurement);
  measurement_ = measurement;
  reading_ = 0;
}

Eigen::VectorXd Laboratory::free_posture() {
  const auto& joints = arm_.truth().joints;
  Eigen::VectorXd posture(arm_.truth().joint_count());
  std::string reason;
  for (int attempt = 0; attempt < kPostureAttempts; ++attempt) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto [low, high] = range_in_use(joints[i]);
      posture(static_cast<Eigen::Index>(i)) = random().uniform(low, high);
    }
    const auto obstacle = arm_.obstacle(posture);
    if (!obstacle) return posture;
    reason = *obstacle;
  }
  throw Impossible(fmt::format("none of {} random postures of arm \"{}\" is free: {}",
                               kPostureAttempts, arm_.truth().name, reason));
}

std::vector<Eigen::VectorXd> Laboratory::postures_with_tip_at(const Eigen::Vector3d& point_mm,
                                                              int count, const std::string& what,
                                                              const Circumstances& circumstances) {
  const auto wanted = static_cast<std::size_t>(count);
  const std::size_t candidates = count > 1 ? kCandidatesPerPosture * wanted : wanted;
  std::vector<Eigen::VectorXd> found;
  const int attempts = std::max(kPostureAttempts, 4 * kCandidatesPerPosture * count);
  for (int i = 0; i < attempts && found.size() < candidates; ++i) {
    if (found.empty() && i == kFruitlessAttempts) break;
    auto posture = arm_.posture_with_tip_at(point_mm, free_posture(), circumstances);
    if (posture) found.push_back(std::move(*posture));
  }
  if (found.size() >= wanted) return most_different(std::move(found), wanted);
  if (found.empty()) {
    throw Impossible(
        fmt::format("{} at {} cannot be reached: {}", what, in_words(point_mm), why_not(point_mm)));
  }
  throw Impossible(fmt::format("{} at {} is hard to reach: {} of {} wanted postures were found",
                               what, in_words(point_mm), found.size(), count));
}

// What the arm would run into on the point, or how far from it the tip remains.
std::string Laboratory::why_not(const Eigen::Vector3d& point_mm) {
  const ForwardKinematics kinematics(arm_.truth());
  const PostureSearch search =
      find_posture(kinematics, point_mm, free_posture(), {.tolerance_mm = 1e-6, .restarts = 20});
  if (!search.found) {
    return fmt::format("the tip comes no nearer to it than {:.1f} mm", search.miss_mm);
  }
  const auto obstacle =
      arm_.obstacle(brought_inside(search.encoder_rad, joint_limits(arm_.truth())));
  return fmt::format("every posture that was tried runs into something{}",
                     obstacle ? ", one of them: " + *obstacle : " or beyond a joint limit");
}

bool Laboratory::reaches(const Eigen::Vector3d& point_mm) {
  constexpr int kTries = 6;
  for (int i = 0; i < kTries; ++i) {
    if (arm_.posture_with_tip_at(point_mm, free_posture())) return true;
  }
  return false;
}

Eigen::Vector3d Laboratory::convenient_point() { return convenient_place(0.0).translation_mm; }

RigidTransform Laboratory::convenient_place(double size_mm) {
  for (int i = 0; i < kThingPlaces; ++i) {
    Eigen::Vector3d turn;
    for (double& component : turn) component = random().normal();
    // Where the middle of two postures is, the arm reaches in many ways.
    const Eigen::VectorXd first = free_posture();
    const RigidTransform place{rotation_from_vector(turn),
                               0.5 * (arm_.tip(first) + arm_.tip(free_posture()))};
    std::vector<Eigen::Vector3d> points = {Eigen::Vector3d::Zero()};
    for (int axis = 0; axis < 2 && size_mm > 0.0; ++axis) {
      points.emplace_back(0.5 * size_mm * Eigen::Vector3d::Unit(axis));
      points.emplace_back(-0.5 * size_mm * Eigen::Vector3d::Unit(axis));
    }
    if (std::ranges::all_of(points, [&](const auto& point) { return reaches(place * point); })) {
      return place;
    }
  }
  throw Impossible(
      fmt::format("none of {} random places has room for something of {:.1f} mm that arm \"{}\" "
                  "reaches all over",
                  kThingPlaces, size_mm, arm_.truth().name));
}

Eigen::Vector3d Laboratory::noise(double u_mm) {
  Eigen::Vector3d noise;
  for (double& component : noise) component = u_mm * random().normal();
  return noise;
}

Circumstances Laboratory::next_circumstances(const Eigen::Vector3d& push) {
  const Circumstances now{
      .time_s = time_s_,
      .push = push,
      .base_movement = drawn_movement(arm_.errors().base_movement, chance_.foot)};
  time_s_ += seconds_per_reading;
  return now;
}

Eigen::Vector3d Laboratory::next_blunder() {
  const Eigen::Vector3d off = drawn_blunder(arm_.errors().blunders, chance_.blunders);
  if (!off.isZero(0.0)) blunders_.push_back({measurement_, reading_, off});
  ++reading_;
  return off;
}

TakenReading Laboratory::take(const Eigen::VectorXd& encoder_rad, const Eigen::Vector3d& push) {
  const Circumstances now = next_circumstances(push);
  const Eigen::Vector3d off = next_blunder();
  return {arm_.shown(encoder_rad, chance_.encoders), arm_.tip(encoder_rad, now) + off, off,
          arm_.base_from_last_joint(encoder_rad, now)};
}

TakenReading Laboratory::take_with_tip_at(const Eigen::Vector3d& point_mm,
                                          const Eigen::VectorXd& near_rad, const std::string& what,
                                          const Eigen::Vector3d& push) {
  const Circumstances now = next_circumstances(push);
  const Eigen::Vector3d off = next_blunder();
  const auto posture = arm_.posture_with_tip_at(point_mm + off, near_rad, now);
  if (!posture) {
    throw Impossible(fmt::format("the tip cannot be held on {} at {} near the posture given", what,
                                 in_words(point_mm)));
  }
  return {arm_.shown(*posture, chance_.encoders), point_mm + off, off,
          arm_.base_from_last_joint(*posture, now)};
}

}  // namespace armcal
