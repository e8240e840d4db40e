// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armcal {

double checked_length(double length_mm, std::string_view key, const SourcePosition& where,
                      Diagnostics& diagnostics) {
  if (!(std::abs(length_mm) <= kLongestLength_mm)) {
    diagnostics.error(where, fmt::format("{} is {} mm: longer than a kilometre", key, length_mm),
                      "lengths are in mm");
  }
  return length_mm;
}

double length_or_zero(TomlSection& section, std::string_view key, Diagnostics& diagnostics) {
  const auto length = section.number(key);
  return length ? checked_length(*length, key, section.where(key), diagnostics) : 0.0;
}

bool look_like_radians(std::span<const double> degrees) {
  // 1.57 and 3.14 are what people write.
  constexpr double kRounding = 0.002;
  bool any_turn = false;
  for (const double angle : degrees) {
    const double size = std::abs(angle);
    if (size > 3.2) return false;
    any_turn = any_turn || std::abs(size - std::numbers::pi / 2) < kRounding ||
               std::abs(size - std::numbers::pi) < kRounding;
  }
  return any_turn;
}

void warn_of_radians(std::span<const double> degrees, std::string_view what,
                     const SourcePosition& where, Diagnostics& diagnostics) {
  if (!look_like_radians(degrees)) return;
  diagnostics.warning(where, fmt::format("{} look like radians, and are read as degrees", what),
                      "write them in degrees: 90 instead of 1.5708");
}

}  // namespace armcal
