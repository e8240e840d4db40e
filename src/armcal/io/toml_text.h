// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace armcal {

// Values of the TOML files that the program writes; `toml_quoted` is with its reader, toml_value.h.

/// ["a*", "b7"]
[[nodiscard]] std::string toml_list(const std::vector<std::string>& texts);

/// [0.0, -90.0], in degrees that read back as the same radians
[[nodiscard]] std::string toml_degrees(const Eigen::VectorXd& angles_rad);

/// An amount of a parameter of an arm, with the unit in the key: a7_mm = 50.0, zero3_deg = 0.5
/// @param value  mm or rad
[[nodiscard]] std::string toml_parameter(const std::string& name, double value);

/// Is the parameter of this name (arm/parameter_table.h) an angle?
[[nodiscard]] bool is_angle_parameter(const std::string& name);

}  // namespace armcal
