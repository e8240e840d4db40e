// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/symmetric_procedure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/simulation/measuring_arms.h"
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

// Set by hand and read by encoders, the postures are another half degree off those of the paper:
// its chain, one parameter after another from nominal ones, then errs by some 0.01 mm; the
// adjustment does not.
TEST(SymmetricProcedure, SetByHandIsForTheAdjustmentRatherThanTheChain) {
  Laboratory laboratory(romer(), 3);
  const auto procedure = carry_out(laboratory, wang2016_procedure(), kNoiseless);
  Diagnostics diagnostics;
  const auto analysis = analyse_symmetric_points(procedure, nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value() && analysis->adjustment.ok() && analysis->chain->complete);
  const auto largest_error = [](const ArmModel& arm) {
    return (parameter_values(arm) - parameter_values(consistent_romer())).lpNorm<Eigen::Infinity>();
  };
  EXPECT_LT(largest_error(analysis->adjustment.arm), 1e-8);
  EXPECT_GT(largest_error(analysis->chain->arm), 1e-4);
  EXPECT_LT(largest_error(analysis->chain->arm), 0.1);
}

TEST(SymmetricProcedure, WithNoiseIsWithinItsUncertainties) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Laboratory laboratory(romer(), 10 + seed);
    const SymmetricPractice practice{.u_point_mm = 0.003, .arc_points = 8, .zero_settings = 7};
    for (const ReducedReading& each :
         reduced(carry_out(laboratory, wang2016_procedure(), practice))) {
      const double error =
          (each.reading.value - predict(consistent_romer(), each.reading).value) / each.reading.u;
      EXPECT_LT(std::abs(error), 5.0) << each.reading.name;
      sum += error * error;
      ++count;
    }
  }
  // Uncertainties of a few degrees of freedom each: errors over them spread like t, not normal.
  EXPECT_GT(sum / count, 0.6);
  EXPECT_LT(sum / count, 1.7);
}

TEST(SymmetricProcedure, RecordsWhatWasNotQuiteAsPlanned) {
  Laboratory laboratory(romer(), 4);
  const SymmetricPractice practice{
      .u_point_mm = 0.0, .u_posture_rad = 0.01, .u_slip_rad = 1e-4, .u_half_turn_rad = 0.01};
  const auto plan = wang2016_procedure();
  double slips = 0.0;
  double half_turns = 0.0;
  const auto done = reduced(carry_out(laboratory, plan, practice));
  for (std::size_t i = 0; i < done.size(); ++i) {
    const auto& [reading, reduction] = done[i];
    const Eigen::VectorXd off = reading.posture_rad - plan.readings[i].posture_rad;
    EXPECT_EQ(reading.name, plan.readings[i].name);
    EXPECT_GT(off.norm(), 1e-3);
    EXPECT_LT(off.norm(), 0.06);
    if (reading.kind != SymmetricKind::reversal) continue;
    slips += reduction.largest_slip_rad / 5.0;
    half_turns += std::abs(reduction.half_turn_rad - std::numbers::pi) / 5.0;
    EXPECT_NEAR(reading.value, predict(consistent_romer(), reading).value, 1e-9);
  }
  EXPECT_GT(slips, 1e-4);  // the largest of five
  EXPECT_LT(slips, 3e-4);
  EXPECT_GT(half_turns, 0.002);
  EXPECT_LT(half_turns, 0.03);
}

TEST(SymmetricProcedure, IsTakenByAMachineThatStandsElsewhereForEveryReading) {
  Laboratory laboratory(romer(), 5);
  SymmetricPointProcedure plan = wang2016_procedure();
  plan.readings = {plan.readings[3], plan.readings[3]};
  const SymmetricPractice practice{.u_point_mm = 0.0, .repeats = 2, .u_posture_rad = 0.0};
  const auto done = carry_out(laboratory, plan, practice);
  const auto& first = *done.readings[0].raw;
  const auto& second = *done.readings[1].raw;
  ASSERT_EQ(first.points_mm.size(), 4u);
  EXPECT_EQ(first.encoder_rad, second.encoder_rad);
  EXPECT_GT((first.points_mm[0] - second.points_mm[0]).norm(), 1.0);
  EXPECT_NEAR((first.points_mm[0] - first.points_mm[3]).norm(),
              (second.points_mm[0] - second.points_mm[3]).norm(), 1e-9);
  EXPECT_EQ(std::string(first.end.begin(), first.end.end()), "AABB");
  EXPECT_EQ(first.file, "l_PP1.csv");
  EXPECT_FALSE(done.readings[0].reduced);
}

