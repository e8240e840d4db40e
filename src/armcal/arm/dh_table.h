// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// The two conventions in use, theory/kinematics.md eq. (10) and (11):
///   classic (Denavit, Hartenberg 1955; Paul):  RotZ(q + theta) TransZ(d) TransX(a) RotX(alpha) per
///   row modified (Craig):                          RotX(alpha) TransX(a) RotZ(q + theta) TransZ(d)
///   per row
enum class DhConvention { classic, modified };

[[nodiscard]] std::string_view to_string(DhConvention convention);

/// One row as printed in a table; in the modified convention a and alpha are those of the link
/// before.
struct DhRow {
  double theta_rad = 0.0;  ///< added to the joint's reading
  double d_mm = 0.0;
  double a_mm = 0.0;
  double alpha_rad = 0.0;
};

/// base_from_tool = base_from_first * (product of the rows) * last_from_tool
struct DhTable {
  DhConvention convention = DhConvention::classic;
  std::string name;
  std::string note;
  std::vector<DhRow> rows;  ///< one per joint
  RigidTransform base_from_first;
  RigidTransform last_from_tool;
};

/// Pose of the tool at joint readings `q`, straight from the definition of the convention.
[[nodiscard]] RigidTransform base_from_tool(const DhTable& table, std::span<const double> q_rad);

/// The same arm as a table of links. Exact: no number is computed but the pose of the tip.
[[nodiscard]] ArmModel arm_from_dh(const DhTable& table);

struct DhConversion {
  DhTable table;
  std::vector<std::string> lost;  ///< what a D-H table cannot say, in words: limits, harmonics
};

/// The same poses as a D-H table. Links with b or beta, and joints that count backwards, are
/// re-expressed by common normals between the axes (exact axes; the numbers of the table differ
/// from those of the arm).
/// @throws NumericalError where neighbouring axes are so close to parallel, but not parallel, that
/// their
///         common normal lies more than 100 m away and the table would lose its digits
[[nodiscard]] DhConversion dh_from_arm(const ArmModel& arm, DhConvention convention);

}  // namespace armcal
