// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/tip_rows.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

struct Case {
  ArmModel arm;
  Eigen::MatrixXd encoder_rad;
};

void expect_like_linearise(const Case& c, const std::vector<int>& parameters) {
  const ForwardKinematics kinematics(c.arm);
  const TipRows rows(c.arm, tip_columns(ParameterTable(c.arm), parameters));
  const PosturePacks postures(c.encoder_rad);
  const Eigen::Index count = c.encoder_rad.cols();
  const Eigen::Index stride = static_cast<Eigen::Index>(parameters.size()) + 3;
  std::vector<double> values(static_cast<std::size_t>(3 * count * stride), -7.0);
  Eigen::Matrix3Xd tips(3, count);
  rows.fill(postures, 0, count, {tips.data(), values.data(), stride});
  const double reach = reach_mm(c.arm);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd e = c.encoder_rad.col(k);
    const TipLinearisation at =
        kinematics.linearise({e.data(), static_cast<std::size_t>(e.size())});
    ASSERT_LT((tips.col(k) - at.tip_mm).norm(), 1e-13 * reach);
    for (Eigen::Index row = 0; row < 3; ++row) {
      const double* place = values.data() + (3 * k + row) * stride;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        ASSERT_NEAR(place[i], at.J_tip_parameters(row, parameters[i]), 1e-13 * reach) << i;
      }
      ASSERT_EQ(place[parameters.size()], -7.0);  // nothing beyond the columns
    }
  }
}

RC_GTEST_PROP(TipRowsOfRandomArms, AreThoseOfOnePostureAtATime, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  RandomStream random(seed, 0);
  const int joints = *rc::gen::inRange(2, 11);
  const Case c{testing::random_arm(joints, random),
               testing::random_postures(joints, *rc::gen::inRange(1, 30), random)};
  const ParameterTable table(c.arm);
  std::vector<int> all(static_cast<std::size_t>(table.size()));
  std::iota(all.begin(), all.end(), 0);
  expect_like_linearise(c, all);
  std::vector<int> some;
  for (const int index : all) {
    if (random.uniform() < 0.5) some.push_back(index);
  }
  expect_like_linearise(c, some);
}

TEST(TipRows, TakeHarmonicsOfAnySize) {
  RandomStream random(5, 0);
  Case c{testing::random_arm(6, random), testing::random_postures(6, 17, random)};
  c.arm.joints[1].harmonics = {{0.3, -0.2}, {0.01, 0.02}, {1e-5, 0.0}};
  c.arm.joints[4].harmonics = {{1e-4, 2e-4}};
  const ParameterTable table(c.arm);
  std::vector<int> all(static_cast<std::size_t>(table.size()));
  std::iota(all.begin(), all.end(), 0);
  expect_like_linearise(c, all);
}

TEST(TipRows, GiveTipsAloneFromTheMiddle) {
  RandomStream random(6, 0);
  const Case c{testing::random_arm(7, random), testing::random_postures(7, 29, random)};
  const TipRows rows(c.arm, {});
  Eigen::Matrix3Xd tips(3, 5);
  rows.fill(PosturePacks(c.encoder_rad), 16, 5, {tips.data(), nullptr, 0});
  const ForwardKinematics kinematics(c.arm);
  for (Eigen::Index k = 0; k < 5; ++k) {
    const Eigen::VectorXd e = c.encoder_rad.col(16 + k);
    EXPECT_LT((tips.col(k) - kinematics.tip_in_base({e.data(), 7})).norm(),
              1e-12 * reach_mm(c.arm));
  }
}

}  // namespace
}  // namespace armcal
