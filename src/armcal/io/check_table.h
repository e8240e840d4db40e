// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "armcal/io/check_history.h"

namespace armcal {

/// Checks as a table for spreadsheets (RFC 4180), with a column for every value and limit that any
/// of them has.
[[nodiscard]] std::string csv_text(std::span<const CheckRecord> checks);

}  // namespace armcal
