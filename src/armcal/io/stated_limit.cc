// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/stated_limit.h"

#include <algorithm>

#include "armcal/io/number_text.h"

namespace armcal {
namespace {

constexpr double kMillimetresPerMicrometre = 1e-3;

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
  StatedLimit limit{*constant * kMillimetresPerMicrometre, 0.0, {}};
  if (plus == text.npos) return limit;
  const auto divisor = not_negative(text.substr(plus + kLength.size()));
  if (!divisor || *divisor == 0.0) return std::nullopt;
  limit.per_length = kMillimetresPerMicrometre / *divisor;
  return limit;
}

}  // namespace

std::optional<StatedLimit> limit_of_formula(std::string_view text) {
  std::string bare(text);
  std::erase(bare, ' ');
  std::string_view rest = bare;
  std::optional<double> largest;
  constexpr std::string_view kMinimum = "min(";
  if (rest.starts_with(kMinimum) && rest.ends_with(')')) {
    rest = rest.substr(kMinimum.size(), rest.size() - kMinimum.size() - 1);
    const std::size_t comma = rest.find(',');
    if (comma == rest.npos) return std::nullopt;
    largest = not_negative(rest.substr(comma + 1));
    if (!largest || *largest == 0.0) return std::nullopt;
    rest = rest.substr(0, comma);
  }
  auto limit = line_of(rest);
  if (!limit || (limit->constant_mm == 0.0 && limit->per_length == 0.0)) return std::nullopt;
  if (largest) limit->largest_mm = *largest * kMillimetresPerMicrometre;
  return limit;
}

}  // namespace armcal
