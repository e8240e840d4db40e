// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/document.h"
#include "armcal/workflow/simulation.h"
#include "armcal/workflow/simulation_files.h"

namespace armcal {

/// What was simulated and written, for a terminal. @param folder  that the files are in
[[nodiscard]] std::string text_result(const Simulation& simulation, const SimulationFiles& files,
                                      const SimulationScenario& scenario,
                                      const std::string& folder);
[[nodiscard]] Json json_result(const Simulation& simulation, const SimulationFiles& files,
                               const SimulationScenario& scenario, const std::string& folder);

}  // namespace armcal
