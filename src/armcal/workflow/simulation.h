// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/simulation/virtual_arm.h"
#include "armcal/workflow/scenario_file.h"

namespace armcal {

/// A scenario with everything that it names.
struct LoadedScenario {
  SimulationScenario scenario;
  ArmModel nominal;
  std::optional<ArmModel> truth;                         ///< where the scenario gives it
  std::map<std::string, SymmetricPointProcedure> plans;  ///< by name of the measurement
};

/// A procedure that was carried out.
struct SimulatedProcedure {
  std::string name;
  SymmetricPointProcedure procedure;
};

/// What came out of a virtual laboratory.
struct Simulation {
  std::uint64_t seed = 1;
  /// The drawing and the truth, with the indexed platform as first joint where there is one: the
  /// arms that the readings are of.
  ArmModel nominal;
  ArmModel truth;
  std::vector<ObservationGroup> groups;  ///< to be fitted
  /// Tips of the true arm, base frame, in postures that no other group has.
  std::optional<ObservationGroup> check;
  std::vector<SimulatedProcedure> procedures;
  /// What the noise of the encoders alone makes of a tip position: root of the mean square, over
  /// postures, to first order.
  double floor_mm = 0.0;
  /// How far the tips of the drawing are from the true ones, after the best rigid registration of
  /// the same postures.
  double drawing_error_mm = 0.0;
};

/// Builds the arm and takes all readings. Every measurement draws from a stream of its own: the
/// same scenario and seed give the same readings, and one measurement more at the end changes none
/// before it.
/// @throws InputError with the place and the reason of everything that is impossible: artefacts out
/// of reach, joint limits that exclude a procedure, fewer readings than unknowns
[[nodiscard]] Simulation simulate(const LoadedScenario& loaded, std::uint64_t seed,
                                  const Monitor& monitor = {});

}  // namespace armcal
