// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/document.h"
#include "armcal/report/verification_result.h"

namespace armcal {

/// Keys: docs/commands/verify.md.
[[nodiscard]] Json json_result(const Verification& verification);

/// A table of the tests, as found and as left side by side; then what is missing, which reading
/// decided, the definition of every number, and the budget of the test uncertainty.
[[nodiscard]] std::string text_result(const Verification& verification);

}  // namespace armcal
