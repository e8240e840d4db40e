// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"
#include "armcal/core/random.h"

namespace armcal {

/// How far a built arm is from its drawing: standard deviations of normal errors. Typical sizes are
/// those found on a real arm (Gao et al. 2018, Table 2: twists and zeros 0.004 to 0.047 deg,
/// offsets that should be zero 0.005 to 0.06 mm); lengths are manufactured to a few tenths of a mm.
struct GeometryErrors {
  double u_twist_rad = 0.0;  ///< alpha and beta
  double u_zero_rad = 0.0;   ///< zero offsets
  double u_offset_mm = 0.0;  ///< d, b, a that are shorter than 1 mm on the drawing
  double u_length_mm = 0.0;  ///< all other d, b, a

  [[nodiscard]] bool is_on() const {
    return u_twist_rad > 0.0 || u_zero_rad > 0.0 || u_offset_mm > 0.0 || u_length_mm > 0.0;
  }
  [[nodiscard]] static GeometryErrors typical();
};

/// An arm as it came from the workshop. Parameters that are a convention and no error of an arm
/// (zero1, d2: `held_by_convention`) stay.
[[nodiscard]] ArmModel drawn_arm(const ArmModel& nominal, const GeometryErrors& errors,
                                 RandomStream& random);

}  // namespace armcal
