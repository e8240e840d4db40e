// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/clearance.h"
#include "armcal/io/session_file.h"
#include "armcal/simulation/error_sources.h"
#include "armcal/workflow/scenario_measurements.h"

namespace armcal {

/// One [[measure]].
struct PlannedMeasurement {
  Measurement measurement;
  SourcePosition where;
};

/// Tips of the true arm in postures that no calibration has seen.
struct PlannedCheck {
  int points = 200;
  double u_mm = 0.0;  ///< of the reference coordinates; 0: the truth itself
  SourcePosition where;
};

/// Everything a *.scenario.toml says: an arm to be built with errors, and what to measure.
struct SimulationScenario {
  std::string file;
  std::string name;
  std::string arm_file;    ///< the drawing; resolved
  std::string truth_file;  ///< a given truth instead of drawn errors; resolved, or empty
  std::uint64_t seed = 1;
  double seconds_per_reading = 5.0;
  Surroundings surroundings;
  ErrorSources errors;
  std::vector<PlannedMeasurement> measurements;
  std::optional<PlannedCheck> check;
  SessionEstimate estimate;  ///< goes into the session
};

/// Reads a *.scenario.toml (schema armcal.scenario/1: docs/files/scenario.md). Problems go to
/// `diagnostics`, all of them; with errors nothing is returned.
[[nodiscard]] std::optional<SimulationScenario> read_scenario_file(const TextFile& file,
                                                                   Diagnostics& diagnostics);

}  // namespace armcal
