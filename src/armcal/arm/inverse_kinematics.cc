// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/inverse_kinematics.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// A posture and how the tip moves there, for the joints that may move.
struct Posture {
  Eigen::VectorXd encoder_rad;
  Eigen::Vector3d missing_mm;
  Eigen::Matrix3Xd J_tip_joints;  // columns of joints that may not move are 0

  [[nodiscard]] double miss_mm() const { return missing_mm.norm(); }
  // The largest slope of the miss by any joint, as a part of what a whole lever would give: 0 where
  // no joint brings the tip nearer at once.
  [[nodiscard]] double slope() const {
    const double lever = J_tip_joints.colwise().norm().maxCoeff();
    if (lever == 0.0) return 0.0;
    return (J_tip_joints.transpose() * missing_mm).lpNorm<Eigen::Infinity>() /
           (lever * missing_mm.norm());
  }
};

class Search {
 public:
  Search(const ForwardKinematics& kinematics, const Eigen::Vector3d& point_mm,
         const PostureSearchOptions& options);

  /// The start with those joints brought inside their limits that may move.
  [[nodiscard]] Eigen::VectorXd start(const Eigen::VectorXd& encoder_rad) const;
  /// A posture of its own for every number, all spread evenly.
  [[nodiscard]] Eigen::VectorXd elsewhere(const Eigen::VectorXd& encoder_rad, int number) const;
  /// The place nearest to the point that the way down from a posture passes.
  [[nodiscard]] Posture descended(const Eigen::VectorXd& encoder_rad);
  [[nodiscard]] bool has_arrived(const Posture& place) const {
    return place.miss_mm() <= options_.tolerance_mm;
  }

 private:
  [[nodiscard]] Posture at(const Eigen::VectorXd& encoder_rad);
  /// Where a step with this damping leads; all limits kept.
  [[nodiscard]] Eigen::VectorXd stepped(const Posture& place, double damping) const;
  /// A posture beside one where no joint brings the tip nearer at once.
  [[nodiscard]] Eigen::VectorXd nudged(const Eigen::VectorXd& encoder_rad, int time) const;
  [[nodiscard]] double low(Eigen::Index i) const { return limits_.min_rad(i); }
  [[nodiscard]] double high(Eigen::Index i) const { return limits_.max_rad(i); }

  const ForwardKinematics& kinematics_;
  Eigen::Vector3d point_mm_;
  PostureSearchOptions options_;
  std::vector<Eigen::Index> joints_;
  JointLimits limits_;
  TipLinearisation workspace_;
};

Search::Search(const ForwardKinematics& kinematics, const Eigen::Vector3d& point_mm,
               const PostureSearchOptions& options)
    : kinematics_(kinematics), point_mm_(point_mm), options_(options), limits_(options.limits) {
  const int n = kinematics.joint_count();
  for (const int joint : options.joints) {
    ARMCAL_INVARIANT(1 <= joint && joint <= n);
    joints_.push_back(joint - 1);
  }
  if (joints_.empty()) {
    joints_.resize(static_cast<std::size_t>(n));
    std::iota(joints_.begin(), joints_.end(), 0);
  }
  if (limits_.min_rad.size() == 0) limits_.min_rad = Eigen::VectorXd::Constant(n, -HUGE_VAL);
  if (limits_.max_rad.size() == 0) limits_.max_rad = Eigen::VectorXd::Constant(n, HUGE_VAL);
}

Eigen::VectorXd Search::start(const Eigen::VectorXd& encoder_rad) const {
  const Eigen::VectorXd inside = brought_inside(encoder_rad, limits_);
  Eigen::VectorXd result = encoder_rad;
  for (const Eigen::Index i : joints_) result(i) = inside(i);
  return result;
}

Eigen::VectorXd Search::elsewhere(const Eigen::VectorXd& encoder_rad, int number) const {
  // Multiples of the powers of 1/phi, phi^(n+1) = phi + 1, fill a box of n sides evenly (the
  // R sequence, a Kronecker sequence).
  using std::numbers::pi;
  const double n = static_cast<double>(joints_.size());
  double phi = 1.5;
  for (int i = 0; i < 50; ++i) phi = std::pow(1.0 + phi, 1.0 / (n + 1.0));
  Eigen::VectorXd result = encoder_rad;
  double slope = 1.0;
  for (const Eigen::Index i : joints_) {
    slope /= phi;
    double whole = 0.0;
    const double part = std::modf(0.5 + slope * number, &whole);
    const bool has_stops = std::isfinite(low(i)) && std::isfinite(high(i));
    const double begin = has_stops ? low(i) : encoder_rad(i) - pi;
    const double end = has_stops ? high(i) : encoder_rad(i) + pi;
    result(i) = begin + part * (end - begin);
  }
  return start(result);
}

Posture Search::at(const Eigen::VectorXd& encoder_rad) {
  kinematics_.linearise(as_span(encoder_rad), workspace_);
  Posture place{encoder_rad, point_mm_ - workspace_.tip_mm,
                Eigen::Matrix3Xd::Zero(3, encoder_rad.size())};
  for (const Eigen::Index i : joints_) place.J_tip_joints.col(i) = workspace_.J_tip_encoder.col(i);
  return place;
}

