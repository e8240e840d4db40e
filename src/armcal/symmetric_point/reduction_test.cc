// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/reduction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/units.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

// A reference machine that stands anywhere and has noise.
struct Machine {
  RigidTransform machine_from_base;
  double sigma_mm;
  RandomStream random;

  Eigen::Vector3d point(const ArmModel& arm, const Eigen::VectorXd& q) {
    const Eigen::Vector3d tip = ForwardKinematics(arm).tip_in_base({q.data(), 6});
    return machine_from_base * tip + testing::random_normal_vector(random, sigma_mm);
  }
};

Machine machine(std::uint64_t seed, double sigma_mm) {
  RandomStream random(seed);
  const RigidTransform pose = testing::random_transform(random, 500);
  return {pose, sigma_mm, random};
}

SymmetricReading raw_reading(SymmetricReading reading) {
  reading.reduced = false;
  reading.u = 0.0;
  reading.raw = RawSymmetricPoints{.file = "points.csv"};
  return reading;
}

void add(SymmetricReading& reading, const Eigen::Vector3d& point, char end = 0,
         double setting = std::numeric_limits<double>::quiet_NaN()) {
  RawSymmetricPoints& raw = *reading.raw;
  raw.points_mm.push_back(point);
  if (end != 0) raw.end.push_back(end);
  if (std::isfinite(setting)) raw.setting_rad.push_back(setting);
  raw.lines.push_back(static_cast<int>(raw.points_mm.size()) + 1);
}

void add_encoder(SymmetricReading& reading, const Eigen::VectorXd& q) {
  Eigen::MatrixXd& all = reading.raw->encoder_rad;
  all.conservativeResize(q.size(), all.cols() + 1);
  all.col(all.cols() - 1) = q;
}

TEST(Reduction, ReversalTakesMeansSpreadAndUncertainty) {
  auto reading = raw_reading(testing::reversal("l", 5, testing::degrees({0, 0, 0, 0, 0, -90})));
  for (const double x : {-0.01, 0.01}) add(reading, {x, 5, 5}, 'A');
  for (const double x : {100.0, 100.02, 100.04}) add(reading, {x, 5, 5}, 'B');
  Diagnostics diagnostics;
  const auto result = reduce(reading, testing::nominal_romer(), diagnostics);
  ASSERT_TRUE(result.has_value());
  EXPECT_NEAR(result->reading.value, 100.02, 1e-12);
  EXPECT_NEAR(result->reduction.end_a->s_mm, std::sqrt(0.0002), 1e-12);
  EXPECT_NEAR(result->reduction.end_b->s_mm, 0.02, 1e-12);
  const double pooled = (0.0002 + 2 * 0.0004) / 3;
  EXPECT_NEAR(result->reading.u, std::sqrt(pooled / 2 + pooled / 3), 1e-12);
  EXPECT_EQ(result->reduction.half_turn_rad, pi);
}

TEST(Reduction, TypeBOfTheFileIsAddedInQuadrature) {
  auto reading = raw_reading(testing::reversal("l", 5, testing::degrees({0, 0, 0, 0, 0, -90})));
  reading.u = 0.004;
  add(reading, {0, 0, 0}, 'A');
  add(reading, {100, 0, 0}, 'B');
  Diagnostics diagnostics;
  EXPECT_NEAR(reduce(reading, testing::nominal_romer(), diagnostics)->reading.u, 0.004, 1e-15);
}

