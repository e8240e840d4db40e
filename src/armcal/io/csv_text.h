// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace armcal {

// Fields of the tables that the program writes. Numbers are rounded far below what any instrument
// shows and any calibration notices: lengths to 1e-8 mm, angles to 1e-10 deg (2e-12 rad, which is
// 2e-9 mm at the end of an arm of 1 m). So a text does not depend on the last digits of a
// computation.

/// "352.968"
[[nodiscard]] std::string length_field(double mm);
/// In degrees: "-90"
[[nodiscard]] std::string angle_field(double rad);
/// A name, in quotes where it would not survive without. @throws std::invalid_argument where it
/// holds what no table of ours can: a quotation mark, a semicolon, a tab, a line break
[[nodiscard]] std::string text_field(std::string_view text);

/// "q1_deg,q2_deg"
[[nodiscard]] std::string angle_header(Eigen::Index joint_count);
/// Angles in degrees, separated by commas.
[[nodiscard]] std::string angle_fields(const Eigen::VectorXd& angles_rad);
/// "x,y,z"
[[nodiscard]] std::string point_fields(const Eigen::Vector3d& point_mm);

}  // namespace armcal
