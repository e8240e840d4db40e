// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"
#include "armcal/core/random.h"

namespace armcal {

/// Scales that do not sit on their axes: once per turn where they are eccentric, twice where they
/// are tilted or oval. theory/virtual_arm.md eq. (3)
///
/// A scale of radius r that is off by e shows up to e / r too much: 1 um on 25 mm is 8 arcsec. Two
/// opposed reading heads cancel the first harmonic and leave the second.
struct ScaleEccentricity {
  double u_first_rad = 0.0;   ///< standard deviation of the cosine and the sine once per turn
  double u_second_rad = 0.0;  ///< and twice per turn

  [[nodiscard]] bool is_on() const { return u_first_rad > 0.0 || u_second_rad > 0.0; }
  /// 5 and 2 arcsec: prototypes whose tips err by 0.1 to 0.2 mm are in the class of 5 to 10 arcsec.
  [[nodiscard]] static ScaleEccentricity typical();
};

/// The same arm with drawn amplitudes added to the harmonics of its encoders.
[[nodiscard]] ArmModel with_eccentric_scales(const ArmModel& arm,
                                             const ScaleEccentricity& eccentricity,
                                             RandomStream& random);

}  // namespace armcal
