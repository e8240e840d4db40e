// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/planning/verification_plan.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// Plans the verification of the arm of a file.
/// @throws InputError; ImpossiblePlan naming every artefact that finds no place
[[nodiscard]] VerificationPlan run_verification_plan(InputFiles& files, const std::string& arm_path,
                                                     const VerificationPlanWishes& wishes);

}  // namespace armcal
