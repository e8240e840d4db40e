// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/identification/calibration.h"
#include "armcal/io/session_file.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// A session with everything that it names.
struct LoadedSession {
  Session session;
  ArmModel arm;
  std::vector<ObservationGroup> groups;
  CalibrationOptions options;
};

/// What a table [estimate] asks for.
[[nodiscard]] CalibrationOptions calibration_options(const SessionEstimate& estimate);

/// Complains of names in an [estimate] that are no parameters of the arm. @param file  that it is
/// in
void check_estimate(const SessionEstimate& estimate, const std::string& file, const ArmModel& arm,
                    Diagnostics& diagnostics);

/// Reads a session (*.session.toml), its arm and its tables; holds out the rows that it wants
/// checked.
/// @throws InputError with every problem of all files
[[nodiscard]] LoadedSession load_session(InputFiles& files, const std::string& path);

/// @throws NumericalError where the readings cannot give a calibration, with the reason
[[nodiscard]] Calibration run_calibration(const LoadedSession& loaded);

/// What the session would determine, at its nominal arm. @throws NumericalError where a frame
/// cannot be placed
[[nodiscard]] Calibration look_at_session(const LoadedSession& loaded);

}  // namespace armcal
