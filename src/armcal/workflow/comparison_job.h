// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/comparison/scenario.h"
#include "armcal/comparison/session_comparison.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// A scenario that is built in, by its name, or the arm, errors and surroundings of a scenario file
/// (*.scenario.toml). What the file measures is left to the methods.
/// @throws InputError; std::invalid_argument where there is neither, with the names that there are
[[nodiscard]] Scenario scenario_to_compare(InputFiles& files, const std::string& name_or_path);

/// Where a session holds nothing out, so many of its rows are, to have something to judge by.
inline constexpr double kSplitForComparison = 0.3;

/// @throws InputError; NumericalError where nothing can be held out
[[nodiscard]] SessionComparison run_session_comparison(InputFiles& files, const std::string& path,
                                                       const SessionComparisonOptions& options);

}  // namespace armcal
