// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/dh_table.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "armcal/arm/encoder.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/diagnostics.h"
#include "armcal/core/invariant.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// Beyond this a table of doubles holds the tip no longer to 1e-10 mm.
constexpr double kLargestOffset_mm = 1e5;
// Axes that differ by rounding only count as parallel: over 10 m this moves nothing by more than
// 1e-11 mm.
constexpr double kParallel_rad = 1e-15;

RigidTransform turn(const Eigen::Vector3d& axis, double angle) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Eigen::Vector3d::Zero()};
}

RigidTransform shift(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), {x, y, z}};
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

RigidTransform step(DhConvention convention, const DhRow& row, double q_rad) {
  const RigidTransform joint = turn(kZ, q_rad + row.theta_rad) * shift(0, 0, row.d_mm);
  const RigidTransform link = shift(row.a_mm, 0, 0) * turn(kX, row.alpha_rad);
  return convention == DhConvention::classic ? joint * link : link * joint;
}

Tip tip_at(const RigidTransform& joint_from_tip) {
  Tip tip;
  tip.a_mm = joint_from_tip.translation_mm.x();
  tip.b_mm = joint_from_tip.translation_mm.y();
  tip.d_mm = joint_from_tip.translation_mm.z();
  tip.roll_pitch_yaw_rad = roll_pitch_yaw_from_rotation(joint_from_tip.rotation);
  return tip;
}

// The z axis of `frame` counts as joint axis; carries the frame to the next axis along the common
// normal and tells how.
DhRow row_and_next_frame(RigidTransform& frame, const Eigen::Vector3d& next_origin,
                         const Eigen::Vector3d& next_axis, int joint) {
  const Eigen::Vector3d x = frame.rotation.col(0);
  const Eigen::Vector3d z = frame.rotation.col(2);
  const Eigen::Vector3d between = next_origin - frame.translation_mm;
  const Eigen::Vector3d cross = z.cross(next_axis);
  const double sine = cross.norm();

  Eigen::Vector3d normal;
  DhRow row;
  Eigen::Vector3d foot_on_next;
  if (sine <= kParallel_rad) {
    // Any common perpendicular will do: that at the current origin, d = 0.
    const Eigen::Vector3d across = between - z * z.dot(between);
    normal = across.norm() > 1e-12 ? Eigen::Vector3d(across.normalized()) : x;
    foot_on_next = frame.translation_mm + across;
  } else {
    normal = cross / sine;
    if (normal.dot(x) < -1e-9) normal = -normal;  // the smaller turn about z
    row.d_mm = between.cross(next_axis).dot(cross) / (sine * sine);
    foot_on_next = next_origin + next_axis * (between.cross(z).dot(cross) / (sine * sine));
  }
  row.a_mm = normal.dot(between);
  row.alpha_rad = std::atan2(z.cross(next_axis).dot(normal), z.dot(next_axis));
  row.theta_rad = std::atan2(x.cross(normal).dot(z), x.dot(normal));
  if (std::abs(row.d_mm) > kLargestOffset_mm) {
    throw NumericalError(fmt::format(
        "axes {} and {} are {:.3g} deg from parallel: a D-H table would need an offset of {:.3g} m "
        "and "
        "lose its digits; keep the arm file, whose beta describes such axes",
        joint, joint + 1, degrees_from_radians(sine), metres_from_millimetres(row.d_mm)));
  }
  frame.rotation.col(0) = normal;
  frame.rotation.col(1) = next_axis.cross(normal);
  frame.rotation.col(2) = next_axis;
  frame.translation_mm = foot_on_next;
  return row;
}

bool is_plain(const ArmModel& arm) {
  for (const Joint& joint : arm.joints) {
    if (joint.direction != 1) return false;
  }
  for (const Link& link : arm.links) {
    if (link.b_mm != 0.0 || link.beta_rad != 0.0) return false;
  }
  return true;
}

// Classic table by copying numbers: possible when no link has b or beta.
DhTable copied(const ArmModel& arm) {
  DhTable table;
  table.base_from_first = arm.base_from_first_joint;
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    const Link& link = arm.links[i];
    table.rows.push_back({arm.joints[i].zero_rad, link.d_mm, link.a_mm, link.alpha_rad});
  }
  table.rows.push_back({arm.joints.back().zero_rad, 0.0, 0.0, 0.0});
  table.last_from_tool = {rotation_from_roll_pitch_yaw(arm.tip.roll_pitch_yaw_rad),
                          {arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm}};
  return table;
}

// Classic table by common normals between the axes, all taken at readings 0.
DhTable by_common_normals(const ArmModel& arm) {
  ArmModel ideal = arm;
  for (Joint& joint : ideal.joints) joint.harmonics.clear();
  const ForwardKinematics kinematics(ideal);
  const std::vector<double> zeros(arm.joints.size(), 0.0);
  const TipLinearisation at = kinematics.linearise(zeros);
  const auto axis = [&](std::size_t joint) -> Eigen::Vector3d {
    return arm.joints[joint].direction * at.joint_axes.col(static_cast<Eigen::Index>(joint));
  };

  DhTable table;
  RigidTransform frame = arm.base_from_first_joint;
  // A joint that counts backwards is one that counts forwards about the opposite axis.
  if (arm.joints[0].direction < 0) frame = frame * turn(kX, std::numbers::pi);
  table.base_from_first = frame;
  for (std::size_t i = 0; i + 1 < arm.joints.size(); ++i) {
    const Eigen::Vector3d origin = at.joint_origins_mm.col(static_cast<Eigen::Index>(i + 1));
    table.rows.push_back(row_and_next_frame(frame, origin, axis(i + 1), static_cast<int>(i + 1)));
  }
  table.rows.push_back({});
  table.last_from_tool = frame.inverse() * kinematics.base_from_tip(zeros);
  return table;
}

