// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

TEST(GeometryErrors, OffLeaveTheDrawing) {
  const ArmModel nominal = testing::nominal_romer();
  RandomStream random(1);
  EXPECT_EQ(parameter_values(drawn_arm(nominal, {}, random)), parameter_values(nominal));
}

TEST(GeometryErrors, LeaveWhatIsAConvention) {
  const ArmModel nominal = testing::nominal_romer();
  RandomStream random(1);
  const ArmModel drawn = drawn_arm(nominal, GeometryErrors::typical(), random);
  EXPECT_EQ(drawn.joints[0].zero_rad, 0.0);
  EXPECT_EQ(drawn.links[0].d_mm, 0.0);
  EXPECT_EQ(drawn.links[1].beta_rad, 0.0);
  EXPECT_NE(drawn.links[1].b_mm, nominal.links[1].b_mm);
}

TEST(GeometryErrors, HaveTheStatedSizes) {
  const ArmModel nominal = testing::nominal_romer();
  const ParameterTable table(nominal);
  const GeometryErrors errors = GeometryErrors::typical();
  const auto mean_square = [&](const char* name) {
    const int index = *table.find(name);
    double sum = 0.0;
    constexpr int kArms = 500;
    for (std::uint64_t seed = 0; seed < kArms; ++seed) {
      RandomStream random(seed);
      const double off = parameter_values(drawn_arm(nominal, errors, random))(index) -
                         parameter_values(nominal)(index);
      sum += off * off;
    }
    return std::sqrt(sum / kArms);
  };
  // The standard deviation of 500 is known to 3 %.
  EXPECT_NEAR(mean_square("alpha3") / errors.u_twist_rad, 1.0, 0.12);
  EXPECT_NEAR(mean_square("zero4") / errors.u_zero_rad, 1.0, 0.12);
  EXPECT_NEAR(mean_square("a3") / errors.u_offset_mm, 1.0, 0.12);
  EXPECT_NEAR(mean_square("b3") / errors.u_length_mm, 1.0, 0.12);
}

}  // namespace
}  // namespace armcal
