// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/wang2016.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/symmetric_point/chain.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

constexpr Wang2016Readings kTable1 = {352.968, 51.924, 104.070, 1115.683, 1298.633, 178.383};

TEST(Wang2016, ChainReproducesTable2WithTheReadingThatWasMeant) {
  Wang2016Readings readings = kTable1;
  readings.l_PP3 = 104.700;
  const Wang2016Parameters p = consistent_chain(readings);
  EXPECT_NEAR(p.a5, 78.312, 1e-9);
  EXPECT_NEAR(p.a7, 25.962, 1e-9);
  EXPECT_NEAR(p.b3, 747.489, 0.001);
  EXPECT_NEAR(p.b5, 531.880, 0.001);
  EXPECT_NEAR(p.b7, 176.484, 1e-9);
  EXPECT_EQ(p.d7, 0.0);
}

TEST(Wang2016, AsPrintedA5MissesBy0315) {
  const Wang2016Parameters p = consistent_chain(kTable1);
  EXPECT_NEAR(p.a5, 77.997, 1e-9);
  EXPECT_NEAR(p.b3, 747.8035, 1e-9);
}

TEST(Wang2016, LiteralChainCountsTheTipArmTwice) {
  const Wang2016Parameters p = literal_chain(kTable1);
  EXPECT_EQ(p.b7, 178.383);
  EXPECT_EQ(p.d7, 176.484);
  EXPECT_NEAR(std::hypot(p.a7, p.d7), p.b7, 0.0005);
}

TEST(Wang2016, GeneralChainAgreesWithThePapersEquations) {
  const Chain chain = solve_chain(testing::nominal_romer(), testing::wang2016_readings());
  ASSERT_TRUE(chain.complete) << chain.problem;
  Wang2016Readings readings = kTable1;
  readings.l_PP3 = 104.700;
  const Wang2016Parameters p = consistent_chain(readings);
  EXPECT_NEAR(chain.arm.links[3].a_mm, p.a5, 1e-9);
  EXPECT_NEAR(-chain.arm.tip.a_mm, p.a7, 1e-9);
  EXPECT_NEAR(chain.arm.links[1].b_mm, p.b3, 1e-9);
  EXPECT_NEAR(chain.arm.links[3].b_mm, p.b5, 1e-9);
  EXPECT_NEAR(chain.arm.tip.b_mm, p.b7, 1e-9);
}

}  // namespace
}  // namespace armcal
