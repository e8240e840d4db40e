// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/forward_kinematics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "armcal/arm/encoder.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {

// The frame that is carried from base to tip: origin and three axes in base coordinates.
struct ForwardKinematics::Sweep {
  Eigen::Vector3d origin, x, y, z;

  void turn_about_z(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Eigen::Vector3d turned = c * x + s * y;
    y = c * y - s * x;
    x = turned;
  }
  void turn_about_x(double c, double s) {
    const Eigen::Vector3d turned = c * y + s * z;
    z = c * z - s * y;
    y = turned;
  }
  void turn_about_y(double c, double s) {
    const Eigen::Vector3d turned = c * x - s * z;
    z = s * x + c * z;
    x = turned;
  }
  void shift(double along_x, double along_y, double along_z) {
    origin += along_x * x + along_y * y + along_z * z;
  }
};

ForwardKinematics::ForwardKinematics(const ArmModel& arm)
    : joint_count_(arm.joint_count()), parameter_count_(ParameterTable(arm).size()), arm_(arm) {
  const auto problems = problems_of(arm);
  if (!problems.empty()) {
    throw std::invalid_argument(fmt::format("arm \"{}\": {}", arm.name, fmt::join(problems, "; ")));
  }
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    joints_[i] = {joint.zero_rad, static_cast<double>(joint.direction), !joint.harmonics.empty()};
  }
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    const Link& link = arm.links[i];
    links_[i] = {link.d_mm,
                 link.b_mm,
                 link.a_mm,
                 std::cos(link.alpha_rad),
                 std::sin(link.alpha_rad),
                 std::cos(link.beta_rad),
                 std::sin(link.beta_rad),
                 link.beta_rad != 0.0};
  }
  joint_from_tip_rotation_ = rotation_from_roll_pitch_yaw(arm.tip.roll_pitch_yaw_rad);
}

double ForwardKinematics::angle(std::size_t joint, double encoder_rad) const {
  const PreparedJoint& prepared = joints_[joint];
  if (prepared.has_harmonics) return joint_angle(arm_.joints[joint], encoder_rad);
  return prepared.direction * (encoder_rad + prepared.zero);
}

ForwardKinematics::Sweep ForwardKinematics::sweep_to_last_joint(
    std::span<const double> encoder_rad) const {
  ARMCAL_INVARIANT(static_cast<int>(encoder_rad.size()) == joint_count_);
  const RigidTransform& base = arm_.base_from_first_joint;
  Sweep frame{base.translation_mm, base.rotation.col(0), base.rotation.col(1),
              base.rotation.col(2)};
  const std::size_t last = encoder_rad.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const PreparedLink& link = links_[i];
    frame.turn_about_z(angle(i, encoder_rad[i]));
    frame.shift(link.a, link.b, link.d);
    frame.turn_about_x(link.cos_alpha, link.sin_alpha);
    if (link.has_beta) frame.turn_about_y(link.cos_beta, link.sin_beta);
  }
  frame.turn_about_z(angle(last, encoder_rad[last]));
  return frame;
}

Eigen::Vector3d ForwardKinematics::tip_in_base(std::span<const double> encoder_rad) const {
  Sweep frame = sweep_to_last_joint(encoder_rad);
  frame.shift(arm_.tip.a_mm, arm_.tip.b_mm, arm_.tip.d_mm);
  return frame.origin;
}

RigidTransform ForwardKinematics::base_from_tip(std::span<const double> encoder_rad) const {
  Sweep frame = sweep_to_last_joint(encoder_rad);
  frame.shift(arm_.tip.a_mm, arm_.tip.b_mm, arm_.tip.d_mm);
  Eigen::Matrix3d rotation;
  rotation << frame.x, frame.y, frame.z;
  return {rotation * joint_from_tip_rotation_, frame.origin};
}

TipLinearisation ForwardKinematics::linearise(std::span<const double> encoder_rad) const {
  TipLinearisation result;
  linearise(encoder_rad, result);
  return result;
}

