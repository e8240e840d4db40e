// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/test_uncertainty.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

constexpr double kReferenceTemperature_c = 20.0;  // ISO 1

void check_not_negative(double value, const char* what) {
  if (!(std::isfinite(value) && value >= 0.0)) {
    throw std::invalid_argument(fmt::format("{} {}: must not be negative", what, value));
  }
}

void check(const ArtefactCertificate& artefact) {
  if (!(std::isfinite(artefact.value_mm) && artefact.value_mm > 0.0)) {
    throw std::invalid_argument(
        fmt::format("calibrated value {} mm: must be larger than 0", artefact.value_mm));
  }
  if (!(std::isfinite(artefact.coverage_factor) && artefact.coverage_factor > 0.0)) {
    throw std::invalid_argument(
        fmt::format("coverage factor {}: must be larger than 0", artefact.coverage_factor));
  }
  if (!std::isfinite(artefact.expansion_per_k)) {
    throw std::invalid_argument(
        fmt::format("coefficient of expansion {}: must be finite", artefact.expansion_per_k));
  }
  check_not_negative(artefact.U_mm, "expanded uncertainty of the certificate");
  check_not_negative(artefact.form_mm, "form error of the artefact");
  check_not_negative(artefact.u_expansion_per_k, "uncertainty of the coefficient of expansion");
}

void check(const TestEnvironment& environment) {
  if (!std::isfinite(environment.temperature_c)) {
    throw std::invalid_argument(
        fmt::format("temperature {} degC: must be finite", environment.temperature_c));
  }
  check_not_negative(environment.u_temperature_k, "uncertainty of the temperature");
}

void add(TestUncertainty& budget, UncertaintyContribution contribution) {
  if (contribution.u_mm() > 0.0) budget.contributions.push_back(std::move(contribution));
}

// What a calibrated length or diameter contributes. theory/verification.md eq. (17)
TestUncertainty of_calibrated_value(const ArtefactCertificate& artefact,
                                    const TestEnvironment& environment) {
  check(artefact);
  check(environment);
  const double away_k = environment.temperature_c - kReferenceTemperature_c;
  TestUncertainty budget;
  add(budget, {.name = "certificate",
               .source = UncertaintySource::certificate,
               .u = artefact.U_mm / artefact.coverage_factor});
  add(budget, {.name = "temperature of the artefact",
               .source = UncertaintySource::temperature,
               .u = environment.u_temperature_k,
               .unit = "K",
               .sensitivity = artefact.value_mm * artefact.expansion_per_k});
  add(budget, {.name = "coefficient of expansion",
               .source = UncertaintySource::expansion,
               .u = artefact.u_expansion_per_k,
               .unit = "1/K",
               .sensitivity = artefact.value_mm * away_k});
  return budget;
}

TestUncertainty of_form_alone(const ArtefactCertificate& sphere) {
  check(sphere);
  TestUncertainty budget;
  add(budget,
      {.name = "form of the sphere", .source = UncertaintySource::form, .u = sphere.form_mm / 2.0});
  return budget;
}

}  // namespace

std::string_view to_string(UncertaintySource source) {
  switch (source) {
    case UncertaintySource::certificate:
      return "certificate";
    case UncertaintySource::form:
      return "form";
    case UncertaintySource::temperature:
      return "temperature";
    case UncertaintySource::expansion:
      return "expansion";
    case UncertaintySource::repeatability:
      return "repeatability";
  }
  return "unknown";
}

double UncertaintyContribution::u_mm() const { return std::abs(sensitivity) * u; }

double TestUncertainty::combined_mm() const {
  double variance = 0.0;
  for (const auto& each : contributions) variance += each.u_mm() * each.u_mm();
  return std::sqrt(variance);
}

double TestUncertainty::effective_degrees_of_freedom() const {
  double sum = 0.0;
  for (const auto& each : contributions) sum += std::pow(each.u_mm(), 4) / each.degrees_of_freedom;
  if (sum == 0.0) return std::numeric_limits<double>::infinity();
  return std::pow(combined_mm(), 4) / sum;
}

ExpandedUncertainty TestUncertainty::with_factor(double coverage_factor) const {
  if (!(std::isfinite(coverage_factor) && coverage_factor > 0.0)) {
    throw std::invalid_argument(
        fmt::format("coverage factor {}: must be larger than 0", coverage_factor));
  }
  return {combined_mm(), coverage_factor};
}

ExpandedUncertainty TestUncertainty::at_level(double level) const {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument(
        fmt::format("level of confidence {}: must be between 0 and 1", level));
  }
  const double probability = 0.5 * (1.0 + level);
  const double freedom = effective_degrees_of_freedom();
  const double factor =
      std::isinf(freedom) ? normal_quantile(probability) : student_t_quantile(probability, freedom);
  return {combined_mm(), factor};
}

double value_at_temperature_mm(const ArtefactCertificate& artefact,
                               const TestEnvironment& environment) {
  check(artefact);
  check(environment);
  const double away_k = environment.temperature_c - kReferenceTemperature_c;
  return artefact.value_mm * (1.0 + artefact.expansion_per_k * away_k);
}

UncertaintyContribution repeatability_of_mean(std::span<const double> values_mm) {
  if (values_mm.size() < 2) {
    throw std::invalid_argument(
        fmt::format("repeatability of {} values: at least 2 are needed", values_mm.size()));
  }
  const double count = static_cast<double>(values_mm.size());
  double mean = 0.0;
  for (const double value : values_mm) mean += value / count;
  double squares = 0.0;
  for (const double value : values_mm) squares += (value - mean) * (value - mean);
  return {.name = "repeatability",
          .source = UncertaintySource::repeatability,
          .u = std::sqrt(squares / (count - 1.0) / count),
          .degrees_of_freedom = count - 1.0};
}

TestUncertainty length_error_uncertainty(const ArtefactCertificate& length,
                                         const TestEnvironment& environment) {
  return of_calibrated_value(length, environment);
}

TestUncertainty probing_size_uncertainty(const ArtefactCertificate& sphere,
                                         const TestEnvironment& environment) {
  TestUncertainty budget = of_calibrated_value(sphere, environment);
  add(budget, {.name = "form of the sphere",
               .source = UncertaintySource::form,
               .u = sphere.form_mm / (2.0 * std::numbers::sqrt3),
               .sensitivity = 2.0});
  return budget;
}

TestUncertainty probing_form_uncertainty(const ArtefactCertificate& sphere) {
  return of_form_alone(sphere);
}

TestUncertainty location_uncertainty(const ArtefactCertificate& sphere) {
  return of_form_alone(sphere);
}

}  // namespace armcal
