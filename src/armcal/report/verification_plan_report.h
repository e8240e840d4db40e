// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/planning/verification_plan.h"
#include "armcal/report/document.h"

namespace armcal {

[[nodiscard]] Json json_result(const VerificationPlan& plan);
[[nodiscard]] std::string text_result(const VerificationPlan& plan);

}  // namespace armcal
