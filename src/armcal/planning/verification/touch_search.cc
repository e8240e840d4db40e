// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/touch_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/simulation/posture_choice.h"

namespace armcal {
namespace {

// A point within reach is found from one start in three or so, with stops and a bench from one in
// ten. What is found once only may never be found again.
constexpr int kStartsForReach = 40;
constexpr std::size_t kEnoughForReach = 2;
// Part of the reach about the first axis that the arm's own base and shoulder fill, whether or not
// a column is stated.
constexpr double kKeepOutShare = 0.05;
// An arm that is stretched out straight has one posture and no hand can find it.
constexpr double kUsableShare = 0.97;
// Nearer to the first axis than this a point has no direction from it.
constexpr double kOnAxis_mm = 1e-6;

}  // namespace

TouchSearch::TouchSearch(const ArmModel& arm, VerificationRoom room)
    : arm_(arm), room_(std::move(room)), kinematics_(arm), limits_(joint_limits(arm)) {}

Eigen::Vector3d TouchSearch::origin_mm() const { return arm_.base_from_first_joint.translation_mm; }

Eigen::Vector3d TouchSearch::up() const { return arm_.base_from_first_joint.rotation.col(2); }

Eigen::Vector3d TouchSearch::level_direction(const Eigen::Vector3d& point_mm) const {
  const Eigen::Vector3d way = point_mm - origin_mm();
  const Eigen::Vector3d level = way - up() * up().dot(way);
  if (level.norm() < kOnAxis_mm) return arm_.base_from_first_joint.rotation.col(0);
  return level.normalized();
}

Eigen::Vector3d TouchSearch::tip(const Eigen::VectorXd& encoder_rad) const {
  return kinematics_.tip_in_base(as_span(encoder_rad));
}

// The second joint goes round on a circle about the first axis; the rest of the arm is a chain.
TouchSearch::Ball TouchSearch::outermost_reach() const {
  const Link& first = arm_.links.front();
  return {origin_mm() + up() * first.d_mm, reach_mm(arm_) -
                                               std::hypot(first.a_mm, first.b_mm, first.d_mm) +
                                               std::hypot(first.a_mm, first.b_mm)};
}

std::optional<std::string> TouchSearch::fault_at(const Eigen::Vector3d& point_mm,
                                                 double clearance_mm) const {
  const auto& volume = room_.volume;
  if (volume && ((point_mm.array() < volume->low_mm.array()).any() ||
                 (point_mm.array() > volume->high_mm.array()).any())) {
    return "outside the measuring volume";
  }
  const Eigen::Vector3d way = point_mm - origin_mm();
  const double height = up().dot(way);
  const auto& bench = room_.surroundings.bench_mm;
  if (bench && height < *bench + clearance_mm) return "below the bench";
  const double keep_out =
      std::max(room_.surroundings.column_radius_mm, kKeepOutShare * reach_mm(arm_));
  if ((way - height * up()).norm() < keep_out + clearance_mm) return "too near the first axis";
  const Ball ball = outermost_reach();
  if ((point_mm - ball.centre_mm).norm() > kUsableShare * ball.radius_mm) return "out of reach";
  return std::nullopt;
}

std::optional<Eigen::VectorXd> TouchSearch::posture_near(const Touch& touch,
                                                         const Eigen::VectorXd& start_rad) const {
  PostureSearchOptions options;
  options.limits = limits_;
  const PostureSearch search = find_posture(kinematics_, touch.tip_mm, start_rad, options);
  if (!search.found) return std::nullopt;
  const Eigen::VectorXd& posture = search.encoder_rad;
  if (touch.outward.dot(stylus_direction(posture)) > 0.0) return std::nullopt;  // from behind
  if (broken_limit(arm_, as_span(posture))) return std::nullopt;
  if (collision(kinematics_, as_span(posture), room_.surroundings)) return std::nullopt;
  return posture;
}

std::vector<Eigen::VectorXd> TouchSearch::postures(const Touch& touch, std::size_t count,
                                                   int most_starts, RandomStream& random) const {
  std::vector<Eigen::VectorXd> found;
  for (int i = 0; i < most_starts && found.size() < count; ++i) {
    if (auto posture = posture_near(touch, random_posture(random))) {
      found.push_back(std::move(*posture));
    }
  }
  return found;
}

bool TouchSearch::reaches(const Touch& touch, RandomStream& random) const {
  return postures(touch, kEnoughForReach, kStartsForReach, random).size() == kEnoughForReach;
}

Eigen::VectorXd TouchSearch::random_posture(RandomStream& random) const {
  Eigen::VectorXd posture(arm_.joint_count());
  for (std::size_t i = 0; i < arm_.joints.size(); ++i) {
    const auto [low, high] = range_in_use(arm_.joints[i]);
    posture(static_cast<Eigen::Index>(i)) = random.uniform(low, high);
  }
  return posture;
}

Eigen::Vector3d TouchSearch::stylus_direction(const Eigen::VectorXd& encoder_rad) const {
  const TipLinearisation at = kinematics_.linearise(as_span(encoder_rad));
  const Eigen::Vector3d last_joint = at.joint_origins_mm.rightCols<1>();
  return (at.tip_mm - last_joint).normalized();
}

double TouchSearch::elbow_mm(const Eigen::VectorXd& encoder_rad) const {
  const TipLinearisation at = kinematics_.linearise(as_span(encoder_rad));
  const Eigen::Vector3d shoulder = at.joint_origins_mm.col(1);
  const Eigen::Vector3d line = (at.tip_mm - shoulder).normalized();
  Eigen::Vector3d elbow = shoulder;
  double farthest = -1.0;
  for (Eigen::Index i = 2; i < at.joint_origins_mm.cols(); ++i) {
    const Eigen::Vector3d joint = at.joint_origins_mm.col(i);
    const double distance = line.cross(joint - shoulder).norm();
    if (distance <= farthest) continue;
    farthest = distance;
    elbow = joint;
  }
  return up().cross(level_direction(at.tip_mm)).dot(elbow - origin_mm());
}

const Eigen::VectorXd& farthest_from(const std::vector<Eigen::VectorXd>& chosen,
                                     const std::vector<Eigen::VectorXd>& candidates) {
  ARMCAL_INVARIANT(!candidates.empty());
  const Eigen::VectorXd* best = &candidates.front();
  double farthest = -1.0;
  for (const Eigen::VectorXd& candidate : candidates) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::VectorXd& each : chosen) {
      nearest = std::min(nearest, joint_distance_rad(candidate, each));
    }
    if (nearest <= farthest) continue;
    farthest = nearest;
    best = &candidate;
  }
  return *best;
}

}  // namespace armcal
