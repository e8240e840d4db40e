// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/leakage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/random.h"
#include "armcal/symmetric_point/adjustment.h"
#include "armcal/symmetric_point/chain.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/testing/wang2016_arm.h"
#include "armcal/testing/wang2016_unknowns.h"

namespace armcal {
namespace {

double entry(const Leakage& leakage, const std::string& recovered, const std::string& assumed) {
  const auto row = std::find(leakage.recovered.begin(), leakage.recovered.end(), recovered);
  const auto column = std::find(leakage.assumed.begin(), leakage.assumed.end(), assumed);
  return leakage.table(row - leakage.recovered.begin(), column - leakage.assumed.begin());
}

TEST(Leakage, HasTheKnownEntriesForThePapersArm) {
  // mm per mrad, from the project's derivation: which assumption of the paper matters and which
  // does not.
  const Leakage leakage =
      leakage_of_chain(testing::consistent_romer(), testing::wang2016_readings()).value();
  const double mrad = 1e-3;
  EXPECT_NEAR(mrad * entry(leakage, "a5", "zero4"), -0.71, 0.005);
  EXPECT_NEAR(mrad * entry(leakage, "b5", "zero4"), 0.25, 0.005);
  EXPECT_NEAR(mrad * entry(leakage, "b3", "zero4"), 0.15, 0.005);
  EXPECT_NEAR(mrad * entry(leakage, "b3", "zero2"), -0.56, 0.005);
  EXPECT_NEAR(mrad * entry(leakage, "a7", "zero6"), -0.18,
              0.005);  // a7 is negative: its size grows
  // Second order only: twists, zeros of joints 1, 3 and 5.
  for (const char* row : {"a5", "a7", "b3", "b5", "b7"}) {
    for (const char* column :
         {"zero1", "zero3", "zero5", "alpha2", "alpha3", "alpha4", "alpha5", "alpha6"}) {
      EXPECT_NEAR(mrad * entry(leakage, row, column), 0.0, 1e-12) << row << " " << column;
    }
  }
  // The blind spot: axis offsets enter one to one (in sum over the recovered parameters).
  for (const char* column : {"a2", "a4", "a6", "d4", "d6"}) {
    double largest = 0.0;
    for (const char* row : {"a5", "a7", "b3", "b5", "b7"}) {
      largest = std::max(largest, std::abs(entry(leakage, row, column)));
    }
    EXPECT_GT(largest, 0.9) << column;
  }
}

// Random arms near the consistent one; the error of every recovered parameter against the table.
template <typename Recover>
void expect_first_order_prediction(const Leakage& leakage, const Recover& recover) {
  const ArmModel assumed_arm = testing::consistent_romer();
  const ParameterTable table(assumed_arm);
  RandomStream random(2016);
  for (int trial = 0; trial < 200; ++trial) {
    // The same arm errors, once small and once a tenth of that: what the table leaves over must
    // shrink like their square.
    Eigen::VectorXd error(table.size());
    for (int i = 0; i < table.size(); ++i) {
      error(i) = (table[i].unit == ParameterUnit::mm ? 0.02 : 2e-4) * random.normal();
    }
    double left_over[2];
    double size = 0.0;
    for (int scale = 0; scale < 2; ++scale) {
      const Eigen::VectorXd delta = error * (scale == 0 ? 1.0 : 0.1);
      const ArmModel truth = with_parameter_values(assumed_arm, table.nominal() + delta);
      auto readings = testing::wang2016_readings();
      for (SymmetricReading& reading : readings) reading.value = predict(truth, reading).value;
      const ArmModel recovered = recover(assumed_arm, readings);
      const Eigen::VectorXd found = parameter_values(recovered);
      Eigen::VectorXd assumed_errors(static_cast<Eigen::Index>(leakage.assumed.size()));
      for (std::size_t i = 0; i < leakage.assumed.size(); ++i) {
        assumed_errors(static_cast<Eigen::Index>(i)) =
            delta(table.find(leakage.assumed[i]).value());
      }
      const Eigen::VectorXd predicted = leakage.table * assumed_errors;
      left_over[scale] = 0.0;
      for (std::size_t i = 0; i < leakage.recovered.size(); ++i) {
        const int index = table.find(leakage.recovered[i]).value();
        const double actual = found(index) - (table.nominal() + delta)(index);
        const auto place = static_cast<Eigen::Index>(i);
        left_over[scale] = std::max(left_over[scale], std::abs(actual - predicted(place)));
        if (scale == 0) size = std::max(size, std::abs(actual));
      }
    }
    // Second order: an angle squared times the reach, (6e-4)^2 * 1300 mm, for several angles at a
    // time.
    EXPECT_LT(left_over[0], 0.005) << trial;
    EXPECT_GT(size, 0.005) << trial;
    EXPECT_LT(left_over[1], 0.02 * left_over[0] + 1e-9) << trial;
  }
}

TEST(Leakage, PredictsTheErrorOfTheAdjustmentToFirstOrder) {
  const ArmModel arm = testing::consistent_romer();
  const auto unknowns = testing::papers_five(ParameterTable(arm));
  auto exact = testing::wang2016_readings();
  for (SymmetricReading& reading : exact) reading.value = predict(arm, reading).value;
  expect_first_order_prediction(
      leakage_of_adjustment(arm, exact, unknowns).value(),
      [&](const ArmModel& assumed, const std::vector<SymmetricReading>& readings) {
        const Adjustment adjustment = adjust(assumed, readings, {.unknowns = unknowns});
        EXPECT_TRUE(adjustment.ok());
        return adjustment.arm;
      });
}

TEST(Leakage, PredictsTheErrorOfTheChainToFirstOrder) {
  expect_first_order_prediction(
      leakage_of_chain(testing::consistent_romer(), testing::wang2016_readings()).value(),
      [](const ArmModel& assumed, const std::vector<SymmetricReading>& readings) {
        const Chain chain = solve_chain(assumed, readings);
        EXPECT_TRUE(chain.complete);
        return chain.arm;
      });
}

// One radius read twice says nothing about the direction of the tip: this used to end the program.
TEST(Leakage, IsAbsentWhereTheReadingsDoNotTellTheirParametersApart) {
  auto first = testing::circle_radius("r1", 6, testing::degrees({0, 0, 0, 0, 0, 0}), 178.383);
  auto second = first;
  second.name = "r2";
  first.solves = "b7";
  second.solves = "a7";
  const ArmModel arm = testing::consistent_romer();
  const std::vector<SymmetricReading> readings = {first, second};
  EXPECT_FALSE(leakage_of_chain(arm, readings).has_value());
  const ParameterTable table(arm);
  const std::vector<int> both = {table.find("b7").value(), table.find("a7").value()};
  EXPECT_FALSE(leakage_of_adjustment(arm, readings, both).has_value());
}

}  // namespace
}  // namespace armcal
