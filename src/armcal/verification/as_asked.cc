// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/as_asked.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace armcal {
namespace {

struct OtherUnit {
  double millimetres;
  const char* name;
};
constexpr std::array kSmaller = std::to_array<OtherUnit>(
    {{10.0, "centimetres"}, {25.4, "inches"}, {100.0, "decimetres"}, {1000.0, "metres"}});
constexpr double kNearlyThatRatio = 0.05;

}  // namespace

void add_unless_as_asked(std::vector<std::string>& missing, std::size_t count, std::size_t asked,
                         std::string_view thing, std::string_view place) {
  if (count == asked) return;
  missing.push_back(fmt::format("{} {}{}{}, {} {} asked for", count, thing, count == 1 ? "" : "s",
                                place, asked, asked == 1 ? "is" : "are"));
}

std::optional<std::string> unit_that_explains(double value, double expected) {
  for (const OtherUnit& unit : kSmaller) {
    if (std::abs(unit.millimetres * value / expected - 1.0) < kNearlyThatRatio) {
      return fmt::format("{:g} times too small, as if in {}", unit.millimetres, unit.name);
    }
    if (std::abs(value / (unit.millimetres * expected) - 1.0) < kNearlyThatRatio) {
      return fmt::format("{:g} times too large, as if in another unit", unit.millimetres);
    }
  }
  return std::nullopt;
}

}  // namespace armcal
