// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/probing_size.h"

#include "armcal/verification/iso10360_12/sphere_sets.h"
#include "armcal/verification/iso10360_12/standard.h"

namespace armcal::iso10360_12 {

TestResult probing_size(std::span<const SpherePoints> positions, const ReferenceSphere& sphere) {
  TestResult result;
  result.name = "probing size error";
  result.standard = kStandard;
  result.definition =
      "diameter of the least-squares sphere through 25 points, probe taken off, minus the "
      "certified diameter; of two positions of the sphere the larger by magnitude";
  const auto probed = probe_sets(positions, sphere, kTwoPositions, result);
  for (std::size_t i = 0; i < probed.size(); ++i) {
    if (!probed[i].ok()) continue;
    result.parts.push_back(part_of(positions[i], kTwoPositions, probed[i].diameter_error_mm));
  }
  result.value_mm = largest_by_magnitude(result.parts);
  return with_symbol_if_complete(std::move(result), "P_Size.Sph.1x25::Tact.AArm");
}

}  // namespace armcal::iso10360_12
