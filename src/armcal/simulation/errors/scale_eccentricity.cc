// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/scale_eccentricity.h"

#include <array>

#include "armcal/core/units.h"

namespace armcal {

ScaleEccentricity ScaleEccentricity::typical() {
  return {.u_first_rad = radians_from_arcseconds(5.0),
          .u_second_rad = radians_from_arcseconds(2.0)};
}

ArmModel with_eccentric_scales(const ArmModel& arm, const ScaleEccentricity& eccentricity,
                               RandomStream& random) {
  if (!eccentricity.is_on()) return arm;
  ArmModel result = arm;
  const std::array<double, 2> sizes = {eccentricity.u_first_rad, eccentricity.u_second_rad};
  for (Joint& joint : result.joints) {
    if (joint.harmonics.size() < sizes.size()) joint.harmonics.resize(sizes.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      joint.harmonics[k].cos_rad += sizes[k] * random.normal();
      joint.harmonics[k].sin_rad += sizes[k] * random.normal();
    }
  }
  return result;
}

}  // namespace armcal