SymmetricPointProcedure one_half_turn(int joint, double at_deg) {
  SymmetricReading reading;
  reading.name = "half turn";
  reading.joint = joint;
  reading.posture_rad = testing::degrees({10, 20, 30, 90, 50, 40, 30});
  reading.posture_rad(joint - 1) = radians_from_degrees(at_deg);
  SymmetricPointProcedure plan;
  plan.readings = {reading};
  return plan;
}

std::string refusal(const SymmetricPointProcedure& plan) {
  const ArmModel arm = seven_joint_arm();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 6);
  try {
    static_cast<void>(carry_out(laboratory, plan, {}));
  } catch (const Impossible& impossible) {
    return impossible.what();
  }
  return "carried out";
}

TEST(SymmetricProcedure, KeepsToStops) {
  const ArmModel arm = seven_joint_arm();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 6);
  // From 200 deg joint 4 can only be turned back; at its stop joint 2 is not set beyond it.
  for (const auto& plan : {one_half_turn(4, 200.0), one_half_turn(2, 120.0)}) {
    const RawSymmetricPoints raw = *carry_out(laboratory, plan, {}).readings[0].raw;
    const int joint = plan.readings[0].joint;
    const Eigen::VectorXd turn = raw.encoder_rad.rightCols<1>() - raw.encoder_rad.col(0);
    EXPECT_NEAR(turn(joint - 1), -std::numbers::pi, 0.02);
  }
  SymmetricPointProcedure search = one_half_turn(4, 0.0);
  search.readings[0].kind = SymmetricKind::zero_search;
  const RawSymmetricPoints raw = *carry_out(laboratory, search, {}).readings[0].raw;
  const auto [low, high] = std::minmax_element(raw.setting_rad.begin(), raw.setting_rad.end());
  EXPECT_NEAR(*low, radians_from_degrees(-30.0), 1e-9);  // shifted up from its stop
  EXPECT_NEAR(*high, radians_from_degrees(120.0), 1e-9);
  EXPECT_EQ(raw.points_mm.size(), 7u * 12u);
}

TEST(SymmetricProcedure, IsCarriedOutRightAboveTheBench) {
  const ArmModel arm = nominal_romer();
  SymmetricPointProcedure plan;
  plan.readings = {wang2016_procedure().readings[7]};  // both ends as high as each other
  const auto& posture = plan.readings[0].posture_rad;
  const double height_mm =
      ForwardKinematics(arm).tip_in_base({posture.data(), static_cast<std::size_t>(6)}).z();
  const auto lowest_tip = [&](double bench_mm) {
    Laboratory laboratory(VirtualArm(arm, arm, {}, 1, {.bench_mm = bench_mm}), 7);
    const auto done = carry_out(laboratory, plan, kNoiseless);
    double lowest_mm = 1e9;
    for (const auto& at : done.readings[0].raw->encoder_rad.colwise()) {
      const Eigen::VectorXd e = at;
      lowest_mm = std::min(lowest_mm, ForwardKinematics(arm).tip_in_base({e.data(), 6}).z());
    }
    return lowest_mm;
  };
  ASSERT_LT(height_mm, -100.0);  // the tip is the lowest point of the arm
  EXPECT_GE(lowest_tip(height_mm - 0.01), height_mm - 0.01);
  EXPECT_THROW(lowest_tip(height_mm + 1.0), Impossible);
}

TEST(SymmetricProcedure, RefusesPosturesThatTheArmCannotTake) {
  EXPECT_EQ(refusal(one_half_turn(3, 30.0)), "carried out");
  EXPECT_EQ(refusal(one_half_turn(4, 215.0)),
            "reading \"half turn\" cannot be taken: joint 4 at 215.0 deg is beyond its limit of "
            "210.0 deg");
  EXPECT_EQ(refusal(one_half_turn(2, 0.0)),
            "reading \"half turn\" cannot be taken: joint 2 at 180.0 deg is beyond its limit of "
            "120.0 deg");
}

}  // namespace
}  // namespace armcal
