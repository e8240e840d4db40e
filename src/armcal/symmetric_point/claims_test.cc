// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/claims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/wang2016_arm.h"
#include "armcal/testing/wang2016_unknowns.h"

namespace armcal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

std::vector<ClaimCheck> check(const std::vector<SymmetricReading>& readings,
                              const std::vector<Claim>& claims) {
  const ArmModel nominal = testing::nominal_romer();
  const AdjustmentOptions options = testing::papers_five();
  return check_claims(nominal, readings, options, adjust(nominal, readings, options), claims);
}

const ClaimCheck& of(const std::vector<ClaimCheck>& checks, const std::string& name) {
  for (const ClaimCheck& check : checks) {
    if (check.name == name) return check;
  }
  throw std::out_of_range(name);
}

TEST(Claims, Table2AgainstTable1NamesLPP3AndTheValueThatWasMeant) {
  const auto checks = check(testing::wang2016_readings(104.070), testing::wang2016_claims());
  for (const char* name : {"a5", "b3"}) {
    EXPECT_FALSE(of(checks, name).agrees);
    EXPECT_EQ(of(checks, name).contradicted_by, "l_PP3") << name;
    EXPECT_NEAR(of(checks, name).reconciled_by.value(), 104.700, 1e-6) << name;
  }
  EXPECT_NEAR(of(checks, "a5").value, 77.997, 0.001);
  EXPECT_NEAR(of(checks, "a5").difference, 0.315, 0.001);
  EXPECT_TRUE(of(checks, "b5").agrees);
  // No other reading is accused.
  for (const ClaimCheck& claim : checks) {
    EXPECT_EQ(claim.contradicted_by.value_or("l_PP3"), "l_PP3");
  }
}

TEST(Claims, SignsAreForgivenBecauseAReversalHasNone) {
  const auto checks = check(testing::wang2016_readings(104.070), testing::wang2016_claims());
  EXPECT_TRUE(of(checks, "a7").agrees);
  EXPECT_TRUE(of(checks, "a7").sign_differs);
  EXPECT_FALSE(of(checks, "b5").sign_differs);
}

TEST(Claims, TellsALengthThatWasCountedTwice) {
  // No reading reconciles b7 = 178.383 and d7 = 176.484: they are R and the tip arm.
  const auto checks = check(testing::wang2016_readings(104.700), testing::wang2016_claims());
  EXPECT_FALSE(of(checks, "b7").agrees);
  EXPECT_FALSE(of(checks, "b7").contradicted_by.has_value());
  EXPECT_THAT(of(checks, "b7").equals, ElementsAre("the reading R"));
  EXPECT_NEAR(of(checks, "b7").value, 176.484, 0.001);
  EXPECT_FALSE(of(checks, "d7").agrees);
  EXPECT_THAT(of(checks, "d7").equals, Contains("half of l_PP1"));
  EXPECT_THAT(of(checks, "d7").equals, Contains("b7 as adjusted"));
  EXPECT_EQ(of(checks, "d7").value, 0.0);
}

TEST(Claims, ConsistentClaimsAllAgree) {
  std::vector<Claim> claims = testing::wang2016_claims();
  claims[4].value = 176.484;
  claims[5].value = 0.0;
  for (const ClaimCheck& claim : check(testing::wang2016_readings(104.700), claims)) {
    EXPECT_TRUE(claim.agrees) << claim.name << " " << claim.difference;
  }
}

TEST(Claims, FindsAnyOfTheUncheckedReadings) {
  // Digits swapped in l_PP4 or l_PP5 instead: the same detective names these.
  std::vector<Claim> claims = testing::wang2016_claims();
  claims.resize(4);
  auto readings = testing::wang2016_readings(104.700);
  readings[3].value = 1115.863;
  auto checks = check(readings, claims);
  EXPECT_EQ(of(checks, "b5").contradicted_by, "l_PP4");
  EXPECT_NEAR(of(checks, "b5").reconciled_by.value(), 1115.68, 0.005);
  readings = testing::wang2016_readings(104.700);
  readings[4].value = 1289.633;
  checks = check(readings, claims);
  EXPECT_EQ(of(checks, "b3").contradicted_by, "l_PP5");
  EXPECT_NEAR(of(checks, "b3").reconciled_by.value(), 1298.633, 0.005);
  EXPECT_TRUE(of(checks, "a5").agrees);
}

}  // namespace
}  // namespace armcal
