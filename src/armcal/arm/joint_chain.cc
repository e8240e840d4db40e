// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/joint_chain.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "armcal/core/invariant.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// Within this of parallel a link is expressed with beta, as `wanted_order` wants it.
// What rounding leaves where 0 is meant. At a reach of 10 m neither moves the tip by 1e-10 mm.
constexpr double kRoundingAngle_rad = 1e-15;
constexpr double kRoundingLength_mm = 1e-12;
// Axes nearer than a nanometre count as meeting: the direction from one to the other means nothing.
constexpr double kMeeting_mm = 1e-6;

double angle_without_rounding(double rad) { return std::abs(rad) < kRoundingAngle_rad ? 0.0 : rad; }

double length_without_rounding(double mm) { return std::abs(mm) < kRoundingLength_mm ? 0.0 : mm; }

RigidTransform turned(const Eigen::Matrix3d& rotation) {
  return {rotation, Eigen::Vector3d::Zero()};
}

struct Alignment {
  Eigen::Matrix3d joint_from_aligned;  // its z axis is the joint's, up to the sign
  int direction;                       // of the count about that z axis
};

// The smallest turn that brings z onto the axis, or onto its opposite where that is near.
Alignment alignment(const Eigen::Vector3d& axis_in_joint) {
  const int direction = axis_in_joint.z() < -0.5 ? -1 : 1;
  const Eigen::Vector3d axis = direction * axis_in_joint;
  const Eigen::Matrix3d v = skew(Eigen::Vector3d::UnitZ().cross(axis));
  return {Eigen::Matrix3d::Identity() + v + v * v / (1.0 + axis.z()), direction};
}

// Direction, across the axis z, that the x axis of a joint's frame shall have before a step to the
// frame of the next; it is now at angle `now_rad`.
Eigen::Vector2d wanted_x(const RigidTransform& step, double now_rad) {
  const Eigen::Vector3d next_axis = step.rotation.col(2);
  const Eigen::Vector2d now(std::cos(now_rad), std::sin(now_rad));
  const double sine = next_axis.head<2>().norm();
  const double across_mm = step.translation_mm.head<2>().norm();
  Eigen::Vector2d x = now;
  if (sine >= std::sin(kNearlyParallel_rad)) {
    x = Eigen::Vector2d(-next_axis.y(), next_axis.x()) / sine;  // z cross next_axis: beta = 0
  } else if (across_mm > kMeeting_mm) {
    x = step.translation_mm.head<2>() / across_mm;  // towards the next axis: b = 0
  }
  return x.dot(now) < -1e-9 ? Eigen::Vector2d(-x) : x;  // the smaller turn
}

struct LinkStep {
  double turn_rad;  // of the joint, before the link
  Link link;
  double x_at_rad;  // where the x axis of the new frame stands in the frame that the chain has
};

// RotZ(-x_at) step = RotZ(turn) TransZ(d) TransY(b) TransX(a) RotX(alpha) RotY(beta) RotZ(-x_at'),
// theory/kinematics.md eq. (13)
LinkStep link_step(const RigidTransform& step, double x_at_rad) {
  const Eigen::Vector2d x = wanted_x(step, x_at_rad);
  const Eigen::Vector2d now(std::cos(x_at_rad), std::sin(x_at_rad));
  LinkStep result;
  result.turn_rad =
      angle_without_rounding(std::atan2(now.x() * x.y() - now.y() * x.x(), x.dot(now)));
  const RigidTransform rest = turned(rotation_about_z(-x_at_rad - result.turn_rad)) * step;
  const Eigen::Vector3d axis = rest.rotation.col(2);  // = (sin b, -sin a cos b, cos a cos b)
  Link& link = result.link;
  link.a_mm = length_without_rounding(rest.translation_mm.x());
  link.b_mm = length_without_rounding(rest.translation_mm.y());
  link.d_mm = length_without_rounding(rest.translation_mm.z());
  link.beta_rad = angle_without_rounding(std::atan2(axis.x(), std::hypot(axis.y(), axis.z())));
  link.alpha_rad = angle_without_rounding(std::atan2(0.0 - axis.y(), axis.z()));
  const Eigen::Matrix3d left = rest.rotation.transpose() * twist(link);
  result.x_at_rad = angle_without_rounding(std::atan2(left(1, 0), left(0, 0)));
  return result;
}

