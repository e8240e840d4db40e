// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/arm_from_axes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "armcal/arm/encoder.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/invariant.h"
#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// As in `wanted_order`.
constexpr double kAlongAxis_rad = radians_from_degrees(10.0);

double angle_of(const Eigen::Vector3d& v) { return std::atan2(v.y(), v.x()); }

// The same angle but for whole turns.
double nearest_to(double wanted_rad, double angle_rad) {
  return wanted_rad + std::remainder(angle_rad - wanted_rad, 2.0 * std::numbers::pi);
}

// Origins on the axes, from the tip down, so that every d is the pattern's. eq. (14)
std::vector<Eigen::Vector3d> origins_on_axes(const ArmModel& pattern, const AxesAtPosture& at) {
  std::vector<Eigen::Vector3d> origins(at.axes.size());
  Eigen::Vector3d next = at.tip_mm;
  double d_mm = pattern.tip.d_mm;
  for (std::size_t i = at.axes.size(); i-- > 0;) {
    const auto& [point, direction] = at.axes[i];
    origins[i] = point + (direction.dot(next - point) - d_mm) * direction;
    next = origins[i];
    if (i > 0) d_mm = pattern.links[i - 1].d_mm;
  }
  return origins;
}

struct LinkTurn {
  double angle_rad;  // of the joint
  double alpha_rad, beta_rad;
};

/// @param axis         the next one, in the frame of this joint before its turn
/// @param pattern_rad  angle of the joint in the pattern
std::optional<LinkTurn> turn_onto(const Eigen::Vector3d& axis, const Link& pattern,
                                  double pattern_rad) {
  if (is_nearly_parallel(pattern)) {  // eq. (16)
    const Eigen::Vector3d turned = rotation_about_z(-pattern_rad) * axis;
    const double beta = std::atan2(turned.x(), std::hypot(turned.y(), turned.z()));
    const double alpha = std::atan2(-turned.y(), turned.z());
    return LinkTurn{pattern_rad, nearest_to(pattern.alpha_rad, alpha), beta};
  }
  const double cosine = axis.z() / std::cos(pattern.beta_rad);  // eq. (15)
  if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
  const double alpha = std::copysign(std::acos(cosine), std::sin(pattern.alpha_rad));
  const Eigen::Vector3d before_turn(std::sin(pattern.beta_rad),
                                    -std::sin(alpha) * std::cos(pattern.beta_rad), 0.0);
  return LinkTurn{angle_of(axis) - angle_of(before_turn), nearest_to(pattern.alpha_rad, alpha),
                  pattern.beta_rad};
}

// Frame of the first joint before its turn, so that its angle is the pattern's.
std::optional<Eigen::Matrix3d> first_frame(const ArmModel& pattern, double angle_rad,
                                           const std::vector<Eigen::Vector3d>& origins,
                                           const AxesAtPosture& at) {
  const Eigen::Vector3d& axis = at.axes[0].direction;
  const auto [x, y] = perpendicular_pair(axis);
  Eigen::Matrix3d frame;
  frame << x, y, axis;
  const Link& link = pattern.links[0];
  if (is_nearly_parallel(link)) {
    const Eigen::Vector3d step = frame.transpose() * (origins[1] - origins[0]);
    const double wanted = std::atan2(link.b_mm, link.a_mm) + angle_rad;
    return frame * rotation_about_z(angle_of(step) - wanted);
  }
  const auto turn = turn_onto(frame.transpose() * at.axes[1].direction, link, angle_rad);
  if (!turn) return std::nullopt;
  return frame * rotation_about_z(turn->angle_rad - angle_rad);
}

}  // namespace

AxesAtPosture axes_at(const ArmModel& arm, const Eigen::VectorXd& encoder_rad) {
  const TipLinearisation at = ForwardKinematics(arm).linearise(as_span(encoder_rad));
  AxesAtPosture result{{}, at.tip_mm, encoder_rad};
  for (Eigen::Index i = 0; i < encoder_rad.size(); ++i) {
    result.axes.push_back({at.joint_origins_mm.col(i), at.joint_axes.col(i)});
  }
  return result;
}

std::optional<ArmFromAxes> arm_from_axes(const ArmModel& pattern, const AxesAtPosture& at) {
  const std::size_t joints = pattern.joints.size();
  ARMCAL_INVARIANT(at.axes.size() == joints);
  ARMCAL_INVARIANT(at.encoder_rad.size() == pattern.joint_count());
  const auto pattern_angle = [&](std::size_t i) {
    return joint_angle(pattern.joints[i], at.encoder_rad(static_cast<Eigen::Index>(i)));
  };
  const std::vector<Eigen::Vector3d> origins = origins_on_axes(pattern, at);
  const auto first = first_frame(pattern, pattern_angle(0), origins, at);
  if (!first) return std::nullopt;
  ArmFromAxes result{pattern, {}};
  result.frame_from_base =
      RigidTransform{*first, origins[0]} * pattern.base_from_first_joint.inverse();
  Eigen::Matrix3d frame = *first;
  for (std::size_t i = 0; i + 1 < joints; ++i) {
    Link& link = result.arm.links[i];
    Joint& joint = result.arm.joints[i];
    const double here = pattern_angle(i);
    const auto turn = turn_onto(frame.transpose() * at.axes[i + 1].direction, link, here);
    if (!turn) return std::nullopt;
    // The reading stays, so a change of the angle is one of the zero. zero1 stays but for rounding.
    if (i > 0) {
      joint.zero_rad +=
          joint.direction * std::remainder(turn->angle_rad - here, 2.0 * std::numbers::pi);
    }
    link.alpha_rad = turn->alpha_rad;
    link.beta_rad = turn->beta_rad;
    frame = frame * rotation_about_z(turn->angle_rad);
    const Eigen::Vector3d step = frame.transpose() * (origins[i + 1] - origins[i]);
    link.a_mm = step.x();
    link.b_mm = step.y();
    frame = frame * twist(link);
  }
  frame = frame * rotation_about_z(pattern_angle(joints - 1));
  const Eigen::Vector3d tip = frame.transpose() * (at.tip_mm - origins.back());
  result.arm.tip.a_mm = tip.x();
  result.arm.tip.b_mm = tip.y();
  return result;
}

}  // namespace armcal
