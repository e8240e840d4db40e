// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_statistics.h"

#include <fmt/format.h>

#include <algorithm>

#include "armcal/verification/b89_4_22/effective_diameter.h"
#include "armcal/verification/b89_4_22/volumetric_length.h"
#include "armcal/verification/half_range.h"
#include "armcal/verification/iso10360_12/articulated_location.h"
#include "armcal/verification/iso10360_12/length_error_bi.h"
#include "armcal/verification/iso10360_12/length_error_uni.h"
#include "armcal/verification/iso10360_12/probing_form.h"
#include "armcal/verification/iso10360_12/probing_size.h"

namespace armcal {
namespace {

ArtefactCertificate certificate_of_sphere(const StatedArtefact& artefact) {
  return {artefact.diameter_mm,     artefact.U_mm,
          artefact.coverage_factor, artefact.form_mm,
          artefact.expansion_per_K, artefact.u_expansion_per_K};
}

ArtefactCertificate certificate_of_length(const StatedArtefact& artefact,
                                          const CertifiedLength& length) {
  return {length.length_mm,         length.U_mm,
          artefact.coverage_factor, 0.0,
          artefact.expansion_per_K, artefact.u_expansion_per_K};
}

ReferenceSphere sphere_of(const PreparedTest& test) {
  return {value_at_temperature_mm(certificate_of_sphere(*test.artefact), test.environment),
          test.stated.probe_diameter_mm};
}

// At the temperature of the test.
std::vector<double> calibrated_lengths_mm(const PreparedTest& test) {
  std::vector<double> lengths;
  for (const CertifiedLength& length : test.artefact->lengths) {
    lengths.push_back(
        value_at_temperature_mm(certificate_of_length(*test.artefact, length), test.environment));
  }
  return lengths;
}

std::vector<MeasuredLength> lengths_of(const PreparedTest& test, const RowsWithTips& tips,
                                       Diagnostics& diagnostics) {
  const bool opposite = test.stated.kind == StatedTestKind::length_bi;
  return measured_lengths(
      tips, {calibrated_lengths_mm(test), opposite ? test.stated.probe_diameter_mm : 0.0, opposite},
      diagnostics);
}

std::vector<TestResult> half_ranges(const RowsWithTips& tips) {
  std::vector<TestResult> results;
  for (const auto& seat : seats_by_place(tips)) {
    results.push_back(half_range(seat.points_mm, seat.name));
  }
  return results;
}

std::vector<TestResult> articulations(const PreparedTest& test, const RowsWithTips& tips,
                                      const Eigen::Vector3d& first_axis_mm,
                                      Diagnostics& diagnostics) {
  if (!test.reach_mm) {
    diagnostics.error(test.stated.where, "reach_mm is missing",
                      "zones near, middle and far are shares of the arm's reach: write reach_mm "
                      "at the top of the file");
    return {};
  }
  return b89_4_22::single_point_articulation(seats_by_place(tips), {first_axis_mm, *test.reach_mm});
}

TestUncertainty budget_of_sphere(const PreparedTest& test, std::size_t statistic) {
  const ArtefactCertificate sphere = certificate_of_sphere(*test.artefact);
  switch (test.stated.kind) {
    case StatedTestKind::probing:
      return statistic == 0 ? probing_size_uncertainty(sphere, test.environment)
                            : probing_form_uncertainty(sphere);
    case StatedTestKind::articulated_location:
      return location_uncertainty(sphere);
    default:  // effective diameter: the mean; its standard deviation owes nothing to a certificate
      return statistic == 0 ? probing_size_uncertainty(sphere, test.environment)
                            : TestUncertainty{};
  }
}

void add_repeatability(TestUncertainty& budget, double u_mm) {
  if (u_mm == 0.0) return;
  UncertaintyContribution contribution;
  contribution.name = "repeatability of the fixture";
  contribution.source = UncertaintySource::repeatability;
  contribution.u = u_mm;
  budget.contributions.push_back(std::move(contribution));
}

// Twice the budget of the most uncertain length.
TestBudget budget_of_twice_rms(const std::vector<TestBudget>& of_lengths) {
  TestBudget budget = *std::max_element(
      of_lengths.begin(), of_lengths.end(), [](const TestBudget& one, const TestBudget& other) {
        return one.uncertainty.combined_mm() < other.uncertainty.combined_mm();
      });
  for (auto& contribution : budget.uncertainty.contributions) contribution.sensitivity *= 2.0;
  return budget;
}

std::vector<TestBudget> budgets_of_lengths(const PreparedTest& test) {
  std::vector<TestBudget> budgets;
  for (const CertifiedLength& length : test.artefact->lengths) {
    budgets.push_back({fmt::format("{:.4f} mm", length.length_mm),
                       length_error_uncertainty(certificate_of_length(*test.artefact, length),
                                                test.environment)});
  }
  return budgets;
}

}  // namespace

std::vector<TestResult> statistics_of(const PreparedTest& test, const RowsWithTips& tips,
                                      const Eigen::Vector3d& first_axis_mm,
                                      Diagnostics& diagnostics) {
  switch (test.stated.kind) {
    case StatedTestKind::probing: {
      const auto positions = spheres_by_place(tips);
      return {iso10360_12::probing_size(positions, sphere_of(test)),
              iso10360_12::probing_form(positions, sphere_of(test))};
    }
    case StatedTestKind::articulated_location:
      return {iso10360_12::articulated_location(spheres_by_articulation(tips, diagnostics),
                                                sphere_of(test))};
    case StatedTestKind::length_uni:
      return {iso10360_12::length_error_uni(lengths_of(test, tips, diagnostics), test.reach_mm)};
    case StatedTestKind::length_bi:
      return {iso10360_12::length_error_bi(lengths_of(test, tips, diagnostics), test.reach_mm)};
    case StatedTestKind::effective_diameter:
      return b89_4_22::effective_diameter(spheres_by_repeat(tips), sphere_of(test));
    case StatedTestKind::single_point_articulation:
      return articulations(test, tips, first_axis_mm, diagnostics);
    case StatedTestKind::volumetric_length:
      return b89_4_22::volumetric_length(lengths_of(test, tips, diagnostics));
    case StatedTestKind::half_range:
      break;
  }
  return half_ranges(tips);
}

std::vector<TestBudget> budgets_of(const PreparedTest& test, std::size_t statistic) {
  std::vector<TestBudget> budgets;
  if (measures_lengths(test.stated.kind)) {
    budgets = budgets_of_lengths(test);
  } else {
    budgets.push_back({"", needs_sphere(test.stated.kind) ? budget_of_sphere(test, statistic)
                                                          : TestUncertainty{}});
  }
  for (TestBudget& budget : budgets) {
    add_repeatability(budget.uncertainty, test.stated.u_repeatability_mm);
  }
  const bool is_twice_rms = test.stated.kind == StatedTestKind::volumetric_length && statistic == 1;
  if (is_twice_rms) budgets = {budget_of_twice_rms(budgets)};
  return budgets;
}

std::vector<ExpandedUncertainty> uncertainties_of(const std::vector<TestBudget>& budgets,
                                                  const PreparedTest& test,
                                                  const TestResult& result,
                                                  double coverage_factor) {
  const bool by_length =
      budgets.size() > 1 && !result.parts.empty() && result.parts.front().length_mm.has_value();
  if (!by_length) return {budgets.front().uncertainty.with_factor(coverage_factor)};
  const std::vector<double> calibrated_mm = calibrated_lengths_mm(test);
  std::vector<ExpandedUncertainty> uncertainties;
  for (const ResultPart& part : result.parts) {
    const auto at = std::find(calibrated_mm.begin(), calibrated_mm.end(), part.length_mm);
    const auto index = static_cast<std::size_t>(at - calibrated_mm.begin());
    uncertainties.push_back(budgets[index].uncertainty.with_factor(coverage_factor));
  }
  return uncertainties;
}

std::optional<MaximumPermissibleError> limit_of(const StatedTest& test, std::size_t statistic) {
  // Statistics of kinds with two limits alternate between them: seat by seat, for articulations.
  const bool is_second = has_two_limits(test.kind) && statistic % 2 == 1;
  const auto& stated = is_second ? test.second_limit : test.limit;
  if (!stated) return std::nullopt;
  if (!stated->k) return MaximumPermissibleError::constant(stated->a_mm);
  if (!stated->b_mm) return MaximumPermissibleError::linear(stated->a_mm, *stated->k);
  return MaximumPermissibleError::lesser(stated->a_mm, *stated->k, *stated->b_mm);
}

}  // namespace armcal
