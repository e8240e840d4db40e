// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace armcal {

/// How the squared radius of the tip about a lower axis depends on the angle t of a joint: exactly
///   c0 + c1 cos t + s1 sin t + c2 cos 2t + s2 sin 2t,   theory/symmetric_point.md eq. (20).
/// A wave is the vector (c0, c1, s1, c2, s2), mm^2; its value, slope and bend at t are its products
/// with these three.
using RadiusWave = Eigen::Matrix<double, 5, 1>;
[[nodiscard]] RadiusWave wave_basis(double t);
[[nodiscard]] RadiusWave wave_slope(double t);
[[nodiscard]] RadiusWave wave_bend(double t);

/// Five values at equal steps determine a wave: wave = sum over k of f(t_k) * wave_weights(k), t_k
/// = wave_sample(k).
inline constexpr int kWaveSamples = 5;
[[nodiscard]] double wave_sample(int k);
[[nodiscard]] RadiusWave wave_weights(int k);

[[nodiscard]] RadiusWave wave_of(const std::function<double(double)>& squared_radius);

/// The extremum nearest to `guess_rad`; nothing where the wave is a constant but for rounding, or
/// only levels out.
[[nodiscard]] std::optional<double> extremum_near(const RadiusWave& wave, double guess_rad);

}  // namespace armcal
