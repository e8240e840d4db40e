// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/core/random.h"

namespace armcal {

/// What an encoder adds to the angle at which it stands: noise of each reading, then rounding to a
/// whole number of steps. theory/virtual_arm.md eq. (2)
struct EncoderNoise {
  double u_rad = 0.0;     ///< standard deviation of one reading
  double step_rad = 0.0;  ///< quantisation: readings are multiples of this; 0: none

  [[nodiscard]] bool is_on() const { return u_rad > 0.0 || step_rad > 0.0; }
  /// Standard uncertainty of a reading: noise, and rounding to steps.
  [[nodiscard]] double u_reading_rad() const;
  /// 1.5 arcsec and 2^23 steps per turn: the class of commercial arms, whose repeatability needs 1
  /// to 2 arcsec.
  [[nodiscard]] static EncoderNoise typical();
};

/// What the encoder shows.
[[nodiscard]] double shown_reading(double encoder_rad, const EncoderNoise& noise,
                                   RandomStream& random);

}  // namespace armcal
