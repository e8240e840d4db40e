// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/planning/verification_plan.h"

namespace armcal {

/// All tests of a plan, to take to the arm: a row for every point in the order of reading, with the
/// joint angles to stand at and the tip expected there. The CSV is also the table to be filled in
/// and given to `armcal verify`: its columns `q1_deg` .. are empty, and what is planned stands in
/// `planned_q1_deg` .. and `planned_x_mm` .., so that a plan is never taken for readings.
[[nodiscard]] std::string worksheet_csv(const VerificationPlan& plan);
/// The same for people, test by test: angles rounded to degrees, coordinates to 0.1 mm.
[[nodiscard]] std::string worksheet_markdown(const VerificationPlan& plan);

}  // namespace armcal
