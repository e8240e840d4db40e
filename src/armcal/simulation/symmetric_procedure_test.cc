// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/symmetric_procedure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/symmetric_point/analysis.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/symmetric_point/reduction.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::consistent_romer;
using testing::nominal_romer;

constexpr SymmetricPractice kNoiseless{.u_point_mm = 0.0};

// The paper's arm as it was found to be, beside its drawing.
VirtualArm romer(const ErrorSources& errors = {}) {
  return {nominal_romer(), consistent_romer(), errors, 1};
}

std::vector<ReducedReading> reduced(const SymmetricPointProcedure& procedure) {
  std::vector<ReducedReading> all;
  for (const SymmetricReading& reading : procedure.readings) {
    Diagnostics diagnostics;
    const auto one = reduce(reading, nominal_romer(), diagnostics);
    EXPECT_TRUE(one.has_value()) << diagnostics.to_text();
    if (one) all.push_back(*one);
  }
  return all;
}

TEST(SymmetricProcedure, WithoutNoiseReducesToWhatTheTruthPredicts) {
  Laboratory laboratory(romer(), 1);
  for (const ReducedReading& each :
       reduced(carry_out(laboratory, wang2016_procedure(), kNoiseless))) {
    const double predicted = predict(consistent_romer(), each.reading).value;
    const double tolerance = each.reading.is_angle() ? 1e-11 : 1e-9;
    EXPECT_NEAR(each.reading.value, predicted, tolerance) << each.reading.name;
  }
}

TEST(SymmetricProcedure, OfThePaperGivesTheLengthsOfItsArm) {
  Laboratory laboratory(romer(), 2);
  const SymmetricPractice exact{.u_point_mm = 0.0, .u_posture_rad = 0.0};
  const auto procedure = carry_out(laboratory, wang2016_procedure(), exact);
  Diagnostics diagnostics;
  const auto analysis = analyse_symmetric_points(procedure, nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value()) << diagnostics.to_text();
  EXPECT_TRUE(analysis->is_consistent());
  ASSERT_TRUE(analysis->chain && analysis->chain->complete) << analysis->chain->problem;
  ASSERT_TRUE(analysis->adjustment.ok()) << analysis->adjustment.detail;
  EXPECT_EQ(analysis->adjustment.unknowns.size(), 7u);
  const ParameterTable table(nominal_romer());
  const Eigen::VectorXd truth = parameter_values(consistent_romer());
  const Eigen::VectorXd by_chain = parameter_values(analysis->chain->arm);
  const Eigen::VectorXd by_adjustment = parameter_values(analysis->adjustment.arm);
  for (int i = 0; i < table.size(); ++i) {
    EXPECT_NEAR(by_chain(i), truth(i), 1e-8) << table[i].name;
    EXPECT_NEAR(by_adjustment(i), truth(i), 1e-8) << table[i].name;
  }
}

}  // namespace
}  // namespace armcal
