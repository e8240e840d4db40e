// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/stated_limit.h"

#include <string>

#include "armcal/core/units.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

std::optional<double> not_negative(std::string_view text) {
  const auto value = parse_number(text);
  return value && *value >= 0.0 ? value : std::nullopt;
}

// A or A+L/K, without blanks.
std::optional<StatedLimit> line_of(std::string_view text) {
  constexpr std::string_view kLength = "+L/";
  const std::size_t plus = text.find(kLength);
  const auto constant = not_negative(text.substr(0, plus));
  if (!constant) return std::nullopt;
  StatedLimit limit{millimetres_from_micrometres(*constant), {}, {}};
  if (plus == text.npos) return limit.a_mm > 0.0 ? std::optional(limit) : std::nullopt;
  limit.k = not_negative(text.substr(plus + kLength.size()));
  return limit.k && *limit.k > 0.0 ? std::optional(limit) : std::nullopt;
}

// A+L/K,B
std::optional<StatedLimit> lesser_of(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return std::nullopt;
  auto limit = line_of(text.substr(0, comma));
  const auto largest = not_negative(text.substr(comma + 1));
  if (!limit || !limit->k || !largest) return std::nullopt;
  limit->b_mm = millimetres_from_micrometres(*largest);
  return *limit->b_mm > limit->a_mm ? limit : std::nullopt;
}

}  // namespace

std::optional<StatedLimit> limit_of_formula(std::string_view text) {
  std::string bare(text);
  std::erase(bare, ' ');
  const std::string_view rest = bare;
  constexpr std::string_view kMinimum = "min(";
  if (!rest.starts_with(kMinimum)) return line_of(rest);
  if (!rest.ends_with(')')) return std::nullopt;
  return lesser_of(rest.substr(kMinimum.size(), rest.size() - kMinimum.size() - 1));
}

}  // namespace armcal
