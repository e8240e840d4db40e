// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/core/utc_time.h"
#include "armcal/report/check_report.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// An interim check, its history, or both.
struct CheckRequest {
  std::optional<std::string> readings;  ///< nothing: only look at the history
  std::optional<std::string> arm;       ///< file that turns joint angles into tips
  InterimCheckOptions options;
  std::optional<std::string> history;
  std::optional<std::string> arm_name;  ///< default: that of the arm file
  std::optional<std::string> artefact;
  std::optional<double> temperature_c;
  std::string note;
  UtcSeconds time = 0;
  std::size_t baseline = 10;  ///< first checks of a series that its centre line comes from
};

/// Makes the check, saves it, judges the history. Charts hold the checks of one series: the same
/// arm, arm file, artefact and kind; a changed arm file begins a new one. Warnings (few points,
/// joints that stood still, another arm, broken rules, drift) go to the diagnostics of `files`.
/// @throws InputError, also where these readings were saved before with the same result; FileError
/// where the history cannot be written; NumericalError where points are no sphere
[[nodiscard]] CheckSummary run_check(InputFiles& files, const CheckRequest& request,
                                     const TableOptions& options);

/// All checks of a history as a table. @throws as CheckHistory
[[nodiscard]] std::string history_as_table(const std::string& history);

}  // namespace armcal
