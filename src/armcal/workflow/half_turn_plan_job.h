// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/observations/symmetric_point_readings.h"
#include "armcal/planning/half_turn_plan.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// Plans a complete symmetric-point calibration of the arm of a file.
/// Warns of an arm that shows fewer than 4n - 3 parameters by half turns.
/// @throws InputError; NumericalError where a wish cannot be fulfilled
[[nodiscard]] HalfTurnPlan run_half_turn_plan(InputFiles& files, const std::string& arm_path,
                                              const HalfTurnWishes& wishes);

/// The plan as a procedure that waits for its points: what `symmetric_point_text` writes.
/// @param procedure_path  where it will be written; the points are expected beside it, in one table
[[nodiscard]] SymmetricPointProcedure planned_procedure(const HalfTurnPlan& plan,
                                                        const std::string& procedure_path,
                                                        const std::string& arm_path);

/// Where the points of a procedure are expected: procedure.symmetric.toml has procedure.csv.
[[nodiscard]] std::string readings_path(const std::string& procedure_path);

/// The table of points to be filled in: reading, end, coordinates, encoder readings; a row for each
/// repeat at each end.
[[nodiscard]] std::string readings_form(const HalfTurnPlan& plan);

}  // namespace armcal
