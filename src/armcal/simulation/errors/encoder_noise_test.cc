// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/encoder_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace armcal {
namespace {

TEST(EncoderNoise, OffShowsTheAngleAndDrawsNothing) {
  RandomStream random(1);
  EXPECT_EQ(shown_reading(0.123456789, {}, random), 0.123456789);
  EXPECT_EQ(random.bits(), RandomStream(1).bits());
}

TEST(EncoderNoise, ShowsWholeSteps) {
  RandomStream random(1);
  EXPECT_DOUBLE_EQ(shown_reading(0.0124, {.step_rad = 0.005}, random), 0.010);
  EXPECT_DOUBLE_EQ(shown_reading(-0.0126, {.step_rad = 0.005}, random), -0.015);
}

TEST(EncoderNoise, HasTheStatedStandardDeviation) {
  RandomStream random(1);
  const EncoderNoise noise{.u_rad = 1e-5, .step_rad = 2e-5};
  double sum = 0.0;
  double sum2 = 0.0;
  constexpr int kReadings = 20000;
  for (int i = 0; i < kReadings; ++i) {
    const double angle = 1e-3 * i;
    const double off = shown_reading(angle, noise, random) - angle;
    sum += off;
    sum2 += off * off;
  }
  // Noise and a rectangle of one step together; 20,000 readings know both to 1 %.
  EXPECT_NEAR(sum / kReadings, 0.0, 4e-7);
  EXPECT_NEAR(noise.u_reading_rad(), std::sqrt(1e-10 + 4e-10 / 12.0), 1e-15);
  EXPECT_NEAR(std::sqrt(sum2 / kReadings), noise.u_reading_rad(), 3e-7);
}

}  // namespace
}  // namespace armcal
