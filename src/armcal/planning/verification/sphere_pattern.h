// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/planning/verification/touch_search.h"

namespace armcal {

/// A sphere to be probed, in the base frame.
struct SphereToProbe {
  Eigen::Vector3d centre_mm;
  double radius_mm = 0.0;
  double tip_radius_mm = 0.0;

  /// The tip on the surface where its normal is `direction`.
  [[nodiscard]] Touch touch(const Eigen::Vector3d& direction) const {
    return {centre_mm + (radius_mm + tip_radius_mm) * direction, direction};
  }
};

// Where a sphere is probed: unit directions from its centre on the half about a pole, the pole
// first. theory/verification_plan.md eq. (4)

/// 25 points of ISO 10360: the pole, 4 at 22.5 deg from it, 8 at 45, 4 at 67.5 and 8 on the
/// equator, each ring turned by 22.5 deg against the one before.
[[nodiscard]] std::vector<Eigen::Vector3d> pattern_of_25(const Eigen::Vector3d& pole);
/// 9 points: the pole, 4 at 45 deg from it, 4 on the equator between them.
[[nodiscard]] std::vector<Eigen::Vector3d> pattern_of_9(const Eigen::Vector3d& pole);
/// 5 points that one direction of the stylus reaches: the pole and 4 at 60 deg from it.
[[nodiscard]] std::vector<Eigen::Vector3d> pattern_of_5(const Eigen::Vector3d& pole);

}  // namespace armcal
