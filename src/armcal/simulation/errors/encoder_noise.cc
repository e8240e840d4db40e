// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/encoder_noise.h"

#include <cmath>
#include <numbers>

#include "armcal/core/units.h"

namespace armcal {

EncoderNoise EncoderNoise::typical() {
  return {.u_rad = radians_from_arcseconds(1.5), .step_rad = 2.0 * std::numbers::pi / 8388608.0};
}

double EncoderNoise::u_reading_rad() const {
  return std::sqrt(u_rad * u_rad + step_rad * step_rad / 12.0);
}

double shown_reading(double encoder_rad, const EncoderNoise& noise, RandomStream& random) {
  double shown = encoder_rad;
  if (noise.u_rad > 0.0) shown += noise.u_rad * random.normal();
  if (noise.step_rad > 0.0) shown = noise.step_rad * std::round(shown / noise.step_rad);
  return shown;
}

}  // namespace armcal
