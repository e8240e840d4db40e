// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/symmetric_point_amounts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/report/number_format.h"

namespace armcal {

double shown_amount(double value, bool is_angle) {
  return is_angle ? degrees_from_radians(value) : value;
}
const char* unit_of_amount(bool is_angle) { return is_angle ? "deg" : "mm"; }

std::string amount(double value, bool is_angle, int decimals) {
  return fixed(shown_amount(value, is_angle), decimals);
}

bool is_angle_parameter(const SymmetricPointAnalysis& analysis, const std::string& name) {
  const ParameterTable table(analysis.nominal);
  const auto index = table.find(name);
  return index && table[*index].unit == ParameterUnit::rad;
}

std::string joined_names(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::vector<std::string> head(names.begin(), names.end() - 1);
  return fmt::format("{} and {}", fmt::join(head, ", "), names.back());
}

}  // namespace armcal
