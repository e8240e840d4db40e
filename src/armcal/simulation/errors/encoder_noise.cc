// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/encoder_noise.h"

#include <cmath>

namespace armcal {

double shown_reading(double encoder_rad, const EncoderNoise& noise, RandomStream& random) {
  double shown = encoder_rad;
  if (noise.u_rad > 0.0) shown += noise.u_rad * random.normal();
  if (noise.step_rad > 0.0) shown = noise.step_rad * std::round(shown / noise.step_rad);
  return shown;
}

}  // namespace armcal