TEST(Reduction, UsesTheEncodersOwnAnglesAndTellsSlip) {
  // The half turn is 179 deg and joint 2 slips by 0.03 deg: with the encoders' word for it the
  // model still fits.
  const ArmModel arm = testing::consistent_romer();
  Machine cmm = machine(1, 0.0);
  Eigen::VectorXd before = testing::degrees({0, 20, 0, 30, 0, -90});
  Eigen::VectorXd after = testing::degrees({0, 20.03, 0, 30, 179, -90});
  auto reading = raw_reading(testing::reversal("l", 5, before));
  reading.u = 0.001;
  for (const auto& [q, end] : {std::pair{before, 'A'}, std::pair{after, 'B'}}) {
    add(reading, cmm.point(arm, q), end);
    add_encoder(reading, q);
  }
  Diagnostics diagnostics;
  const auto result = reduce(reading, arm, diagnostics);
  ASSERT_TRUE(result.has_value());
  EXPECT_NEAR(degrees_from_radians(result->reduction.half_turn_rad), 179.0, 1e-9);
  EXPECT_NEAR(degrees_from_radians(result->reduction.largest_slip_rad), 0.03, 1e-9);
  EXPECT_NEAR(predict(arm, result->reading).value, result->reading.value, 1e-9);
}

TEST(Reduction, ArcGivesRadiusAxisAndUncertainty) {
  const ArmModel arm = testing::consistent_romer();
  Machine cmm = machine(2, 0.003);
  auto reading = raw_reading(testing::circle_radius("R", 6, Eigen::VectorXd::Zero(6)));
  for (int i = 0; i < 24; ++i) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q(5) = 2 * pi * i / 24;
    add(reading, cmm.point(arm, q));
  }
  Diagnostics diagnostics;
  const auto result = reduce(reading, arm, diagnostics);
  ASSERT_TRUE(result.has_value());
  EXPECT_NEAR(result->reading.value, 178.3834, 5 * result->reading.u);
  EXPECT_NEAR(result->reading.u, 0.003 / std::sqrt(12.0) / std::sqrt(2.0) * 1.4, 0.0005);
  // The axis is that of joint 6, seen by the machine.
  const std::vector<double> zeros(6, 0.0);
  const Eigen::Vector3d axis =
      cmm.machine_from_base.rotation * ForwardKinematics(arm).linearise(zeros).joint_axes.col(5);
  EXPECT_LT(result->reduction.arc->normal.cross(axis).norm(), 1e-4);
}

TEST(Reduction, ZeroSearchFromArcsAndFromHalfTurns) {
  ArmModel arm = testing::consistent_romer();
  arm.joints[3].zero_rad = 0.004;
  for (const bool by_half_turns : {false, true}) {
    Machine cmm = machine(3, 0.002);
    SymmetricReading search = testing::circle_radius("z4", 4, Eigen::VectorXd::Zero(6));
    search.kind = SymmetricKind::zero_search;
    search.sweep = 3;
    search.posture_rad = testing::degrees({0, 0, 0, 0, 0, -90});
    search.reduced = false;
    search.posture_rad(3) = predict(arm, search).value;
    const double expected = search.posture_rad(3);
    search.posture_rad(3) = expected + 0.02;
    auto reading = raw_reading(search);
    for (const double setting_deg : {-20., -12., -5., 3., 9., 15., 21.}) {
      Eigen::VectorXd q = reading.posture_rad;
      q(3) = expected + radians_from_degrees(setting_deg);
      for (int i = 0; i < 8; ++i) {
        q(2) = by_half_turns ? (i % 2) * pi : 0.6 * i;
        const double flicker = radians_from_degrees(0.002) * cmm.random.normal();
        add(reading, cmm.point(arm, q), by_half_turns ? (i % 2 == 0 ? 'A' : 'B') : 0,
            q(3) + flicker);
      }
    }
    Diagnostics diagnostics;
    const auto result = reduce(reading, testing::consistent_romer(), diagnostics);
    ASSERT_TRUE(result.has_value()) << diagnostics.to_text();
    EXPECT_EQ(result->reduction.radii.size(), 7u);
    EXPECT_LT(std::abs(result->reading.value - expected), 5 * result->reading.u);
    EXPECT_LT(result->reading.u, 5e-4);
  }
}

