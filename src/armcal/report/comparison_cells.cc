// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/comparison_cells.h"

#include <fmt/format.h>

#include <algorithm>

#include "armcal/report/number_format.h"

namespace armcal {

std::string seconds_cell(double seconds) {
  const int decimals = seconds >= 9.95 ? 0 : decimals_for_uncertainty(seconds);
  return fmt::format("{:.{}f} s", seconds, std::min(decimals, 4));
}

std::string error_cell(double error_mm) { return fixed(error_mm, error_mm < 1.0 ? 4 : 2); }

std::string ratio_cell(double ratio) { return fixed(ratio, ratio < 10.0 ? 2 : 0); }

std::string condition_cell(const std::optional<double>& number) {
  if (!number) return "";
  return *number < 1e4 ? fmt::format("{:.0f}", *number) : fmt::format("{:.0e}", *number);
}

}  // namespace armcal
