// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/planning/half_turn_plan.h"
#include "armcal/report/document.h"

namespace armcal {

[[nodiscard]] Json json_result(const HalfTurnPlan& plan);
[[nodiscard]] std::string text_result(const HalfTurnPlan& plan);

/// The worksheet alone, to take to the arm: which joints to set, which to turn, what to expect.
[[nodiscard]] std::string worksheet_csv(const HalfTurnPlan& plan);
[[nodiscard]] std::string worksheet_markdown(const HalfTurnPlan& plan);

}  // namespace armcal