void ForwardKinematics::linearise(std::span<const double> encoder_rad,
                                  TipLinearisation& result) const {
  ARMCAL_INVARIANT(static_cast<int>(encoder_rad.size()) == joint_count_);
  const std::size_t n = encoder_rad.size();
  const auto columns = static_cast<Eigen::Index>(n);
  result.J_tip_parameters.resize(3, parameter_count_);
  result.J_tip_encoder.resize(3, columns);
  result.joint_axes.resize(3, columns);
  result.joint_origins_mm.resize(3, columns);
  Eigen::Matrix3Xd& J = result.J_tip_parameters;

  // First sweep: everything that does not need the tip. A rotation's lever arm ends at the tip, so
  // until the tip is known the columns of alpha and beta hold the axis of rotation and that of the
  // zero the origin.
  const RigidTransform& base = arm_.base_from_first_joint;
  Sweep frame{base.translation_mm, base.rotation.col(0), base.rotation.col(1),
              base.rotation.col(2)};
  constexpr Eigen::Index kPerLink = 5;
  for (std::size_t i = 0; i < n; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    result.joint_axes.col(joint) = frame.z;
    result.joint_origins_mm.col(joint) = frame.origin;
    frame.turn_about_z(angle(i, encoder_rad[i]));
    const Eigen::Index column = columns + kPerLink * joint;
    if (i + 1 == n) {
      J.col(column) = frame.x;
      J.col(column + 1) = frame.y;
      J.col(column + 2) = frame.z;
      break;
    }
    const PreparedLink& link = links_[i];
    J.col(column) = frame.z;
    J.col(column + 1) = frame.y;
    J.col(column + 2) = frame.x;
    J.col(column + 3) = frame.x;
    frame.shift(link.a, link.b, link.d);
    frame.turn_about_x(link.cos_alpha, link.sin_alpha);
    J.col(column + 4) = frame.y;
    if (link.has_beta) frame.turn_about_y(link.cos_beta, link.sin_beta);
  }
  frame.shift(arm_.tip.a_mm, arm_.tip.b_mm, arm_.tip.d_mm);
  result.tip_mm = frame.origin;

  // Second sweep: lever arms.
  Eigen::Index harmonic_column = columns + kPerLink * (columns - 1) + 3;
  for (std::size_t i = 0; i < n; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d axis = result.joint_axes.col(joint);
    const Eigen::Vector3d lever = result.tip_mm - result.joint_origins_mm.col(joint);
    const Eigen::Vector3d by_angle = axis.cross(lever);
    const Joint& model = arm_.joints[i];
    J.col(joint) = joints_[i].direction * by_angle;
    result.J_tip_encoder.col(joint) = joint_angle_slope(model, encoder_rad[i]) * by_angle;
    double k = 1.0;
    for (std::size_t h = 0; h < model.harmonics.size(); ++h, k += 1.0, harmonic_column += 2) {
      J.col(harmonic_column) = std::cos(k * encoder_rad[i]) * by_angle;
      J.col(harmonic_column + 1) = std::sin(k * encoder_rad[i]) * by_angle;
    }
    if (i == 0) continue;
    const Eigen::Index alpha = columns + kPerLink * (joint - 1) + 3;
    J.col(alpha) = Eigen::Vector3d(J.col(alpha)).cross(lever);
    J.col(alpha + 1) = Eigen::Vector3d(J.col(alpha + 1)).cross(lever);
  }
}

std::vector<Eigen::Vector3d> tips_in_base(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad) {
  const ForwardKinematics kinematics(arm);
  std::vector<Eigen::Vector3d> tips_mm;
  for (Eigen::Index i = 0; i < encoder_rad.cols(); ++i) {
    tips_mm.push_back(kinematics.tip_in_base(as_span(encoder_rad.col(i))));
  }
  return tips_mm;
}

}  // namespace armcal
