// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/encoder.h"

#include <cmath>

namespace armcal {

double joint_angle(const Joint& joint, double encoder_rad) {
  double angle = joint.direction * (encoder_rad + joint.zero_rad);
  double k = 1.0;
  for (const Harmonic& harmonic : joint.harmonics) {
    angle +=
        harmonic.cos_rad * std::cos(k * encoder_rad) + harmonic.sin_rad * std::sin(k * encoder_rad);
    k += 1.0;
  }
  return angle;
}

double joint_angle_slope(const Joint& joint, double encoder_rad) {
  double slope = joint.direction;
  double k = 1.0;
  for (const Harmonic& harmonic : joint.harmonics) {
    slope += k * (harmonic.sin_rad * std::cos(k * encoder_rad) -
                  harmonic.cos_rad * std::sin(k * encoder_rad));
    k += 1.0;
  }
  return slope;
}

double encoder_at_joint_angle(const Joint& joint, double angle_rad, double guess_rad) {
  if (joint.harmonics.empty()) return angle_rad / joint.direction - joint.zero_rad;
  // Harmonics are small beside the reading itself: Newton gains at least three digits a step.
  double encoder = guess_rad;
  for (int i = 0; i < 20; ++i) {
    const double step =
        (angle_rad - joint_angle(joint, encoder)) / joint_angle_slope(joint, encoder);
    encoder += step;
    if (std::abs(step) <= 1e-15 * (1.0 + std::abs(encoder))) break;
  }
  return encoder;
}

}  // namespace armcal
