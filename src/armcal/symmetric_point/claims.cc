// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/arm/parameter_table.h"

namespace armcal {
namespace {

constexpr double kToleranceInU = 4.0;

double tolerance(const Claim& claim) { return kToleranceInU * claim.u; }

// Claim beside value, signs forgiven where only they differ: a reversal distance has none.
ClaimCheck compare(const Claim& claim, const ArmModel& arm) {
  const ParameterTable table(arm);
  const int index = table.find(claim.parameter).value();
  ClaimCheck check;
  check.name = claim.parameter;
  check.is_angle = table[index].unit == ParameterUnit::rad;
  check.claimed = claim.value;
  check.value = table[index].nominal;
  check.difference = check.claimed - check.value;
  const double of_magnitudes = std::abs(check.claimed) - std::abs(check.value);
  if (check.claimed * check.value < 0.0 && std::abs(of_magnitudes) < std::abs(check.difference)) {
    check.sign_differs = true;
    check.difference = of_magnitudes;
  }
  check.agrees = std::abs(check.difference) <= tolerance(claim);
  return check;
}

std::vector<ClaimCheck> compare_all(std::span<const Claim> claims, const ArmModel& arm) {
  std::vector<ClaimCheck> checks;
  for (const Claim& claim : claims) checks.push_back(compare(claim, arm));
  return checks;
}

// What one reading, changed alone, would reconcile.
struct Explanation {
  std::size_t reading = 0;
  double value = 0.0;
  std::vector<std::size_t>
      claims;  // places of the claims that it turns from contradicted to agreeing
};

class Detective {
 public:
  Detective(const ArmModel& nominal, std::span<const SymmetricReading> readings,
            const AdjustmentOptions& options, std::span<const Claim> claims)
      : nominal_(nominal),
        readings_(readings.begin(), readings.end()),
        options_(options),
        claims_(claims) {}

  // The reading that reconciles the most contradicted claims, if any does.
  [[nodiscard]] std::optional<Explanation> best_explanation() const {
    const Adjustment now = adjust(nominal_, readings_, options_);
    if (!now.ok()) return std::nullopt;
    const auto before = compare_all(claims_, now.arm);
    std::optional<Explanation> best;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      for (std::size_t j = 0; j < claims_.size(); ++j) {
        if (before[j].agrees) continue;
        auto explanation = explanation_by(i, j, now, before);
        if (explanation && (!best || explanation->claims.size() > best->claims.size())) {
          best = std::move(explanation);
        }
      }
    }
    return best;
  }

  void correct(const Explanation& explanation) {
    readings_[explanation.reading].value = explanation.value;
  }

  [[nodiscard]] const std::string& name(const Explanation& explanation) const {
    return readings_[explanation.reading].name;
  }

 private:
  // The value that reading `i` needs for claim `j`: Newton on the adjusted parameter.
  [[nodiscard]] std::optional<double> value_for(std::size_t i, std::size_t j,
                                                const ClaimCheck& check) const {
    std::vector<SymmetricReading> trial = readings_;
    const double wanted = check.sign_differs ? -check.claimed : check.claimed;
    const ParameterTable table(nominal_);
    const int index = table.find(check.name).value();
    const auto parameter_at = [&](double value) -> std::optional<double> {
      trial[i].value = value;
      const Adjustment adjustment = adjust(nominal_, trial, options_);
      if (!adjustment.ok()) return std::nullopt;
      return parameter_values(adjustment.arm)(index);
    };
    double value = readings_[i].value;
    const double probe = std::max(100.0 * readings_[i].u, 1e-6);
    for (int step = 0; step < 20; ++step) {
      const auto here = parameter_at(value);
      const auto beside = parameter_at(value + probe);
      if (!here || !beside) return std::nullopt;
      const double gain = (*beside - *here) / probe;
      constexpr double kNoInfluence = 1e-3;
      if (std::abs(gain) < kNoInfluence) return std::nullopt;
      const double change = (wanted - *here) / gain;
      value += change;
      if (std::abs(change) < 0.01 * claims_[j].u) return value;
    }
    return std::nullopt;
  }