// What the last row can say of the tool goes into it, so that a table comes back as it was.
void move_tool_into_last_row(DhTable& table) {
  RigidTransform& tool = table.last_from_tool;
  DhRow& last = table.rows.back();
  const Eigen::Vector3d angles = roll_pitch_yaw_from_rotation(tool.rotation);
  if (table.convention == DhConvention::classic) {
    const bool fits = tool.translation_mm.y() == 0.0 && angles.y() == 0.0 && angles.z() == 0.0;
    if (!fits) return;
    last.d_mm += tool.translation_mm.z();
    last.a_mm = tool.translation_mm.x();
    last.alpha_rad = angles.x();
    tool = {};
  } else if (tool.translation_mm.x() == 0.0 && tool.translation_mm.y() == 0.0) {
    last.d_mm += tool.translation_mm.z();
    tool.translation_mm.setZero();
  }
}

// Common normals leave rounding in the table, -4.6e-14 mm where 0 is meant. A femtometre is far
// below what a pose keeps.
double rounded_to_femtometres(double mm) {
  constexpr double kExact_mm = 4000.0;  // beyond, a double has no femtometres
  return std::abs(mm) < kExact_mm ? std::round(mm * 1e12) / 1e12 + 0.0 : mm;
}

void drop_rounding(DhTable& table) {
  for (DhRow& row : table.rows) {
    row.d_mm = rounded_to_femtometres(row.d_mm);
    row.a_mm = rounded_to_femtometres(row.a_mm);
  }
  for (RigidTransform* pose : {&table.base_from_first, &table.last_from_tool}) {
    pose->translation_mm = pose->translation_mm.unaryExpr(&rounded_to_femtometres);
  }
}

}  // namespace

std::string_view to_string(DhConvention convention) {
  return convention == DhConvention::classic ? "classic" : "modified";
}

RigidTransform base_from_tool(const DhTable& table, std::span<const double> q_rad) {
  ARMCAL_INVARIANT(q_rad.size() == table.rows.size());
  RigidTransform pose = table.base_from_first;
  for (std::size_t i = 0; i < q_rad.size(); ++i) {
    pose = pose * step(table.convention, table.rows[i], q_rad[i]);
  }
  return pose * table.last_from_tool;
}

ArmModel arm_from_dh(const DhTable& table) {
  ARMCAL_INVARIANT(!table.rows.empty());
  ArmModel arm;
  arm.name = table.name;
  arm.note = table.note;
  for (const DhRow& row : table.rows) {
    arm.joints.emplace_back();
    arm.joints.back().zero_rad = row.theta_rad;
  }
  const bool classic = table.convention == DhConvention::classic;
  for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
    const DhRow& across = classic ? table.rows[i] : table.rows[i + 1];
    arm.links.push_back({table.rows[i].d_mm, 0.0, across.a_mm, across.alpha_rad, 0.0});
  }
  const DhRow& first = table.rows.front();
  const DhRow& last = table.rows.back();
  if (classic) {
    arm.base_from_first_joint = table.base_from_first;
    arm.tip =
        tip_at(shift(last.a_mm, 0, last.d_mm) * turn(kX, last.alpha_rad) * table.last_from_tool);
  } else {
    arm.base_from_first_joint =
        table.base_from_first * turn(kX, first.alpha_rad) * shift(first.a_mm, 0, 0);
    arm.tip = tip_at(shift(0, 0, last.d_mm) * table.last_from_tool);
  }
  return arm;
}

DhConversion dh_from_arm(const ArmModel& arm, DhConvention convention) {
  DhConversion conversion;
  const bool plain = is_plain(arm);
  conversion.table = plain ? copied(arm) : by_common_normals(arm);
  if (!plain) drop_rounding(conversion.table);
  DhTable& table = conversion.table;
  table.name = arm.name;
  table.note = arm.note;
  table.convention = convention;
  if (convention == DhConvention::modified) {
    // The same product of elementary steps, cut one step later.
    for (std::size_t i = table.rows.size() - 1; i > 0; --i) {
      table.rows[i].a_mm = table.rows[i - 1].a_mm;
      table.rows[i].alpha_rad = table.rows[i - 1].alpha_rad;
    }
    table.rows[0].a_mm = 0.0;
    table.rows[0].alpha_rad = 0.0;
  }
  move_tool_into_last_row(table);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    if (!joint.harmonics.empty()) {
      conversion.lost.push_back(fmt::format("encoder harmonics of joint {}", i + 1));
    }
    if (std::isfinite(joint.min_rad) || std::isfinite(joint.max_rad)) {
      conversion.lost.push_back(fmt::format("limits of joint {}", i + 1));
    }
  }
  return conversion;
}

}  // namespace armcal
