// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/html/language.h"

namespace armcal {

/// CSS for the margin of every page of paper: left `foot` (any text; nothing in it ends a style
/// element), right the number of the page and of all.
[[nodiscard]] std::string paper_style(const std::string& foot, const Language& language);

}  // namespace armcal
