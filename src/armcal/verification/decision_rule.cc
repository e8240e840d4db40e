// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/decision_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

// Errors are differences of lengths ten thousand times as large: their last digits are rounding.
constexpr double kRounding = 1e-11;

void check(const ToleranceLimits& limits) {
  if (!limits.lower && !limits.upper) {
    throw std::invalid_argument("limits: neither a lower nor an upper one is given");
  }
  for (const auto& limit : {limits.lower, limits.upper}) {
    if (limit && !std::isfinite(*limit)) {
      throw std::invalid_argument(fmt::format("limit {}: must be finite", *limit));
    }
  }
  if (limits.lower && limits.upper && *limits.lower > *limits.upper) {
    throw std::invalid_argument(
        fmt::format("limits: lower {} is above upper {}", *limits.lower, *limits.upper));
  }
}

void check_standard_uncertainty(double u) {
  if (!(std::isfinite(u) && u >= 0.0)) {
    throw std::invalid_argument(fmt::format("standard uncertainty {}: must not be negative", u));
  }
}

bool is_above(double value, double bound, double guard) {
  const double scale = std::max({std::abs(value), std::abs(bound), std::abs(guard)});
  return value - bound > kRounding * scale;
}

bool exceeds(double value, const ToleranceLimits& limits, double widened_by) {
  if (limits.upper && is_above(value, *limits.upper + widened_by, widened_by)) return true;
  return limits.lower && is_above(-value, -*limits.lower + widened_by, widened_by);
}

bool has_middle(DecisionKind kind) {
  return kind == DecisionKind::iso14253_1 || kind == DecisionKind::conformance_probability;
}

}  // namespace

std::string_view to_string(DecisionKind kind) {
  switch (kind) {
    case DecisionKind::iso14253_1:
      return "iso14253-1";
    case DecisionKind::conformance_probability:
      return "conformance-probability";
    case DecisionKind::simple_acceptance:
      return "simple-acceptance";
    case DecisionKind::guard_band:
      return "guard-band";
  }
  return "unknown";
}

std::string_view explain(DecisionKind kind) {
  switch (kind) {
    case DecisionKind::iso14253_1:
      return "passes inside the limit by the expanded uncertainty of the test, fails outside it by "
             "as much, is undecided between";
    case DecisionKind::conformance_probability:
      return "passes or fails where that is certain to the stated probability, is undecided "
             "between";
    case DecisionKind::simple_acceptance:
      return "passes up to the limit and fails beyond; the uncertainty of the test plays no part";
    case DecisionKind::guard_band:
      return "passes inside the limit by the stated share of the expanded uncertainty, else fails";
  }
  return "unknown";
}

double guard_band(const DecisionRule& rule, const ExpandedUncertainty& uncertainty) {
  check_standard_uncertainty(uncertainty.standard);
  if (!(std::isfinite(uncertainty.coverage_factor) && uncertainty.coverage_factor > 0.0)) {
    throw std::invalid_argument(
        fmt::format("coverage factor {}: must be larger than 0", uncertainty.coverage_factor));
  }
  switch (rule.kind) {
    case DecisionKind::iso14253_1:
      return uncertainty.expanded();
    case DecisionKind::conformance_probability:
      if (!(rule.probability >= 0.5 && rule.probability < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "probability of conformance {}: must be at least 0.5 and below 1", rule.probability));
      }
      return normal_quantile(rule.probability) * uncertainty.standard;
    case DecisionKind::simple_acceptance:
      return 0.0;
    case DecisionKind::guard_band:
      break;
  }
  if (!std::isfinite(rule.guard_factor)) {
    throw std::invalid_argument(fmt::format("guard factor {}: must be finite", rule.guard_factor));
  }
  return rule.guard_factor * uncertainty.expanded();
}

Verdict decide(double value, const ExpandedUncertainty& uncertainty, const ToleranceLimits& limits,
               const DecisionRule& rule) {
  check(limits);
  const double guard = guard_band(rule, uncertainty);
  if (!std::isfinite(value)) return Verdict::not_judged;
  if (!exceeds(value, limits, -guard)) return Verdict::pass;
  if (!has_middle(rule.kind)) return Verdict::fail;
  return exceeds(value, limits, guard) ? Verdict::fail : Verdict::undecided;
}

double conformance_probability(double value, double u, const ToleranceLimits& limits) {
  check(limits);
  check_standard_uncertainty(u);
  if (u == 0.0) return exceeds(value, limits, 0.0) ? 0.0 : 1.0;
  // The tails are taken on the side where they are small: a difference of two numbers near 1 would
  // lose what is asked for.
  const double below = limits.lower ? (*limits.lower - value) / u : -INFINITY;
  const double above = limits.upper ? (*limits.upper - value) / u : INFINITY;
  const auto cdf = [](double x) { return std::isinf(x) ? (x > 0.0 ? 1.0 : 0.0) : normal_cdf(x); };
  if (below > 0.0) return cdf(-below) - cdf(-above);
  return cdf(above) - cdf(below);
}

double action_limit(double upper, double u_relative, double probability) {
  if (!(probability > 0.0 && probability < 1.0)) {
    throw std::invalid_argument(
        fmt::format("probability {}: must be between 0 and 1", probability));
  }
  const double z = normal_quantile(probability);
  if (!(std::isfinite(u_relative) && u_relative >= 0.0 && z * u_relative < 1.0)) {
    throw std::invalid_argument(fmt::format(
        "relative uncertainty {}: no value is certain to exceed the limit", u_relative));
  }
  return upper / (1.0 - z * u_relative);
}

}  // namespace armcal
