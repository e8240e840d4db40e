// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "armcal/core/units.h"

namespace armcal {

std::optional<double> parse_number(std::string_view text, bool decimal_comma) {
  constexpr std::string_view kUnicodeMinus = "\xE2\x88\x92";
  bool negative = false;
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  } else if (text.starts_with(kUnicodeMinus)) {
    text.remove_prefix(kUnicodeMinus.size());
    negative = true;
  }
  // A comma is turned into a point in a copy; longer than this no number is.
  std::array<char, 64> copy{};
  if (decimal_comma) {
    if (text.size() > copy.size()) return std::nullopt;
    const auto end = std::copy(text.begin(), text.end(), copy.begin());
    const auto comma = std::find(copy.begin(), end, ',');
    if (comma != end) {
      if (std::find(copy.begin(), end, '.') != end) return std::nullopt;
      *comma = '.';
    }
    text = std::string_view(copy.data(), text.size());
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return negative ? -value : value;
}

bool spells_missing(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (lower.starts_with('+') || lower.starts_with('-')) lower.erase(0, 1);
  constexpr std::array<std::string_view, 12> kSpellings = {
      "nan", "n/a", "na", "null", "none", "inf", "-", "--", "---", "?", "infinity", "missing"};
  return std::find(kSpellings.begin(), kSpellings.end(), lower) != kSpellings.end() ||
         lower.starts_with("1.#");
}

std::string shortest_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string decimal_text(double value, int places) {
  std::string text = fmt::format("{:.{}f}", value, places);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

double with_point_moved(double value, int places) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                          std::chars_format::scientific);
  const std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
  const std::size_t e = text.find('e');
  const double product = value * std::pow(10.0, places);
  if (e == text.npos) return product;  // not finite
  const auto exponent = parse_number(text.substr(e + 1));
  return parse_number(fmt::format("{}e{:.0f}", text.substr(0, e), exponent.value_or(0.0) + places))
      .value_or(product);
}

namespace {

// Shortest text, among the few doubles nearest to a converted angle, that converts back.
std::string angle_text(double radians, double nearest, double (*radians_from)(double)) {
  if (radians == 0.0) return "0.0";  // of either sign
  std::string best;
  double candidate = nearest;
  constexpr int kNeighbours = 4;
  for (int i = 0; i < kNeighbours; ++i) {
    candidate = std::nextafter(candidate, -std::numeric_limits<double>::infinity());
  }
  for (int i = 0; i <= 2 * kNeighbours; ++i) {
    if (radians_from(candidate) == radians) {
      std::string text = shortest_text(candidate);
      if (best.empty() || text.size() < best.size()) best = std::move(text);
    }
    candidate = std::nextafter(candidate, std::numeric_limits<double>::infinity());
  }
  return best.empty() ? shortest_text(nearest) : best;
}

}  // namespace

std::string degrees_text(double radians) {
  return angle_text(radians, degrees_from_radians(radians), radians_from_degrees);
}

std::string arcseconds_text(double radians) {
  return angle_text(radians, arcseconds_from_radians(radians), radians_from_arcseconds);
}

}  // namespace armcal
