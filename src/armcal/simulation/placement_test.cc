// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/simulation/artefacts/ball_bar.h"
#include "armcal/simulation/artefacts/cone_seat.h"
#include "armcal/simulation/artefacts/feature_artefact.h"
#include "armcal/simulation/artefacts/flat_surface.h"
#include "armcal/simulation/artefacts/sphere_plate.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

constexpr Surroundings kBenchAndColumn{
    .column_radius_mm = 80.0, .column_top_mm = 100.0, .bench_mm = -200.0};

Laboratory laboratory_with(const Surroundings& surroundings, std::uint64_t seed,
                           const RigidTransform& base_from_first_joint = {}) {
  ArmModel arm = testing::nominal_romer();
  arm.base_from_first_joint = base_from_first_joint;
  return {VirtualArm(arm, arm, {}, 1, surroundings), seed};
}

template <class Thing>
std::string refusal(const Thing& thing, const Surroundings& surroundings) {
  Laboratory laboratory = laboratory_with(surroundings, 5);
  try {
    static_cast<void>(measure(laboratory, thing));
  } catch (const Impossible& impossible) {
    return impossible.what();
  }
  return "measured";
}

TEST(Placement, IsAboveTheBenchAndOutsideTheColumnWhereverTheArmStands) {
  RandomStream random(1, 0);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Laboratory laboratory =
        laboratory_with(kBenchAndColumn, seed, testing::random_transform(random, 500.0));
    const Solid bar = row_of_features("bar", "S", 7, 150.0);
    const RigidTransform base_from_bar = place_within_reach(laboratory, bar);
    const RigidTransform first_joint_from_bar =
        laboratory.arm().truth().base_from_first_joint.inverse() * base_from_bar;
    EXPECT_NEAR((bar.body_mm.back() - bar.body_mm.front()).norm(), 900.0, 1e-9);
    for (const Eigen::Vector3d& point : bar.body_mm) {
      const Eigen::Vector3d p = first_joint_from_bar * point;
      EXPECT_GE(p.z(), -200.0);
      EXPECT_TRUE(p.z() >= 100.0 || std::hypot(p.x(), p.y()) >= 80.0) << p.transpose();
    }
    for (const Feature& feature : bar.features) {
      EXPECT_EQ(
          laboratory.postures_with_tip_at(base_from_bar * feature.at_mm, 5, feature.name).size(),
          5u);
    }
  }
}

TEST(Placement, DependsOnTheSeedAndTheMeasurementAlone) {
  const Solid seat{.name = "seat", .features = {{"seat"}}};
  const auto place = [&](std::uint64_t seed, int measurement) {
    Laboratory laboratory = laboratory_with(kBenchAndColumn, seed);
    static_cast<void>(laboratory.free_posture());
    laboratory.begin(measurement);
    return place_within_reach(laboratory, seat).translation_mm;
  };
  EXPECT_EQ(place(1, 1), place(1, 1));
  EXPECT_NE(place(1, 1), place(1, 2));
  EXPECT_NE(place(1, 1), place(2, 1));
}

TEST(Placement, RefusesWhatIsLongerThanTheArmReaches) {
  EXPECT_THAT(refusal(BallBar{.length_mm = 3000.0}, {}),
              ::testing::MatchesRegex("ball-bar-1 does not fit within reach: even in the best of "
                                      "300 places [AB] at \\(.*\\) mm is beyond the reach of "
                                      "1463 mm"));
}

TEST(Placement, RefusesWhatWouldStickInTheBenchOrTheColumn) {
  // A plate as large as the room that the arm reaches, about a column that stands through it.
  const Surroundings column{.column_radius_mm = 300.0, .column_top_mm = 5000.0};
  EXPECT_THAT(refusal(SpherePlate{.pitch_mm = 850.0}, column),
              ::testing::MatchesRegex("plate-. does not fit within reach: even in the best of 300 "
                                      "places its body at .* mm is inside the column, [0-9.]+ mm "
                                      "from the first axis"));
  const Surroundings high_bench{.bench_mm = 900.0};
  EXPECT_THAT(refusal(FlatSurface{.size_mm = 1500.0}, high_bench),
              ::testing::HasSubstr(" mm below the bench"));
}

TEST(Placement, RefusesAnArmThatCannotStandAnywhere) {
  const Surroundings roof{.bench_mm = 2000.0};
  EXPECT_THAT(refusal(ConeSeat{}, roof), ::testing::HasSubstr("below the bench"));
}

TEST(Obstruction, SaysHowDeep) {
  const Laboratory laboratory = laboratory_with(kBenchAndColumn, 1);
  const VirtualArm& arm = laboratory.arm();
  EXPECT_EQ(obstruction(arm, {500.0, 0.0, -212.3}), "12.3 mm below the bench");
  EXPECT_EQ(obstruction(arm, {30.0, 40.0, 0.0}), "inside the column, 50.0 mm from the first axis");
  EXPECT_EQ(obstruction(arm, {30.0, 40.0, 101.0}), std::nullopt);  // above its top
  EXPECT_EQ(obstruction(arm, {500.0, 0.0, 0.0}), std::nullopt);
}

TEST(Bodies, HaveNoGapsThatAColumnFitsThrough) {
  const auto plate = plate_body(300.0, 200.0);
  const auto nearest = [&](const Eigen::Vector3d& point) {
    double least = 1e9;
    for (const auto& each : plate) least = std::min(least, (each - point).norm());
    return least;
  };
  RandomStream random(2, 0);
  for (int i = 0; i < 200; ++i) {
    EXPECT_LT(nearest({random.uniform(-150.0, 150.0), random.uniform(-100.0, 100.0), 0.0}), 15.0);
  }
  EXPECT_GT(nearest({170.0, 0.0, 0.0}), 15.0);
  EXPECT_EQ(bar_body(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()).size(), 1u);
}

}  // namespace
}  // namespace armcal
