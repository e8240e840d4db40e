// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/symmetric_readings.h"
#include "armcal/planning/half_turn_plan.h"
#include "armcal/simulation/symmetric_procedure.h"

namespace armcal {
namespace {

// Each end is touched once, as everything else on this bench. Weights must be finite: perfect
// references are stated as 1 um.
double u_distance_mm(const Bench& bench) {
  const double u_mm = bench.u_reference_mm > 0.0 ? bench.u_reference_mm : 0.001;
  return std::numbers::sqrt2 * u_mm;
}

SymmetricPointProcedure planned(const Bench& bench, int half_turns) {
  HalfTurnWishes wishes;
  wishes.readings = half_turns;
  wishes.u_mm = u_distance_mm(bench);
  wishes.u_encoder_rad = bench.u_encoder_rad();
  wishes.repeats = 1;
  // No blunders here, so nothing needs to be checked by others.
  wishes.least_redundancy = 0.0;
  wishes.room.surroundings = bench.arm.surroundings();
  return procedure_of(plan_half_turns(bench.arm.nominal(), wishes, bench.monitor));
}

TakenReadings take(const Bench& bench, int half_turns) {
  const SymmetricPointProcedure plan = planned(bench, half_turns);
  Laboratory laboratory = bench.laboratory();
  SymmetricPointProcedure procedure =
      carry_out(laboratory, plan, {.u_point_mm = bench.u_reference_mm, .repeats = 1});
  for (SymmetricReading& reading : procedure.readings) reading.u = u_distance_mm(bench);
  return {count_readings(procedure),
          [nominal = bench.arm.nominal(), procedure = std::move(procedure)] {
            return found_arm(analysed(procedure, nominal).adjustment);
          }};
}

}  // namespace

std::vector<Method> half_turn_methods() {
  std::vector<Method> methods;
  for (const int half_turns : {24, 40, 60}) {
    methods.push_back({.name = fmt::format("half-turns-{}", half_turns),
                       .title = fmt::format("complete symmetric points, {} half turns", half_turns),
                       .needs = "anything that measures a distance, clamps for the joints",
                       .effort = 20.0,
                       .take = [=](const Bench& bench) { return take(bench, half_turns); }});
  }
  return methods;
}

}  // namespace armcal
