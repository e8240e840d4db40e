// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/symmetric_point/analysis.h"

namespace armcal {

/// A length (mm) or an angle (rad) of the symmetric-point procedure as people read it: mm, deg.
[[nodiscard]] double shown_amount(double value, bool is_angle);
[[nodiscard]] const char* unit_of_amount(bool is_angle);
/// The same as text; 4 decimals are 0.1 um and 0.36 arcsec.
[[nodiscard]] std::string amount(double value, bool is_angle, int decimals = 4);

/// Is the parameter of this name an angle?
[[nodiscard]] bool is_angle_parameter(const SymmetricPointAnalysis& analysis,
                                      const std::string& name);

/// "a5, b3 and b5"
[[nodiscard]] std::string joined_names(const std::vector<std::string>& names);

}  // namespace armcal