RigidTransform pose_of(const Tip& tip) {
  return {rotation_from_roll_pitch_yaw(tip.roll_pitch_yaw_rad), {tip.a_mm, tip.b_mm, tip.d_mm}};
}

Tip rounded_tip_at(const RigidTransform& last_from_tip) {
  const Eigen::Vector3d p = last_from_tip.translation_mm.unaryExpr(&length_without_rounding);
  const Eigen::Vector3d angles = roll_pitch_yaw_from_rotation(last_from_tip.rotation);
  return {p.x(), p.y(), p.z(), angles.unaryExpr(&angle_without_rounding)};
}

}  // namespace

RigidTransform base_from_tip(const JointChain& chain, std::span<const double> q_rad) {
  ARMCAL_INVARIANT(q_rad.size() == chain.joints.size());
  RigidTransform pose;
  for (std::size_t i = 0; i < q_rad.size(); ++i) {
    const ChainJoint& joint = chain.joints[i];
    const Eigen::AngleAxisd turn(q_rad[i], joint.axis_in_joint);
    pose = pose * joint.parent_from_joint * turned(turn.toRotationMatrix());
  }
  return pose * chain.last_from_tip;
}

ArmModel arm_from_chain(const JointChain& chain) {
  ARMCAL_INVARIANT(!chain.joints.empty());
  ArmModel arm;
  arm.name = chain.name;
  arm.note = chain.note;
  Alignment here = alignment(chain.joints[0].axis_in_joint);
  arm.base_from_first_joint = chain.joints[0].parent_from_joint * turned(here.joint_from_aligned);
  double x_at_rad = 0.0;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const bool is_last = i + 1 == chain.joints.size();
    const RigidTransform after =
        is_last ? chain.last_from_tip : chain.joints[i + 1].parent_from_joint;
    RigidTransform step = turned(here.joint_from_aligned.transpose()) * after;
    Joint& joint = arm.joints.emplace_back();
    joint.direction = here.direction;
    joint.min_rad = chain.joints[i].min_rad;
    joint.max_rad = chain.joints[i].max_rad;
    if (is_last) {
      joint.zero_rad = 0.0 - here.direction * x_at_rad;
      arm.tip = rounded_tip_at(step);
      break;
    }
    const Alignment next = alignment(chain.joints[i + 1].axis_in_joint);
    step = step * turned(next.joint_from_aligned);
    const LinkStep link = link_step(step, x_at_rad);
    joint.zero_rad = 0.0 + here.direction * link.turn_rad;
    arm.links.push_back(link.link);
    x_at_rad = link.x_at_rad;
    here = next;
  }
  return arm;
}

ChainConversion chain_from_arm(const ArmModel& arm) {
  ChainConversion result;
  JointChain& chain = result.chain;
  chain.name = arm.name;
  chain.note = arm.note;
  RigidTransform before = arm.base_from_first_joint;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    ChainJoint& out = chain.joints.emplace_back();
    out.parent_from_joint = before * turned(rotation_about_z(joint.direction * joint.zero_rad));
    out.axis_in_joint = {0.0, 0.0, static_cast<double>(joint.direction)};
    out.min_rad = joint.min_rad;
    out.max_rad = joint.max_rad;
    if (!joint.harmonics.empty()) {
      result.lost.push_back(fmt::format("encoder harmonics of joint {}", i + 1));
    }
    if (i == arm.links.size()) break;
    const Link& link = arm.links[i];
    before = {twist(link), {link.a_mm, link.b_mm, link.d_mm}};
  }
  chain.last_from_tip = pose_of(arm.tip);
  return result;
}

}  // namespace armcal
