// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// More of anything than this is a slip of the keyboard.
constexpr int kLargestCount = 100000;

}  // namespace

std::optional<double> read_amount(TomlSection& section, const std::string& key, AmountRange range,
                                  Diagnostics& diagnostics) {
  const auto value = section.number(key);
  if (!value) return std::nullopt;
  const bool good =
      range == AmountRange::any || (range == AmountRange::positive ? *value > 0.0 : *value >= 0.0);
  if (good) return value;
  diagnostics.error(
      section.where(key),
      fmt::format("{} is {}: must {}", key, *value,
                  range == AmountRange::positive ? "be larger than 0" : "not be negative"));
  return std::nullopt;
}

std::optional<double> read_share(TomlSection& section, const std::string& key,
                                 Diagnostics& diagnostics) {
  const auto value = section.number(key);
  if (!value) return std::nullopt;
  if (*value >= 0.0 && *value <= 1.0) return value;
  diagnostics.error(section.where(key), fmt::format("{} is {}: must be 0 to 1", key, *value));
  return std::nullopt;
}

std::optional<double> read_angle(TomlSection& section, const std::string& stem, AmountRange range,
                                 Diagnostics& diagnostics) {
  const auto in_arcsec = read_amount(section, stem + "_arcsec", range, diagnostics);
  const auto in_deg = read_amount(section, stem + "_deg", range, diagnostics);
  if (in_arcsec && in_deg) {
    diagnostics.error(section.where(stem + "_deg"),
                      fmt::format("{0}_arcsec and {0}_deg say the same thing", stem),
                      "keep one of them");
  }
  if (in_arcsec) return radians_from_arcseconds(*in_arcsec);
  if (in_deg) return radians_from_degrees(*in_deg);
  return std::nullopt;
}

std::optional<int> read_count(TomlSection& section, const std::string& key, int least,
                              Diagnostics& diagnostics) {
  const auto value = section.integer(key);
  if (!value) return std::nullopt;
  if (*value >= least && *value <= kLargestCount) return value;
  diagnostics.error(section.where(key),
                    fmt::format("{} is {}: must be {} to {}", key, *value, least, kLargestCount));
  return std::nullopt;
}

std::optional<std::vector<int>> read_counts(TomlSection& section, const std::string& key, int least,
                                            Diagnostics& diagnostics) {
  const auto values = section.numbers(key);
  if (!values) return std::nullopt;
  std::vector<int> counts;
  for (const double value : *values) {
    const bool whole = value == std::floor(value);
    if (whole && value >= least && value <= kLargestCount) {
      counts.push_back(static_cast<int>(value));
      continue;
    }
    diagnostics.error(section.where(key),
                      fmt::format("{} of {} is no whole number from {}", value, key, least));
    return std::nullopt;
  }
  return counts;
}

std::optional<std::size_t> read_choice(TomlSection& section, const std::string& key,
                                       const std::vector<std::string>& words,
                                       Diagnostics& diagnostics) {
  const auto word = section.text(key);
  if (!word) return std::nullopt;
  const auto found = std::find(words.begin(), words.end(), *word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  diagnostics.error(section.where(key), fmt::format("{} is \"{}\"", key, *word),
                    did_you_mean(*word, words));
  return std::nullopt;
}

}  // namespace armcal
