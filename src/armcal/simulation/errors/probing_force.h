// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace armcal {

/// What is touched pushes back: the tip gives way against the direction of probing.
/// theory/virtual_arm.md eq. (11)
struct ProbingForce {
  double force_N = 0.0;
  double arm_mm_per_N = 0.0;     ///< compliance of the arm at its tip, the same in all directions
  double stylus_mm_per_N = 0.0;  ///< of the stylus across its axis; along it it is stiff

  [[nodiscard]] bool is_on() const {
    return force_N > 0.0 && (arm_mm_per_N > 0.0 || stylus_mm_per_N > 0.0);
  }
  /// 2 N on 6 um/N of arm and 4 um/N of stylus: spheres come out 24 to 40 um too small; 33 um is a
  /// published mean.
  [[nodiscard]] static ProbingForce typical();
};

/// Way of the tip. Both directions in one frame and of unit length; `push` zero: nothing is
/// touched; `stylus` zero: bends in all directions.
[[nodiscard]] Eigen::Vector3d yield_to(const ProbingForce& probing, const Eigen::Vector3d& push,
                                       const Eigen::Vector3d& stylus);

}  // namespace armcal