// theory/kinematics.md eq. (14); joints that would pass a limit go to it and no further, and the
// others make up for what is missing then.
Eigen::VectorXd Search::stepped(const Posture& place, double damping) const {
  Eigen::Matrix3Xd jacobian = place.J_tip_joints;
  Eigen::Vector3d missing = place.missing_mm;
  Eigen::VectorXd held = Eigen::VectorXd::Zero(place.encoder_rad.size());  // steps up to limits
  for (;;) {
    Eigen::Matrix3d normal = jacobian * jacobian.transpose();
    normal.diagonal().array() += damping * place.missing_mm.squaredNorm();
    Eigen::VectorXd step = jacobian.transpose() * normal.ldlt().solve(missing);
    if (!step.allFinite()) step.setZero();
    const double largest = step.lpNorm<Eigen::Infinity>();
    if (largest > options_.largest_step_rad) step *= options_.largest_step_rad / largest;
    bool all_inside = true;
    for (const Eigen::Index i : joints_) {
      const double wanted = place.encoder_rad(i) + step(i);
      if (step(i) == 0.0 || (low(i) <= wanted && wanted <= high(i))) continue;
      held(i) = std::clamp(wanted, low(i), high(i)) - place.encoder_rad(i);
      missing -= jacobian.col(i) * held(i);
      jacobian.col(i).setZero();
      all_inside = false;
    }
    if (!all_inside) continue;
    Eigen::VectorXd result = place.encoder_rad + step + held;
    for (const Eigen::Index i : joints_) result(i) = std::clamp(result(i), low(i), high(i));
    return result;
  }
}

Eigen::VectorXd Search::nudged(const Eigen::VectorXd& encoder_rad, int time) const {
  Eigen::VectorXd result = encoder_rad;
  double side = time % 2 == 0 ? 0.1 : -0.1;
  for (const Eigen::Index i : joints_) {
    result(i) = std::clamp(result(i) + side, low(i), high(i));
    side *= -0.7;
  }
  return result;
}

// Whether a way down still leads anywhere.
class Progress {
 public:
  explicit Progress(const Posture& start) : miss_before_mm_(start.miss_mm()) {}

  [[nodiscard]] bool has_ended(const Posture& here, const Posture& next) {
    constexpr double kNoSlope = 1e-6;  // rad from where nothing brings the tip nearer
    constexpr double kNoMotion_rad = 1e-12;
    // Also at the edge of reach, where the root is double, the miss halves with every step: one
    // that has not fallen by a hundredth in eight will not vanish.
    constexpr int kPatience = 8;
    constexpr double kHardly = 0.99;
    if (here.slope() < kNoSlope) return true;
    if ((next.encoder_rad - here.encoder_rad).norm() < kNoMotion_rad) return true;
    if (++steps_ % kPatience != 0) return false;
    const bool hardly_fell = here.miss_mm() > kHardly * miss_before_mm_;
    miss_before_mm_ = here.miss_mm();
    return hardly_fell;
  }

 private:
  double miss_before_mm_;
  int steps_ = 0;
};

Posture Search::descended(const Eigen::VectorXd& encoder_rad) {
  constexpr int kNudges = 3;
  constexpr double kLeastDamping = 1e-3;
  Posture here = at(encoder_rad);
  Posture nearest = here;
  Progress progress(here);
  double damping = 1.0;
  int nudges = 0;
  for (int i = 0; i < options_.max_iterations && !has_arrived(here); ++i) {
    Posture next = at(stepped(here, damping));
    if (progress.has_ended(here, next)) {
      // Out of reach; or stretched straight at a point that asks to be folded: try beside.
      if (nudges == kNudges) break;
      here = at(nudged(nearest.encoder_rad, nudges++));
      progress = Progress(here);
      damping = 1.0;
    } else if (next.miss_mm() < here.miss_mm()) {
      here = std::move(next);
      damping = std::max(damping / 4.0, kLeastDamping);
    } else {
      damping *= 4.0;
    }
    if (here.miss_mm() < nearest.miss_mm()) nearest = here;
  }
  return nearest;
}

}  // namespace

JointLimits joint_limits(const ArmModel& arm) {
  JointLimits limits{Eigen::VectorXd(arm.joint_count()), Eigen::VectorXd(arm.joint_count())};
  for (int i = 0; i < arm.joint_count(); ++i) {
    limits.min_rad(i) = arm.joints[static_cast<std::size_t>(i)].min_rad;
    limits.max_rad(i) = arm.joints[static_cast<std::size_t>(i)].max_rad;
  }
  return limits;
}

Eigen::VectorXd brought_inside(const Eigen::VectorXd& encoder_rad, const JointLimits& limits) {
  constexpr double kTurn_rad = 2.0 * std::numbers::pi;
  Eigen::VectorXd inside = encoder_rad;
  for (Eigen::Index i = 0; i < inside.size(); ++i) {
    const double low = limits.min_rad(i);
    const double high = limits.max_rad(i);
    if (inside(i) < low) inside(i) += kTurn_rad * std::ceil((low - inside(i)) / kTurn_rad);
    if (inside(i) > high) inside(i) -= kTurn_rad * std::ceil((inside(i) - high) / kTurn_rad);
    if (inside(i) < low) {
      // No whole turn fits. The reading is now one turn or less below the lower limit.
      const double below = low - inside(i);
      const double above = inside(i) + kTurn_rad - high;
      inside(i) = below < above ? low : high;
    }
  }
  return inside;
}

PostureSearch find_posture(const ForwardKinematics& kinematics, const Eigen::Vector3d& point_mm,
                           const Eigen::VectorXd& start_rad, const PostureSearchOptions& options) {
  Search search(kinematics, point_mm, options);
  Posture nearest = search.descended(search.start(start_rad));
  for (int i = 1; i <= options.restarts && !search.has_arrived(nearest); ++i) {
    Posture other = search.descended(search.elsewhere(start_rad, i));
    if (other.miss_mm() < nearest.miss_mm()) nearest = std::move(other);
  }
  return {search.has_arrived(nearest), nearest.encoder_rad, nearest.miss_mm()};
}

}  // namespace armcal
