// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "armcal/planning/half_turn_plan.h"
#include "armcal/planning/length_prediction.h"
#include "armcal/simulation/symmetric_procedure.h"
#include "armcal/symmetric_point/analysis.h"

namespace armcal::testing {

/// How a planned procedure is carried out in the laboratory.
struct HalfTurnPractice {
  double u_distance_mm = 0.005;  ///< of a distance, from all repeats together
  double u_encoder_rad = radians_from_arcseconds(2.0);
  double u_slip_rad = radians_from_arcseconds(5.0);    ///< of each locked joint
  double u_half_turn_rad = radians_from_degrees(1.0);  ///< by which half turns are not half
  double u_posture_rad = radians_from_degrees(0.5);
};

/// A built arm and the readings of a plan on it.
struct HalfTurnTrial {
  ArmModel truth;
  SymmetricPointProcedure procedure;  ///< raw points and encoder readings
};

/// @param seed  of the arm's errors and of everything that chance does to the readings
inline HalfTurnTrial carry_out_plan(const HalfTurnPlan& plan, std::uint64_t seed,
                                    const HalfTurnPractice& practice = {}) {
  ErrorSources errors;
  errors.geometry = GeometryErrors::typical();
  errors.encoder_noise.u_rad = practice.u_encoder_rad;
  VirtualArm arm(plan.arm, errors, seed, plan.wishes.room.surroundings);
  HalfTurnTrial trial;
  trial.truth = arm.truth();
  Laboratory laboratory(std::move(arm), seed);

  SymmetricPointProcedure procedure;
  procedure.unknowns = {"*"};
  procedure.u_encoder_rad = practice.u_encoder_rad;
  for (const PlannedReading& planned : plan.readings) {
    SymmetricReading reading;
    reading.name = planned.name;
    reading.joint = planned.turn.joint;
    reading.posture_rad = planned.turn.posture_rad;
    reading.posture_end_rad = planned.turn.posture_end_rad;
    procedure.readings.push_back(reading);
  }
  SymmetricPractice hands;
  hands.repeats = plan.wishes.repeats;
  // The distance of two means of `repeats` points each.
  hands.u_point_mm = practice.u_distance_mm * std::sqrt(plan.wishes.repeats / 2.0);
  hands.u_posture_rad = practice.u_posture_rad;
  hands.u_slip_rad = practice.u_slip_rad;
  hands.u_half_turn_rad = practice.u_half_turn_rad;
  trial.procedure = armcal::carry_out(laboratory, procedure, hands);
  return trial;
}

/// A gross error of one reading: its end B is away by so much along the line between the ends.
inline void falsify(SymmetricReading& reading, double error_mm) {
  RawSymmetricPoints& raw = *reading.raw;
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < raw.points_mm.size(); ++i) {
    step += (raw.end[i] == 'B' ? 1.0 : -1.0) * raw.points_mm[i];
  }
  for (std::size_t i = 0; i < raw.points_mm.size(); ++i) {
    if (raw.end[i] == 'B') raw.points_mm[i] += error_mm * step.normalized();
  }
}

/// What `armcal symmetric-point` makes of the readings.
inline SymmetricPointAnalysis analysed(const HalfTurnTrial& trial, const ArmModel& nominal) {
  Diagnostics diagnostics;
  auto analysis = analyse_symmetric_points(trial.procedure, nominal, std::nullopt, diagnostics);
  if (!analysis) throw std::runtime_error(diagnostics.to_text());
  return std::move(*analysis);
}

}  // namespace armcal::testing
