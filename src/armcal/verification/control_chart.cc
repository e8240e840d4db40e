// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/control_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace armcal {
namespace {

// So many of the last so many values are beyond so many sigma.
struct Pattern {
  ControlRule rule;
  std::size_t count;
  std::size_t among;
  double beyond_sigma;
};
constexpr std::array<Pattern, 4> kPatterns = {{{ControlRule::beyond_three_sigma, 1, 1, 3.0},
                                               {ControlRule::two_of_three_beyond_two, 2, 3, 2.0},
                                               {ControlRule::four_of_five_beyond_one, 4, 5, 1.0},
                                               {ControlRule::eight_on_one_side, 8, 8, 0.0}}};

bool is_beyond(double value, const ControlLimits& limits, Side side, double sigmas) {
  const double off = side == Side::above ? value - limits.center : limits.center - value;
  return off > sigmas * limits.sigma;
}

// Does the value at the end of `values` complete the pattern?
bool completes(std::span<const double> values, const ControlLimits& limits, Side side,
               const Pattern& pattern) {
  if (!is_beyond(values.back(), limits, side, pattern.beyond_sigma)) return false;
  const auto recent = values.last(std::min(pattern.among, values.size()));
  const auto beyond = std::count_if(recent.begin(), recent.end(), [&](double value) {
    return is_beyond(value, limits, side, pattern.beyond_sigma);
  });
  return static_cast<std::size_t>(beyond) >= pattern.count;
}

}  // namespace

ControlLimits limits_of_baseline(std::span<const double> baseline) {
  if (baseline.size() < 2) {
    throw std::invalid_argument(
        fmt::format("baseline of {} values: two have the first range", baseline.size()));
  }
  double sum = 0.0;
  double ranges = 0.0;
  for (std::size_t i = 0; i < baseline.size(); ++i) {
    if (!std::isfinite(baseline[i])) {
      throw std::invalid_argument(fmt::format("value {} of the baseline is {}", i, baseline[i]));
    }
    sum += baseline[i];
    if (i > 0) ranges += std::abs(baseline[i] - baseline[i - 1]);
  }
  const auto count = static_cast<double>(baseline.size());
  return {sum / count, ranges / (count - 1.0) / kRangeOfTwo_sigma};
}

std::string explain(const RuleViolation& violation) {
  const char* side = violation.side == Side::above ? "above" : "below";
  switch (violation.rule) {
    case ControlRule::beyond_three_sigma:
      return fmt::format("1 check more than 3 sigma {} the centre line (rule 1)", side);
    case ControlRule::two_of_three_beyond_two:
      return fmt::format("2 of 3 checks more than 2 sigma {} the centre line (rule 2)", side);
    case ControlRule::four_of_five_beyond_one:
      return fmt::format("4 of 5 checks more than 1 sigma {} the centre line (rule 3)", side);
    case ControlRule::eight_on_one_side:
      return fmt::format("8 checks in a row {} the centre line (rule 4)", side);
  }
  return "unknown rule";
}

std::vector<RuleViolation> violations_of(std::span<const double> values,
                                         const ControlLimits& limits) {
  std::vector<RuleViolation> violations;
  if (!(limits.sigma > 0.0)) return violations;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const Pattern& pattern : kPatterns) {
      for (const Side side : {Side::below, Side::above}) {
        if (completes(values.first(i + 1), limits, side, pattern))
          violations.push_back({pattern.rule, side, i});
      }
    }
  }
  return violations;
}

}  // namespace armcal
