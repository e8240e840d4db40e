// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armcal {

std::string fixed(double value, int decimals) {
  if (decimals < 0) {
    const double step = std::pow(10.0, -decimals);
    return fixed(step * std::round(value / step), 0);
  }
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool only_zeros = text.find_first_not_of("-0.") == std::string::npos;
  if (only_zeros && text.starts_with('-')) text.erase(0, 1);
  return text;
}

int decimals_for_uncertainty(double u) {
  if (!(u > 0.0) || !std::isfinite(u)) return 4;
  // Of 0.00995 two digits are 0.010 with three decimals: round first, then count.
  const double rounded = std::stod(fmt::format("{:.1e}", u));
  const int exponent = static_cast<int>(std::floor(std::log10(rounded) + 1e-12));
  return std::min(1 - exponent, 9);
}

std::string with_uncertainty(double value, double u) {
  const int decimals = decimals_for_uncertainty(u);
  return fixed(value, decimals) + " +- " + fixed(u, decimals);
}

}  // namespace armcal
