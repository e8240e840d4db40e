// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/arm_state.h"

#include <Eigen/Geometry>

#include "armcal/arm/encoder.h"
#include "armcal/core/invariant.h"

namespace armcal {
namespace {

Eigen::Matrix3d about(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

// What is not disturbed is not multiplied: a source that is off changes no digit.
void turn_by(RigidTransform& frame, const Eigen::Vector3d& small_rad) {
  if (!small_rad.isZero(0.0)) frame.rotation *= rotation_from_vector(small_rad);
}

}  // namespace

ArmState state_of(const ArmModel& arm, std::span<const double> encoder_rad) {
  ARMCAL_INVARIANT(encoder_rad.size() == arm.joints.size());
  ArmState state;
  state.base_from_first_joint = arm.base_from_first_joint;
  state.joints.resize(arm.joints.size());
  state.links.resize(arm.joints.size());
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    state.joints[i].angle_rad = joint_angle(arm.joints[i], encoder_rad[i]);
  }
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    const Link& link = arm.links[i];
    state.links[i].way_mm = {link.a_mm, link.b_mm, link.d_mm};
    state.links[i].alpha_rad = link.alpha_rad;
    state.links[i].beta_rad = link.beta_rad;
  }
  state.links.back().way_mm = {arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm};
  return state;
}

ArmFrames frames_of(const ArmState& state) {
  ArmFrames frames;
  frames.base_from_link.reserve(state.joints.size());
  RigidTransform frame = state.base_from_first_joint;
  for (std::size_t i = 0; i < state.joints.size(); ++i) {
    const JointState& joint = state.joints[i];
    const LinkState& link = state.links[i];
    frame.translation_mm += frame.rotation * joint.shift_mm;
    turn_by(frame, joint.tilt_rad);
    frame.rotation *= about(joint.angle_rad, Eigen::Vector3d::UnitZ());
    frames.base_from_link.push_back(frame);
    frame.translation_mm += frame.rotation * (link.way_mm + link.sag_mm);
    turn_by(frame, link.bend_rad);
    if (link.alpha_rad != 0.0) frame.rotation *= about(link.alpha_rad, Eigen::Vector3d::UnitX());
    if (link.beta_rad != 0.0) frame.rotation *= about(link.beta_rad, Eigen::Vector3d::UnitY());
  }
  frames.tip_mm = frame.translation_mm;
  return frames;
}

}  // namespace armcal
