// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/parameter_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;

ArmModel small_arm() {
  ArmModel arm;
  arm.joints.resize(2);
  arm.joints[0].zero_rad = 0.1;
  arm.joints[1].harmonics = {{0.2, 0.3}};
  arm.links = {{1.0, 2.0, 3.0, 0.4, 0.5}};
  arm.tip = {.a_mm = 4.0, .b_mm = 5.0, .d_mm = 6.0};
  return arm;
}

TEST(ParameterTable, HasTheFixedOrderAndNames) {
  const ParameterTable table(small_arm());
  EXPECT_THAT(table.names(), ElementsAre("zero1", "zero2", "d2", "b2", "a2", "alpha2", "beta2",
                                         "a3", "b3", "d3", "cos1_2", "sin1_2"));
  EXPECT_THAT(table.nominal(), ElementsAre(0.1, 0.0, 1, 2, 3, 0.4, 0.5, 4, 5, 6, 0.2, 0.3));
  EXPECT_EQ(table[5].unit, ParameterUnit::rad);
  EXPECT_EQ(table[7].unit, ParameterUnit::mm);
  EXPECT_EQ(table[7].joint, 3);
  EXPECT_EQ(table[11].harmonic, 1);
}

TEST(ParameterTable, CountsAsTheTheorySays) {
  // n zeros, 5 (n - 1) link numbers with beta, 3 of the tip: 34 for six joints, 29 without beta.
  RandomStream random(1);
  for (int n = 2; n <= 10; ++n) {
    const ArmModel arm = testing::random_arm(n, random, {.harmonics = 0});
    EXPECT_EQ(ParameterTable(arm).size(), n + 5 * (n - 1) + 3);
  }
}

TEST(ParameterTable, NamesAreUnique) {
  RandomStream random(2);
  const auto names = ParameterTable(testing::random_arm(10, random, {.harmonics = 3})).names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(ParameterTable, FindsByNameAndPattern) {
  const ParameterTable table(small_arm());
  EXPECT_EQ(table.find("alpha2"), 5);
  EXPECT_FALSE(table.find("alpha3").has_value());
  EXPECT_THAT(table.matching("zero*"), ElementsAre(0, 1));
  EXPECT_THAT(table.matching("*3"), ElementsAre(7, 8, 9));
}

TEST(ParameterValues, WriteAndReadBackEveryOne) {
  RandomStream random(3);
  const ArmModel arm = testing::random_arm(7, random);
  Eigen::VectorXd values = parameter_values(arm);
  for (double& v : values) v += 1.0 + random.uniform();
  EXPECT_EQ(parameter_values(with_parameter_values(arm, values)), values);
}

TEST(ParameterTable, RemembersStatus) {
  ParameterTable table(small_arm());
  EXPECT_EQ(table[0].status, ParameterStatus::held);
  table.set_status(0, ParameterStatus::free);
  EXPECT_EQ(to_string(table[0].status), "free");
}

}  // namespace
}  // namespace armcal
