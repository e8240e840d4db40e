// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/b89_4_22/effective_diameter.h"

#include <cmath>

#include "armcal/verification/as_asked.h"
#include "armcal/verification/b89_4_22/standard.h"

namespace armcal::b89_4_22 {
namespace {

constexpr std::size_t kPoints = 9;
constexpr std::size_t kLeastFits = 3;

double mean_of(const std::vector<ResultPart>& parts) {
  double sum = 0.0;
  for (const ResultPart& part : parts) sum += part.value_mm;
  return sum / static_cast<double>(parts.size());
}

double standard_deviation_of(const std::vector<ResultPart>& parts, double mean) {
  double squares = 0.0;
  for (const ResultPart& part : parts) squares += std::pow(part.value_mm - mean, 2);
  return std::sqrt(squares / static_cast<double>(parts.size() - 1));
}

// The diameters, and what the fits lack or cannot be.
void add_fits(std::span<const SpherePoints> fits, const ReferenceSphere& sphere,
              TestResult& result) {
  if (fits.size() < kLeastFits) {
    add_unless_as_asked(result.missing, fits.size(), kLeastFits, "fit");
  }
  for (const SpherePoints& fit : fits) {
    add_unless_as_asked(result.missing, fit.points_mm.size(), kPoints, "point",
                        " in fit " + fit.name);
    const ProbedSphere probed = probe_sphere(fit, sphere, "fit");
    if (probed.problem) result.problems.push_back(*probed.problem);
    if (!probed.ok()) continue;
    result.parts.push_back({.name = "fit " + fit.name,
                            .value_mm = probed.diameter_error_mm,
                            .readings = static_cast<int>(fit.points_mm.size()),
                            .where = fit.where});
  }
}

}  // namespace

std::vector<TestResult> effective_diameter(std::span<const SpherePoints> fits,
                                           const ReferenceSphere& sphere) {
  TestResult mean;
  mean.name = "effective diameter, mean error";
  mean.standard = kStandard;
  mean.definition =
      "mean of the diameters of least-squares spheres through nine points each, probe taken off, "
      "minus the certified diameter; parts: each diameter minus the certified one";
  add_fits(fits, sphere, mean);
  TestResult spread = mean;
  spread.name = "effective diameter, standard deviation";
  spread.definition =
      "standard deviation of the diameters of least-squares spheres through nine points each";
  spread.is_signed = false;
  if (!mean.parts.empty()) mean.value_mm = mean_of(mean.parts);
  if (mean.parts.size() > 1) spread.value_mm = standard_deviation_of(mean.parts, *mean.value_mm);
  return {std::move(mean), std::move(spread)};
}

}  // namespace armcal::b89_4_22
