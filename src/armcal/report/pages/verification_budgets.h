// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"
#include "armcal/report/pages/verification_values.h"

namespace armcal {

/// The uncertainty of each test: by source, and every contribution with its sensitivity. Nothing
/// where no test has a budget.
/// @param rows  of the same document, in its order
[[nodiscard]] std::optional<Section> budgets_section(const DocumentView& document,
                                                     const std::vector<VerifiedRow>& rows,
                                                     const Language& say);

}  // namespace armcal
