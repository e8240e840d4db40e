// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/joint_coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armcal {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

double share_of_turn(std::vector<double> readings_rad) {
  for (double& reading : readings_rad) reading -= kTurn_rad * std::floor(reading / kTurn_rad);
  std::sort(readings_rad.begin(), readings_rad.end());
  double gap = readings_rad.front() + kTurn_rad - readings_rad.back();
  for (std::size_t i = 1; i < readings_rad.size(); ++i) {
    gap = std::max(gap, readings_rad[i] - readings_rad[i - 1]);
  }
  return std::max(0.0, 1.0 - gap / kTurn_rad);  // rounding of a whole turn
}

}  // namespace

Eigen::VectorXd joint_coverage(const ArmModel& arm,
                               const std::vector<Eigen::VectorXd>& postures_rad) {
  Eigen::VectorXd share = Eigen::VectorXd::Zero(arm.joint_count());
  if (postures_rad.empty()) return share;
  for (Eigen::Index j = 0; j < share.size(); ++j) {
    std::vector<double> readings;
    for (const Eigen::VectorXd& posture : postures_rad) readings.push_back(posture(j));
    const Joint& joint = arm.joints[static_cast<std::size_t>(j)];
    const double range = joint.max_rad - joint.min_rad;
    const auto [low, high] = std::minmax_element(readings.begin(), readings.end());
    share(j) =
        range < kTurn_rad ? (range > 0.0 ? (*high - *low) / range : 1.0) : share_of_turn(readings);
  }
  return share;
}

}  // namespace armcal
