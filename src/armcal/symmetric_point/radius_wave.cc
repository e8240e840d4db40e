// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/radius_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armcal {

RadiusWave wave_basis(double t) {
  return RadiusWave(1.0, std::cos(t), std::sin(t), std::cos(2 * t), std::sin(2 * t));
}
RadiusWave wave_slope(double t) {
  return RadiusWave(0.0, -std::sin(t), std::cos(t), -2 * std::sin(2 * t), 2 * std::cos(2 * t));
}
RadiusWave wave_bend(double t) {
  return RadiusWave(0.0, -std::cos(t), -std::sin(t), -4 * std::cos(2 * t), -4 * std::sin(2 * t));
}

double wave_sample(int k) { return 2.0 * std::numbers::pi * k / kWaveSamples; }

RadiusWave wave_weights(int k) {
  RadiusWave weights = wave_basis(wave_sample(k)) * 2.0 / kWaveSamples;
  weights(0) /= 2.0;
  return weights;
}

RadiusWave wave_of(const std::function<double(double)>& squared_radius) {
  RadiusWave wave = RadiusWave::Zero();
  for (int k = 0; k < kWaveSamples; ++k) wave += squared_radius(wave_sample(k)) * wave_weights(k);
  return wave;
}

std::optional<double> extremum_near(const RadiusWave& wave, double guess_rad) {
  const double size = wave.segment<2>(1).norm() + 4.0 * wave.tail<2>().norm();
  constexpr double kFlat = 1e-9;  // of the mean: below that the wave is rounding about a constant
  if (!(size > kFlat * std::abs(wave(0)))) return std::nullopt;
  double t = guess_rad;
  for (int i = 0; i < 60; ++i) {
    const double bend = wave.dot(wave_bend(t));
    // Held back where the wave is nearly straight, so that the nearest extremum is found and not a
    // far one.
    const double step =
        -wave.dot(wave_slope(t)) / std::copysign(std::max(std::abs(bend), 0.05 * size), bend);
    t += step;
    if (std::abs(step) < 1e-15) break;
  }
  const bool at_extremum = std::abs(wave.dot(wave_slope(t))) <= 1e-9 * size &&
                           std::abs(wave.dot(wave_bend(t))) >= 1e-9 * size;
  return at_extremum ? std::optional(t) : std::nullopt;
}

}  // namespace armcal
