// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/core/random.h"

namespace armcal {

/// What an encoder adds to the angle at which it stands.
struct EncoderNoise {
  double u_rad = 0.0;     ///< standard deviation of one reading
  double step_rad = 0.0;  ///< quantisation: readings are multiples of this; 0: none
};

/// What the encoder shows.
[[nodiscard]] double shown_reading(double encoder_rad, const EncoderNoise& noise,
                                   RandomStream& random);

}  // namespace armcal
