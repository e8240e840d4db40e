// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/probing_form.h"

#include "armcal/verification/iso10360_12/sphere_sets.h"
#include "armcal/verification/iso10360_12/standard.h"

namespace armcal::iso10360_12 {

TestResult probing_form(std::span<const SpherePoints> positions, const ReferenceSphere& sphere) {
  TestResult result;
  result.name = "probing form error";
  result.standard = kStandard;
  result.definition =
      "largest minus smallest distance of 25 points from the centre of their least-squares sphere; "
      "of two positions of the sphere the larger";
  result.is_signed = false;
  const auto probed = probe_sets(positions, sphere, kTwoPositions, result);
  for (std::size_t i = 0; i < probed.size(); ++i) {
    if (!probed[i].ok() || probed[i].fit.count < kLeastPointsForForm) continue;
    result.parts.push_back(part_of(positions[i], kTwoPositions, probed[i].fit.form_mm));
  }
  result.value_mm = largest_by_magnitude(result.parts);
  return with_symbol_if_complete(std::move(result), "P_Form.Sph.1x25::Tact.AArm");
}

}  // namespace armcal::iso10360_12
