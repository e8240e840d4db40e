// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/shown_number.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"

namespace armcal {

ShownUnit shown_unit(std::string_view parameter, std::string_view unit) {
  if (unit == "mm") return {1.0, "mm"};
  const bool harmonic = parameter.rfind("cos", 0) == 0 || parameter.rfind("sin", 0) == 0;
  if (harmonic) return {1e6, "urad"};
  return {degrees_from_radians(1.0), "deg"};
}

std::string whole(double count) { return fmt::format("{:.0f}", count); }

std::string set_angle_text(double deg) {
  constexpr double kWhole = 1e-6;
  return fixed(deg, std::abs(deg - std::round(deg)) < kWhole ? 0 : 1);
}

std::string condition_text(const std::optional<double>& condition_number) {
  return condition_number ? fmt::format("{:.3g}", *condition_number) : "\u2013";
}

std::string with_micro_sign(std::string text) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(" um"); at != std::string::npos; at = text.find(" um", at + 1)) {
    if (!is_letter(at + 3)) text.replace(at, 3, " \u00b5m");
  }
  return text;
}

}  // namespace armcal