  // Is nothing contradicted that was not before, neither a claim nor a check between readings?
  [[nodiscard]] std::optional<std::vector<std::size_t>> reconciled_at(
      std::size_t i, double value, const Adjustment& now,
      const std::vector<ClaimCheck>& before) const {
    std::vector<SymmetricReading> trial = readings_;
    trial[i].value = value;
    const Adjustment adjustment = adjust(nominal_, trial, options_);
    if (!adjustment.ok()) return std::nullopt;
    for (std::size_t k = 0; k < adjustment.readings.size(); ++k) {
      if (adjustment.readings[k].flagged && !now.readings[k].flagged) return std::nullopt;
    }
    const auto after = compare_all(claims_, adjustment.arm);
    std::vector<std::size_t> reconciled;
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (before[k].agrees && !after[k].agrees) return std::nullopt;
      if (!before[k].agrees && after[k].agrees) reconciled.push_back(k);
    }
    return reconciled;
  }

  [[nodiscard]] std::optional<Explanation> explanation_by(
      std::size_t i, std::size_t j, const Adjustment& now,
      const std::vector<ClaimCheck>& before) const {
    const auto exact = value_for(i, j, before[j]);
    if (!exact) return std::nullopt;
    const auto reconciled = reconciled_at(i, *exact, now, before);
    if (!reconciled || reconciled->empty()) return std::nullopt;
    // Claims are rounded, so the exact value is not the one that was read: of all that reconcile
    // the same claims, the one with the fewest decimals is.
    if (!readings_[i].is_angle()) {
      for (const double unit : {1e-2, 1e-3, 1e-4}) {
        const double rounded = std::round(*exact / unit) * unit;
        if (reconciled_at(i, rounded, now, before) == reconciled)
          return Explanation{i, rounded, *reconciled};
      }
    }
    return Explanation{i, *exact, *reconciled};
  }

  const ArmModel& nominal_;
  std::vector<SymmetricReading> readings_;
  const AdjustmentOptions& options_;
  std::span<const Claim> claims_;
};

// Other quantities of the same magnitude: a length that was taken for two parameters, say.
std::vector<std::string> of_equal_magnitude(const Claim& claim,
                                            std::span<const SymmetricReading> readings,
                                            const Adjustment& adjustment) {
  std::vector<std::string> equals;
  const double magnitude = std::abs(claim.value);
  const auto same = [&](double other) {
    return std::abs(std::abs(other) - magnitude) <= tolerance(claim);
  };
  for (const SymmetricReading& reading : readings) {
    if (reading.is_angle()) continue;
    if (same(reading.value)) equals.push_back("the reading " + reading.name);
    if (same(reading.value / 2.0)) equals.push_back("half of " + reading.name);
  }
  for (std::size_t i = 0; i < adjustment.unknown_names.size(); ++i) {
    if (adjustment.unknown_names[i] != claim.parameter &&
        same(adjustment.values(static_cast<Eigen::Index>(i)))) {
      equals.push_back(adjustment.unknown_names[i] + " as adjusted");
    }
  }
  return equals;
}

}  // namespace

std::vector<ClaimCheck> check_claims(const ArmModel& nominal,
                                     std::span<const SymmetricReading> readings,
                                     const AdjustmentOptions& options, const Adjustment& adjustment,
                                     std::span<const Claim> claims) {
  std::vector<ClaimCheck> checks = compare_all(claims, adjustment.arm);
  Detective detective(nominal, readings, options, claims);
  for (std::size_t found = 0; found < claims.size(); ++found) {
    const auto explanation = detective.best_explanation();
    if (!explanation) break;
    for (const std::size_t claim : explanation->claims) {
      checks[claim].contradicted_by = detective.name(*explanation);
      checks[claim].reconciled_by = explanation->value;
    }
    detective.correct(*explanation);
  }
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!checks[i].agrees && !checks[i].contradicted_by && !checks[i].is_angle) {
      checks[i].equals = of_equal_magnitude(claims[i], readings, adjustment);
    }
  }
  return checks;
}

}  // namespace armcal
