// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/cli/command.h"
#include "armcal/workflow/verification_job.h"

namespace armcal::cli {

/// The command that runs the tests of one standard from a verification file: what all standards
/// share. Name, brief, description and examples are the caller's.
[[nodiscard]] Command verify_to_standard(VerificationStandard standard);

}  // namespace armcal::cli
