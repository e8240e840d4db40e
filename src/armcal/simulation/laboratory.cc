// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/laboratory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armcal {
namespace {

// Streams of the laboratory come after those of the arm.
constexpr std::uint64_t kFirstStream = 1000;
constexpr int kAttempts = 2000;

}  // namespace

Laboratory::Laboratory(VirtualArm arm, std::uint64_t seed)
    : arm_(std::move(arm)), seed_(seed), random_(seed, kFirstStream) {}

void Laboratory::begin(int measurement) {
  random_ = RandomStream(seed_, kFirstStream + static_cast<std::uint64_t>(measurement));
}

Eigen::VectorXd Laboratory::free_posture() {
  const auto& joints = arm_.truth().joints;
  Eigen::VectorXd posture(arm_.truth().joint_count());
  std::string reason;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      using std::numbers::pi;
      // A joint without stops, or with more than one turn between them, is used over one turn.
      const double low = std::isfinite(joints[i].min_rad) ? std::max(joints[i].min_rad, -pi) : -pi;
      const double high = std::isfinite(joints[i].max_rad) ? std::min(joints[i].max_rad, pi) : pi;
      posture(static_cast<Eigen::Index>(i)) = random_.uniform(low, high);
    }
    const auto obstacle = arm_.obstacle(posture);
    if (!obstacle) return posture;
    reason = *obstacle;
  }
  throw Impossible(fmt::format("none of {} random postures is free: {}", kAttempts, reason));
}

std::vector<Eigen::VectorXd> Laboratory::postures_with_tip_at(const Eigen::Vector3d& point_mm,
                                                              int count, const std::string& what,
                                                              const Circumstances& circumstances) {
  std::vector<Eigen::VectorXd> postures;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (static_cast<int>(postures.size()) == count) return postures;
    auto posture = arm_.posture_with_tip_at(point_mm, free_posture(), circumstances);
    if (posture) postures.push_back(std::move(*posture));
    if (postures.empty() && attempt == kAttempts / 10) break;
  }
  throw Impossible(fmt::format(
      "{} at ({:.1f}, {:.1f}, {:.1f}) mm is out of reach: {} of {} wanted postures were found",
      what, point_mm.x(), point_mm.y(), point_mm.z(), postures.size(), count));
}

Eigen::Vector3d Laboratory::convenient_point() {
  // Where the middle of two postures is, the arm reaches in many ways.
  const Eigen::VectorXd first = free_posture();
  return 0.5 * (arm_.tip(first) + arm_.tip(free_posture()));
}

RigidTransform Laboratory::convenient_place(double /*size_mm*/) {
  Eigen::Vector3d turn;
  for (double& component : turn) component = random_.normal();
  return {rotation_from_vector(turn), convenient_point()};
}

Eigen::Vector3d Laboratory::noise(double u_mm) {
  Eigen::Vector3d noise;
  for (double& component : noise) component = u_mm * random_.normal();
  return noise;
}

TakenReading Laboratory::take(const Eigen::VectorXd& encoder_rad, const Eigen::Vector3d& push) {
  const Circumstances now{.time_s = time_s_, .push = push};
  time_s_ += seconds_per_reading;
  return {arm_.shown(encoder_rad, random_), arm_.tip(encoder_rad, now)};
}

}  // namespace armcal
