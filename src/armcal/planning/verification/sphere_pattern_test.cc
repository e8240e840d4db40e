// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/sphere_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/units.h"

namespace armcal {
namespace {

const Eigen::Vector3d kPole = Eigen::Vector3d(1.0, -2.0, 3.0).normalized();

// 1e-12: rounding of sines and cosines.
TEST(SpherePattern, PointsLieOnTheHalfAboutThePole) {
  for (const auto& pattern : {pattern_of_25(kPole), pattern_of_9(kPole), pattern_of_5(kPole)}) {
    EXPECT_EQ(pattern.front(), kPole);
    for (const Eigen::Vector3d& direction : pattern) {
      EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
      EXPECT_GE(direction.dot(kPole), -1e-12);
    }
  }
  EXPECT_EQ(pattern_of_25(kPole).size(), 25u);
  EXPECT_EQ(pattern_of_9(kPole).size(), 9u);
  EXPECT_EQ(pattern_of_5(kPole).size(), 5u);
}

TEST(SpherePattern, RingsOf25StandAtTheirAngles) {
  const auto pattern = pattern_of_25(kPole);
  const auto at = [&](double deg) {
    return std::count_if(pattern.begin(), pattern.end(), [&](const Eigen::Vector3d& direction) {
      return std::abs(direction.dot(kPole) - std::cos(radians_from_degrees(deg))) < 1e-12;
    });
  };
  EXPECT_EQ(at(0.0), 1);
  EXPECT_EQ(at(22.5), 4);
  EXPECT_EQ(at(45.0), 8);
  EXPECT_EQ(at(67.5), 4);
  EXPECT_EQ(at(90.0), 8);
}

// Points that stood behind each other would see the same errors: neighbours are 19 deg apart at
// least (those of two rings of four and eight, 22.5 deg apart and turned by 22.5 deg).
TEST(SpherePattern, PointsStandApart) {
  const auto pattern = pattern_of_25(kPole);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_LT(pattern[i].dot(pattern[k]), std::cos(radians_from_degrees(19.0)));
    }
  }
}

TEST(SpherePattern, TheTipTouchesWithItsBall) {
  const SphereToProbe sphere{{100.0, 200.0, 300.0}, 12.5, 3.0};
  const Touch touch = sphere.touch(Eigen::Vector3d::UnitZ());
  EXPECT_EQ(touch.tip_mm, Eigen::Vector3d(100.0, 200.0, 315.5));
  EXPECT_EQ(touch.outward, Eigen::Vector3d::UnitZ());
}

}  // namespace
}  // namespace armcal
