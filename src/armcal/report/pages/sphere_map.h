// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/report/html/page.h"

namespace armcal {

/// Deviations from a sphere by the direction from its centre.
struct SphereMap {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;
  std::string upper, lower;                 ///< captions of the two halves
  std::string outside, inside;              ///< words of the legend, for either sign
  std::vector<Eigen::Vector3d> directions;  ///< of length 1
  std::vector<double> deviations_mm;        ///< one for each
};

/// The halves above and below the centre beside each other, both seen from above (x to the right, y
/// up), in Lambert's azimuthal projection: equal areas of the sphere are equal there, so gaps are
/// as large as they look. Areas of marks grow with the deviation; those inside of the sphere are
/// hollow.
[[nodiscard]] Figure figure_of(const SphereMap& map);

}  // namespace armcal
