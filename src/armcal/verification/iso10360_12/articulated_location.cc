// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/articulated_location.h"

#include "armcal/geometry/smallest_enclosing_sphere.h"
#include "armcal/verification/iso10360_12/sphere_sets.h"
#include "armcal/verification/iso10360_12/standard.h"

namespace armcal::iso10360_12 {

TestResult articulated_location(std::span<const SpherePoints> articulations,
                                const ReferenceSphere& sphere) {
  TestResult result;
  result.name = "articulated location error";
  result.standard = kStandard;
  result.definition =
      "diameter of the smallest sphere that contains the centres of the least-squares spheres "
      "through 5 points in each of 5 articulations; parts: distances from its middle";
  result.is_signed = false;
  const auto probed = probe_sets(articulations, sphere, kFiveArticulations, result);
  std::vector<Eigen::Vector3d> centers;
  for (const ProbedSphere& each : probed) {
    if (each.ok()) centers.push_back(each.fit.center_mm);
  }
  if (centers.size() < 2) return result;
  const EnclosingSphere cloud = smallest_enclosing_sphere(centers);
  for (std::size_t i = 0; i < probed.size(); ++i) {
    if (!probed[i].ok()) continue;
    const double distance_mm = (probed[i].fit.center_mm - cloud.center_mm).norm();
    result.parts.push_back(part_of(articulations[i], kFiveArticulations, distance_mm));
  }
  result.value_mm = 2.0 * cloud.radius_mm;
  return with_symbol_if_complete(std::move(result), "L_Dia.5x5:Art:Tact.AArm");
}

}  // namespace armcal::iso10360_12
