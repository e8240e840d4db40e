// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/testing/wang2016_arm.h"
#include "armcal/workflow/simulation_files.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

LoadedScenario scenario_of(const ArmModel& nominal, std::vector<Measurement> measurements) {
  LoadedScenario loaded;
  loaded.nominal = nominal;
  loaded.scenario.file = "a.scenario.toml";
  loaded.scenario.errors.geometry = GeometryErrors::typical();
  int line = 10;
  for (Measurement& measurement : measurements) {
    if (const auto* symmetric = std::get_if<SymmetricPoint>(&measurement)) {
      loaded.plans[symmetric->name] = wang2016_procedure();
    }
    loaded.scenario.measurements.push_back(
        {std::move(measurement), {"a.scenario.toml", line++, 1}});
  }
  return loaded;
}

std::string refusal(const LoadedScenario& loaded) {
  try {
    static_cast<void>(simulate(loaded, 1));
  } catch (const InputError& error) {
    return error.diagnostics().to_text();
  }
  return "";
}

std::string all_texts(const LoadedScenario& loaded, std::uint64_t seed) {
  std::string all;
  for (const FileText& file : simulation_files(simulate(loaded, seed), loaded.scenario).files) {
    all += file.path + "\n" + file.text;
  }
  return all;
}

TEST(Simulation, IsTheSameForTheSameSeedOnly) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(),
                                      {ReferenceCmm{}, TwoSeats{.postures = 5}, SymmetricPoint{}});
  loaded.scenario.errors.encoder_noise.u_rad = radians_from_arcseconds(2.0);
  loaded.scenario.check = PlannedCheck{.points = 20};
  EXPECT_EQ(all_texts(loaded, 7), all_texts(loaded, 7));
  EXPECT_NE(all_texts(loaded, 7), all_texts(loaded, 8));
}

TEST(Simulation, IsNotChangedByAMeasurementThatFollows) {
  const ConeSeat cone{.postures = 30};
  const Simulation one = simulate(scenario_of(testing::nominal_romer(), {ReferenceCmm{}, cone}), 3);
  const Simulation two =
      simulate(scenario_of(testing::nominal_romer(), {ReferenceCmm{}, cone, SpherePlate{}}), 3);
  EXPECT_EQ(one.groups[0].reference_mm, two.groups[0].reference_mm);
  EXPECT_EQ(one.groups[1].encoder_rad, two.groups[1].encoder_rad);
}

TEST(Simulation, KnowsItsFloorAndHowWrongTheDrawingIs) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(), {ReferenceCmm{}});
  loaded.scenario.errors.encoder_noise = {.u_rad = radians_from_arcseconds(2.0)};
  const Simulation noisy = simulate(loaded, 1);
  // Twice the noise is twice the floor; the geometry stays.
  loaded.scenario.errors.encoder_noise.u_rad *= 2.0;
  const Simulation noisier = simulate(loaded, 1);
  EXPECT_NEAR(noisier.floor_mm, 2.0 * noisy.floor_mm, 1e-12);
  EXPECT_EQ(parameter_values(noisy.truth), parameter_values(noisier.truth));
  EXPECT_NEAR(noisy.groups[0].u_encoder_rad, radians_from_arcseconds(2.0), 1e-20);
  EXPECT_GT(noisy.drawing_error_mm, 0.1);
  loaded.scenario.errors = {};
  const Simulation perfect = simulate(loaded, 1);
  EXPECT_EQ(perfect.floor_mm, 0.0);
  EXPECT_LT(perfect.drawing_error_mm, 1e-9);
}

TEST(Simulation, CountsRoundingToStepsAsNoise) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(), {ReferenceCmm{}});
  loaded.scenario.errors.encoder_noise = {.step_rad = 1e-5};
  EXPECT_NEAR(simulate(loaded, 1).groups[0].u_encoder_rad, 1e-5 / std::sqrt(12.0), 1e-18);
}

