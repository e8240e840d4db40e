// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/reading_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/derivative_check.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

Eigen::VectorXd random_angles(int n, RandomStream& random) {
  const auto posture = testing::random_posture(n, random);
  return Eigen::Map<const Eigen::VectorXd>(posture.data(), n);
}

// Gradient by differences of the value alone.
Eigen::MatrixXd gradient_by_differences(const ArmModel& arm, const SymmetricReading& reading) {
  const ParameterTable table(arm);
  Eigen::VectorXd steps(table.size());
  for (int i = 0; i < table.size(); ++i) {
    steps(i) = table[i].unit == ParameterUnit::mm ? 1.0 : 2e-3;
  }
  return jacobian_by_differences(
      [&](const Eigen::VectorXd& x) {
        return Eigen::VectorXd::Constant(1, predict(with_parameter_values(arm, x), reading).value);
      },
      parameter_values(arm), steps);
}

TEST(ReadingModel, ConsistentArmReproducesEveryReadingOfThePaper) {
  // Table 1 is rounded to 0.001 mm; l_PP4 and l_PP5 come out at the edge of that.
  for (const SymmetricReading& reading : testing::wang2016_readings()) {
    EXPECT_NEAR(predict(testing::consistent_romer(), reading).value, reading.value, 0.001 + 1e-9)
        << reading.name;
  }
}

TEST(ReadingModel, PrintedArmMissesByHundredsOfMillimetres) {
  double worst = 0.0;
  for (const SymmetricReading& reading : testing::wang2016_readings()) {
    worst =
        std::max(worst, std::abs(predict(testing::printed_romer(), reading).value - reading.value));
  }
  EXPECT_GT(worst, 300.0);
}

TEST(ReadingModel, ReversalIsTheDistanceOfTheTwoTips) {
  RandomStream random(1);
  const ArmModel arm = testing::random_arm(6, random);
  SymmetricReading reading = testing::reversal("r", 3, random_angles(6, random));
  reading.posture_end_rad = random_angles(6, random);  // any two postures
  const ForwardKinematics kinematics(arm);
  const auto tip = [&](const Eigen::VectorXd& q) { return kinematics.tip_in_base(as_span(q)); };
  EXPECT_NEAR(predict(arm, reading).value,
              (tip(reading.posture_rad) - tip(reading.posture_end_rad)).norm(), 1e-11);
}

TEST(ReadingModel, HalfTurnIsTwiceTheCircleRadius) {
  RandomStream random(2);
  for (int joint = 1; joint <= 6; ++joint) {
    const ArmModel arm = testing::random_arm(6, random, {.harmonics = 0});
    const Eigen::VectorXd posture = random_angles(6, random);
    EXPECT_NEAR(predict(arm, testing::reversal("l", joint, posture)).value,
                2.0 * predict(arm, testing::circle_radius("r", joint, posture)).value, 1e-10);
  }
}

TEST(ReadingModel, GradientsOfDistancesAreExact) {
  RandomStream random(3);
  for (int n = 2; n <= 8; ++n) {
    const ArmModel arm = testing::random_arm(n, random);
    for (int joint = 1; joint <= n; ++joint) {
      const Eigen::VectorXd posture = random_angles(n, random);
      for (const SymmetricReading& reading :
           {testing::reversal("l", joint, posture), testing::circle_radius("r", joint, posture)}) {
        const ReadingPrediction prediction = predict(arm, reading);
        const Eigen::MatrixXd reference = gradient_by_differences(arm, reading);
        // Differences of values of 1000 mm reach 1e-9 of the largest entry.
        EXPECT_LT((prediction.gradient.transpose() - reference).lpNorm<Eigen::Infinity>(),
                  1e-8 * reference.lpNorm<Eigen::Infinity>())
            << to_string(reading.kind) << " joint " << joint << " of " << n;
      }
    }
  }
}

TEST(ReadingModel, ZeroSearchFindsTheExtremumOfTheRadius) {
  RandomStream random(4);
  for (int trial = 0; trial < 30; ++trial) {
    const ArmModel arm = testing::random_arm(6, random);
    SymmetricReading search = testing::circle_radius("z", 4, random_angles(6, random));
    search.kind = SymmetricKind::zero_search;
    search.sweep = 1 + static_cast<int>(random.below(3));
    search.reduced = false;
    const double setting = predict(arm, search).value;
    ASSERT_TRUE(std::isfinite(setting));
    SymmetricReading radius = testing::circle_radius("r", search.sweep, search.posture_rad);
    const auto radius_at = [&](double e) {
      radius.posture_rad(3) = e;
      return predict(arm, radius).value;
    };
    const double step = 1e-3;
    const double slope = (radius_at(setting + step) - radius_at(setting - step)) / (2 * step);
    const double bend =
        (radius_at(setting + step) - 2 * radius_at(setting) + radius_at(setting - step)) /
        (step * step);
    EXPECT_LT(std::abs(slope / bend), 1e-5);
  }
}

TEST(ReadingModel, GradientOfAZeroSearchIsExact) {
  RandomStream random(5);
  for (int trial = 0; trial < 10; ++trial) {
    const ArmModel arm = testing::random_arm(6, random);
    SymmetricReading search = testing::circle_radius("z", 6, random_angles(6, random));
    search.kind = SymmetricKind::zero_search;
    search.sweep = 2 + static_cast<int>(random.below(4));
    search.reduced = false;
    search.value = predict(arm, search).value;
    search.reduced = true;
    const ReadingPrediction prediction = predict(arm, search);
    const Eigen::MatrixXd reference = gradient_by_differences(arm, search);
    EXPECT_LT((prediction.gradient.transpose() - reference).lpNorm<Eigen::Infinity>(),
              1e-7 * reference.lpNorm<Eigen::Infinity>());
  }
}

TEST(ReadingModel, ZeroSearchOfTheLastJointFollowsItsZeroOffset) {
  // rho_5^2 = d_t^2 + (r sin(e - phi))^2: least where the tip arm points along axis 5.
  ArmModel arm = testing::consistent_romer();
  SymmetricReading search = testing::circle_radius("z6", 6, testing::degrees({0, 0, 0, 0, 0, 5}));
  search.kind = SymmetricKind::zero_search;
  search.sweep = 5;
  search.reduced = false;
  const double phi = std::atan2(-25.962, 176.484);  // of the tip against the y axis
  EXPECT_NEAR(predict(arm, search).value, phi, 1e-12);
  arm.joints[5].zero_rad = 0.01;
  EXPECT_NEAR(predict(arm, search).value, phi - 0.01, 1e-12);
}

// It used to be no number, and was printed as such beside an arm with its tip on the last axis.
TEST(ReadingModel, ATipOnTheAxisHasRadiusZeroAndNoGradient) {
  ArmModel arm = testing::consistent_romer();
  arm.tip = Tip{.d_mm = 100.0};  // on the last axis
  const Eigen::VectorXd posture = testing::degrees({0, 0, 0, 0, 0, 0});
  for (const auto& reading :
       {testing::circle_radius("r", 6, posture), testing::reversal("l", 6, posture)}) {
    const ReadingPrediction prediction = predict(arm, reading);
    EXPECT_EQ(prediction.value, 0.0) << reading.name;
    EXPECT_TRUE(prediction.gradient.array().isNaN().all()) << reading.name;
  }
}

}  // namespace
}  // namespace armcal
