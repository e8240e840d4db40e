// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "armcal/arm/arm_model.h"

namespace armcal::testing {

/// The tables of examples/verification by their names: what a laboratory measures with an arm whose
/// truth is the given one, encoders of 1 arcsec, on the artefacts of the verification files there.
[[nodiscard]] std::map<std::string, std::string> verification_example_tables(const ArmModel& truth);

}  // namespace armcal::testing