TEST(Simulation, PutsTheArmOnItsPlatformInAllGroups) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(),
                                      {ReferenceCmm{}, HalfTurns{.count = 4}, IndexedPlatform{}});
  loaded.scenario.check = PlannedCheck{.points = 5};
  const Simulation simulation = simulate(loaded, 1);
  EXPECT_EQ(simulation.truth.joint_count(), 7);
  for (const ObservationGroup& group : simulation.groups) EXPECT_EQ(group.encoder_rad.rows(), 7);
  const ObservationGroup& turns = simulation.groups[1];
  for (Eigen::Index i = 0; i < turns.count(); ++i) {
    const Eigen::VectorXd turn = turns.encoder_end_rad.col(i) - turns.encoder_rad.col(i);
    EXPECT_NEAR(std::abs(turn(turns.joint[static_cast<std::size_t>(i)] - 1)), std::numbers::pi,
                1e-12);
  }
  // The check's tips are those of the arm with the platform at index 0.
  const ForwardKinematics kinematics(simulation.truth);
  const ObservationGroup& check = *simulation.check;
  const Eigen::VectorXd posture = check.encoder_rad.col(2);
  EXPECT_LT((kinematics.tip_in_base({posture.data(), 7}) - check.reference_mm.col(2)).norm(), 1e-9);
}

// --- what cannot be

TEST(Simulation, RefusesAnArtefactOutOfReach) {
  EXPECT_THAT(refusal(scenario_of(testing::nominal_romer(),
                                  {ReferenceCmm{}, BallBar{.length_mm = 9000.0}})),
              HasSubstr("a.scenario.toml:11:1: error: "));
}

ArmModel narrow_romer() {
  ArmModel arm = testing::nominal_romer();
  for (Joint& joint : arm.joints) {
    joint.min_rad = radians_from_degrees(-80.0);
    joint.max_rad = radians_from_degrees(80.0);
  }
  return arm;
}

TEST(Simulation, RefusesAProcedureThatJointLimitsExclude) {
  const std::string text =
      refusal(scenario_of(narrow_romer(), {SymmetricPoint{}, HalfTurns{.name = "turns"}}));
  EXPECT_THAT(text, HasSubstr("a.scenario.toml:10:1: error: reading \""));
  EXPECT_THAT(text, HasSubstr("limit"));
  EXPECT_THAT(text,
              HasSubstr("a.scenario.toml:11:1: error: no joint can be turned"));  // both are told
}

TEST(Simulation, RefusesTheProcedureOfAnotherArm) {
  ArmModel five = testing::nominal_romer();
  five.joints.pop_back();
  five.links.pop_back();
  EXPECT_THAT(refusal(scenario_of(five, {SymmetricPoint{}})), HasSubstr("the arm has 5 joints"));
}

TEST(Simulation, RefusesJointsThatTheArmDoesNotHave) {
  EXPECT_THAT(refusal(scenario_of(testing::nominal_romer(), {CircleRadii{.joints = {2, 7}}})),
              HasSubstr("a.scenario.toml:10:1: error: joint 7 of an arm with 6 joints"));
}

TEST(Simulation, RefusesFewerReadingsThanUnknowns) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(), {ReferenceCmm{.count = 8}});
  EXPECT_THAT(refusal(loaded),
              HasSubstr("8 readings are too few: they give 24 equations for 27 unknowns, 21 of the "
                        "arm and 6 of frames and points"));
  // Enough once parameters are held, or known beforehand.
  loaded.scenario.estimate.hold = {"alpha*"};
  EXPECT_EQ(refusal(loaded), "");
  loaded.scenario.estimate.hold = {};
  loaded.scenario.estimate.prior_length_mm = 1.0;
  EXPECT_EQ(refusal(loaded), "");
}

TEST(Simulation, RefusesToHoldWhatIsNotThere) {
  LoadedScenario loaded = scenario_of(testing::nominal_romer(), {ReferenceCmm{}});
  loaded.scenario.estimate.hold = {"gamma*"};
  EXPECT_THAT(refusal(loaded), HasSubstr("hold: no parameter matches \"gamma*\""));
}

TEST(Simulation, RefusesTwoMeasurementsThatWriteTheSameFile) {
  const LoadedScenario loaded = scenario_of(
      testing::nominal_romer(), {TwoSeats{.placements = 2}, ReferenceCmm{.name = "bar-length"}});
  EXPECT_THROW(static_cast<void>(simulation_files(simulate(loaded, 1), loaded.scenario)),
               InputError);
}

}  // namespace
}  // namespace armcal
