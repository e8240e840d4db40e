// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "armcal/io/output_file.h"
#include "armcal/workflow/input_files.h"
#include "armcal/workflow/simulation.h"
#include "armcal/workflow/simulation_files.h"

namespace armcal {

/// Reads a scenario (*.scenario.toml), its arms and its plans. @throws InputError with every
/// problem of all files
[[nodiscard]] LoadedScenario load_scenario(InputFiles& files, const std::string& path);

/// A scenario of examples/scenarios that is built in.
struct BuiltInScenario {
  std::string name;   ///< "romer"
  std::string path;   ///< for InputFiles of FileSource::embedded
  std::string brief;  ///< its `name` key
};
[[nodiscard]] std::vector<BuiltInScenario> built_in_scenarios();
/// @throws std::invalid_argument where none is called so, with the names that there are
[[nodiscard]] BuiltInScenario built_in_scenario(std::string_view name);

/// Writes all files into a folder, which is made where it does not exist. Nothing is written where
/// one of them exists and may not be overwritten; each file is written whole or not at all.
/// @throws InputError, FileError
void write_simulation(const SimulationFiles& files, const std::string& folder, Overwrite overwrite);

}  // namespace armcal
