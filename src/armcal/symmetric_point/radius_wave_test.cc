// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/radius_wave.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/core/random.h"

namespace armcal {
namespace {

RadiusWave random_wave(std::uint64_t seed) {
  RandomStream stream(seed, 0);
  RadiusWave wave;
  for (double& c : wave) c = 1000.0 * (2.0 * stream.uniform() - 1.0);
  return wave;
}

RC_GTEST_PROP(RadiusWaves, FollowFromFiveValues, (std::uint64_t seed)) {
  const RadiusWave wave = random_wave(seed);
  const RadiusWave found = wave_of([&](double t) { return wave.dot(wave_basis(t)); });
  RC_ASSERT((found - wave).norm() < 1e-11);
}

RC_GTEST_PROP(RadiusWaves, AreLevelAtTheirExtrema, (std::uint64_t seed)) {
  const RadiusWave wave = random_wave(seed);
  const auto t = extremum_near(wave, 0.3);
  if (!t) return;  // the guess led to an inflection
  const double here = wave.dot(wave_basis(*t));
  const double before = wave.dot(wave_basis(*t - 1e-3));
  const double after = wave.dot(wave_basis(*t + 1e-3));
  RC_ASSERT((before - here) * (after - here) > 0.0);
}

TEST(RadiusWaves, HaveTheNearestExtremum) {
  const RadiusWave wave(5.0, 0.0, 0.0, 1.0, 0.0);  // cos 2t: extrema at multiples of 90 deg
  for (int k = -3; k <= 3; ++k) {
    const double at = k * std::numbers::pi / 2.0;
    EXPECT_NEAR(extremum_near(wave, at + 0.2).value(), at, 1e-12);
    EXPECT_NEAR(extremum_near(wave, at - 0.3).value(), at, 1e-12);
  }
}

TEST(RadiusWaves, HaveNoneWhenConstantOrOnlyLevellingOut) {
  EXPECT_FALSE(extremum_near(RadiusWave(5.0, 0.0, 0.0, 0.0, 0.0), 0.0).has_value());
  EXPECT_FALSE(extremum_near(RadiusWave(5.0, 1e-12, 0.0, 0.0, 0.0), 0.0).has_value());
}

}  // namespace
}  // namespace armcal
