// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/probed_sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/verification/as_asked.h"

namespace armcal {
namespace {

constexpr double kAnotherSphere_mm = 1.0;
constexpr double kAnotherSphereShare = 0.1;
constexpr double kNoSphereShare = 0.5;  // form error over diameter

void check(const ReferenceSphere& sphere) {
  if (!(std::isfinite(sphere.diameter_mm) && sphere.diameter_mm > 0.0)) {
    throw std::invalid_argument(
        fmt::format("certified diameter {} mm: must be larger than 0", sphere.diameter_mm));
  }
  if (!(std::isfinite(sphere.probe_diameter_mm) && sphere.probe_diameter_mm >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("probe diameter {} mm: must not be negative", sphere.probe_diameter_mm));
  }
}

bool is_probe_left_in_or_taken_off(double error_mm, const ReferenceSphere& sphere) {
  const double probe_mm = sphere.probe_diameter_mm;
  return probe_mm > 0.0 && std::abs(std::abs(error_mm) - probe_mm) < kAnotherSphereShare * probe_mm;
}

std::optional<std::string> problem_of(const ProbedSphere& probed, const ReferenceSphere& sphere) {
  if (!probed.ok()) return std::string(explain(probed.fit.status));
  const double fitted_mm = 2.0 * probed.fit.radius_mm;
  const std::string found =
      fmt::format("the points lie on a sphere of {:.4f} mm, {:.4f} mm is certified",
                  probed.diameter_mm, sphere.diameter_mm);
  if (const auto unit =
          unit_that_explains(fitted_mm, sphere.diameter_mm + sphere.probe_diameter_mm)) {
    return fmt::format(
        "the centres of the probe lie on a sphere of {:.4f} mm where {:.4f} mm is "
        "expected: {}",
        fitted_mm, sphere.diameter_mm + sphere.probe_diameter_mm, *unit);
  }
  if (probed.fit.form_mm > kNoSphereShare * fitted_mm) {
    return fmt::format(
        "the points lie on no sphere: form error {:.4f} mm on a fitted diameter of "
        "{:.4f} mm; are units or artefacts mixed?",
        probed.fit.form_mm, fitted_mm);
  }
  const double error_mm = std::abs(probed.diameter_error_mm);
  const double tolerated_mm = std::min(kAnotherSphere_mm, kAnotherSphereShare * sphere.diameter_mm);
  if (error_mm <= std::max(tolerated_mm, probed.fit.form_mm)) return std::nullopt;
  if (is_probe_left_in_or_taken_off(error_mm, sphere)) {
    return found + ": off by the diameter of the probe; are the points of the surface already?";
  }
  return found + ": another sphere?";
}

}  // namespace

ProbedSphere probe_sphere(const SpherePoints& points, const ReferenceSphere& sphere,
                          const std::string& what) {
  check(sphere);
  ProbedSphere probed;
  probed.fit = fit_sphere(points.points_mm);
  if (probed.ok()) {
    probed.diameter_mm = 2.0 * probed.fit.radius_mm - sphere.probe_diameter_mm;
    probed.diameter_error_mm = probed.diameter_mm - sphere.diameter_mm;
  }
  if (const auto problem = problem_of(probed, sphere)) {
    probed.problem = fmt::format("{} {}: {}", what, points.name, *problem);
  }
  return probed;
}

}  // namespace armcal
