// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/report/html/document_view.h"

namespace armcal {

/// A number of a symmetric-point result whose key says its unit: residual_mm or residual_deg.
[[nodiscard]] std::optional<double> symmetric_amount(const DocumentView& entry,
                                                     const std::string& key);
/// A dash where there is none.
[[nodiscard]] std::string amount_text(const std::optional<double>& value, int decimals);

/// Decimals for the uncertainty of a reading.
[[nodiscard]] int decimals_of_reading(const DocumentView& reading);
/// Do other readings check it?
[[nodiscard]] bool is_checked_reading(const DocumentView& reading);
[[nodiscard]] bool is_flagged_reading(const DocumentView& reading);

}  // namespace armcal
