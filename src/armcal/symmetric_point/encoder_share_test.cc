// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/encoder_share.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/core/random.h"
#include "armcal/core/units.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::consistent_romer;
using testing::degrees;

const double kTwoArcsec = radians_from_arcseconds(2.0);

SymmetricReading half_turn() {
  return testing::reversal("h", 3, degrees({10, 20, 30, 80, 50, -60}));
}

// Standard deviation of the predicted value when every recorded angle is off by chance.
double scatter(const SymmetricReading& reading, bool ends_apart) {
  RandomStream random(4);
  constexpr int kTrials = 20000;
  const auto errors = [&] {
    Eigen::VectorXd all(6);
    for (double& each : all) each = kTwoArcsec * random.normal();
    return all;
  };
  const double expected = predict(consistent_romer(), reading).value;
  double squares = 0.0;
  for (int i = 0; i < kTrials; ++i) {
    SymmetricReading off = reading;
    const Eigen::VectorXd at_posture = errors();
    off.posture_rad += at_posture;
    off.posture_end_rad += ends_apart ? errors() : at_posture;
    squares += std::pow(predict(consistent_romer(), off).value - expected, 2);
  }
  return std::sqrt(squares / kTrials);
}

TEST(EncoderShare, IsTheScatterThatEncodersCause) {
  const SymmetricReading reading = half_turn();
  // 20000 trials: 0.5 %.
  EXPECT_NEAR(
      u_from_encoders(consistent_romer(), reading, kTwoArcsec, {1, 1}) / scatter(reading, true),
      1.0, 0.02);
  EXPECT_NEAR(
      u_from_encoders(consistent_romer(), reading, kTwoArcsec, {1, 0}) / scatter(reading, false),
      1.0, 0.02);
  SymmetricReading circle = testing::circle_radius("c", 3, reading.posture_rad);
  EXPECT_NEAR(
      u_from_encoders(consistent_romer(), circle, kTwoArcsec, {1, 0}) / scatter(circle, false), 1.0,
      0.02);
}

TEST(EncoderShare, RepeatsAverage) {
  const double once = u_from_encoders(consistent_romer(), half_turn(), kTwoArcsec, {1, 1});
  const double nine = u_from_encoders(consistent_romer(), half_turn(), kTwoArcsec, {9, 9});
  EXPECT_NEAR(once / nine, 3.0, 1e-12);
}

// Read once for both ends, only joints behind the one that turns matter: those before it carry
// both tips along, and a half turn is the longest distance.
TEST(EncoderShare, OfOneReadingOnlyJointsBehindCount) {
  EXPECT_NEAR(u_from_encoders(consistent_romer(),
                              testing::reversal("h", 6, degrees({10, 20, 30, 80, 50, -60})),
                              kTwoArcsec, {1, 0}),
              0.0, 1e-12);
  EXPECT_GT(u_from_encoders(consistent_romer(), half_turn(), kTwoArcsec, {1, 0}), 1e-3);
}

TEST(EncoderShare, ExactEncodersAddNothing) {
  EXPECT_EQ(u_from_encoders(consistent_romer(), half_turn(), 0.0, {1, 1}), 0.0);
}

}  // namespace
}  // namespace armcal
