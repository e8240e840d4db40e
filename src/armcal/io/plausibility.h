// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/toml_value.h"

namespace armcal {

/// No arm reaches a kilometre: what is longer is a slip of the keyboard or of the unit.
inline constexpr double kLongestLength_mm = 1e6;

/// An error at `where` for a length that is not finite or longer than that. Returns the length.
double checked_length(double length_mm, std::string_view key, const SourcePosition& where,
                      Diagnostics& diagnostics);

/// A length of a section, 0 where it is missing, checked.
double length_or_zero(TomlSection& section, std::string_view key, Diagnostics& diagnostics);

/// Do angles that are said to be degrees look like radians: none beyond 3.2, and one of them a
/// quarter or half turn in radians (1.57, 3.1416)?
[[nodiscard]] bool look_like_radians(std::span<const double> degrees);

/// A warning at `where` if they do. @param what  "the values of alpha_deg"
void warn_of_radians(std::span<const double> degrees, std::string_view what,
                     const SourcePosition& where, Diagnostics& diagnostics);

}  // namespace armcal
