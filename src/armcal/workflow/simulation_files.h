// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/workflow/simulation.h"

namespace armcal {

/// A file that is to be written.
struct FileText {
  std::string path;  ///< from the folder of the simulation
  std::string text;
};

/// What a simulation is written as: the texts, and which of them a user goes on with.
struct SimulationFiles {
  std::vector<FileText> files;  ///< in the order to write them: a file follows those it names
  std::string session;          ///< path; empty where nothing is to be fitted
  std::vector<std::string> procedures;  ///< paths
};

/// nominal.arm.toml, truth.arm.toml, a table per measurement, NAME.session.toml after the scenario,
/// and for each symmetric-point procedure a folder of its own. Nothing but the scenario and the
/// seed goes into them: the same give the same bytes.
/// @throws InputError where two measurements would write the same file
[[nodiscard]] SimulationFiles simulation_files(const Simulation& simulation,
                                               const SimulationScenario& scenario);

}  // namespace armcal
