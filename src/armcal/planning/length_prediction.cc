// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/length_prediction.h"

#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

constexpr int kTriesPerPosture = 2000;

double uniform_angle(const Joint& joint, RandomStream& random) {
  double low = joint.min_rad;
  double high = joint.max_rad;
  if (!std::isfinite(low))
    low = std::isfinite(high) ? high - 2.0 * std::numbers::pi : -std::numbers::pi;
  if (!std::isfinite(high)) high = low + 2.0 * std::numbers::pi;
  return random.uniform(low, high);
}

Eigen::VectorXd random_posture(const ArmModel& arm, const HalfTurnRoom& room,
                               RandomStream& random) {
  Eigen::VectorXd posture(arm.joint_count());
  for (int tried = 0; tried < kTriesPerPosture; ++tried) {
    for (Eigen::Index j = 0; j < posture.size(); ++j) {
      posture(j) = uniform_angle(arm.joints[static_cast<std::size_t>(j)], random);
    }
    if (!obstacle(arm, room, posture)) return posture;
  }
  throw ImpossiblePlan(
      "the arm has nearly no posture that is clear of the column and the bench, with its tip "
      "inside "
      "the measuring volume");
}

}  // namespace

std::vector<PosturePair> random_pairs(const ArmModel& arm, const HalfTurnRoom& room, int count,
                                      std::uint64_t seed) {
  RandomStream random(seed, 1);
  std::vector<PosturePair> pairs;
  for (int i = 0; i < count; ++i) {
    Eigen::VectorXd first = random_posture(arm, room, random);
    pairs.push_back({std::move(first), random_posture(arm, room, random)});
  }
  return pairs;
}

double predicted_length_error_mm(const ArmModel& arm, std::span<const int> unknowns,
                                 const Eigen::MatrixXd& covariance,
                                 std::span<const PosturePair> pairs) {
  const ForwardKinematics kinematics(arm);
  const std::vector<int> columns(unknowns.begin(), unknowns.end());
  double sum = 0.0;
  for (const PosturePair& pair : pairs) {
    const TipLinearisation first = kinematics.linearise(as_span(pair.first_rad));
    const TipLinearisation second = kinematics.linearise(as_span(pair.second_rad));
    const Eigen::Vector3d direction = (first.tip_mm - second.tip_mm).stableNormalized();
    const Eigen::VectorXd all =
        (first.J_tip_parameters - second.J_tip_parameters).transpose() * direction;
    const Eigen::VectorXd gradient = all(columns);
    sum += gradient.dot(covariance * gradient);
  }
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

double length_error_mm(const ArmModel& arm, const ArmModel& truth,
                       std::span<const PosturePair> pairs) {
  const ForwardKinematics calibrated(arm);
  const ForwardKinematics true_arm(truth);
  const auto length = [](const ForwardKinematics& kinematics, const PosturePair& pair) {
    return (kinematics.tip_in_base(as_span(pair.first_rad)) -
            kinematics.tip_in_base(as_span(pair.second_rad)))
        .norm();
  };
  double sum = 0.0;
  for (const PosturePair& pair : pairs) {
    const double error = length(calibrated, pair) - length(true_arm, pair);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace armcal