TEST(Reduction, SaysWhatIsMissing) {
  const ArmModel arm = testing::nominal_romer();
  auto reading = raw_reading(testing::reversal("l_PP1", 5, Eigen::VectorXd::Zero(6)));
  reading.where = {"procedure.toml", 12, 1};
  add(reading, {0, 0, 0}, 'A');
  {
    Diagnostics diagnostics;
    EXPECT_FALSE(reduce(reading, arm, diagnostics).has_value());
    EXPECT_THAT(diagnostics.to_text(), HasSubstr("points.csv: error: no point at end B"));
  }
  add(reading, {100, 0, 0}, 'B');
  {
    Diagnostics diagnostics;
    EXPECT_FALSE(reduce(reading, arm, diagnostics).has_value());
    EXPECT_THAT(diagnostics.to_text(),
                HasSubstr("procedure.toml:12:1: error: reading \"l_PP1\" has no uncertainty"));
  }
  auto arc = raw_reading(testing::circle_radius("R", 6, Eigen::VectorXd::Zero(6)));
  for (int i = 0; i < 5; ++i) add(arc, {1.0 * i, 0, 0});
  Diagnostics diagnostics;
  EXPECT_FALSE(reduce(arc, arm, diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("circle of reading \"R\": the points lie on one line"));
}

// A repeat 10 mm off went into the mean in silence and blew up the uncertainty instead.
TEST(Reduction, WarnsOfABlunderAmongRepeatsWithItsLine) {
  auto reading = raw_reading(testing::reversal("l", 5, testing::degrees({0, 0, 0, 0, 0, -90})));
  for (const double x : {-0.001, 0.001, 0.0}) add(reading, {x, 5, 5}, 'A');
  for (const double x : {100.0, 100.001, 110.0}) add(reading, {x, 5, 5}, 'B');
  Diagnostics diagnostics;
  ASSERT_TRUE(reduce(reading, testing::nominal_romer(), diagnostics).has_value());
  EXPECT_THAT(
      diagnostics.to_text(),
      HasSubstr("points.csv:7: warning: lies 9.999 mm off the middle of the 3 repeats of end "
                "B; others lie 0.001 mm off"));
  EXPECT_EQ(diagnostics.entries().size(), 1u);
}

TEST(Reduction, WarnsOfABlunderOnAnArcWithItsLine) {
  const ArmModel arm = testing::consistent_romer();
  Machine cmm = machine(7, 0.002);
  auto reading = raw_reading(testing::circle_radius("R", 6, Eigen::VectorXd::Zero(6)));
  for (int i = 0; i < 18; ++i) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q(5) = 0.3 * i;
    add(reading,
        cmm.point(arm, q) + (i == 4 ? Eigen::Vector3d(0, 0, 10) : Eigen::Vector3d(0, 0, 0)));
  }
  Diagnostics diagnostics;
  ASSERT_TRUE(reduce(reading, arm, diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("points.csv:6: warning: lies "));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("mm off the circle of the other points of its arc"));
  EXPECT_EQ(diagnostics.entries().size(), 1u);
}

// The slip stood in the JSON only.
TEST(Reduction, WarnsOfALockedJointThatMoved) {
  Eigen::VectorXd before = testing::degrees({0, 20, 0, 30, 0, -90});
  Eigen::VectorXd after = testing::degrees({0, 19.5, 0, 30, 180, -90});
  auto reading = raw_reading(testing::reversal("l", 5, before));
  reading.u = 0.001;
  add(reading, {0, 0, 0}, 'A');
  add_encoder(reading, before);
  add(reading, {100, 0, 0}, 'B');
  add_encoder(reading, after);
  Diagnostics diagnostics;
  ASSERT_TRUE(reduce(reading, testing::nominal_romer(), diagnostics).has_value());
  EXPECT_THAT(
      diagnostics.to_text(),
      HasSubstr("points.csv: warning: joint 2 moved by -0.500 deg between the ends of reading "
                "\"l\": its distance is not of a half turn of joint 5 alone"));
}

TEST(Reduction, ReducedReadingsPassThrough) {
  Diagnostics diagnostics;
  const auto reading = testing::wang2016_readings()[0];
  const auto result = reduce(reading, testing::nominal_romer(), diagnostics);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->reading.value, reading.value);
  EXPECT_EQ(result->reading.u, reading.u);
}

}  // namespace
}  // namespace armcal
