// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"
#include "armcal/report/pages/verification_values.h"

namespace armcal {

/// Each statistic with its symbol, value (as found and as left), limit, uncertainty of the test,
/// share of the limit, verdict.
/// @param has_both  an arm as left was verified too
[[nodiscard]] Table tests_table(const std::vector<VerifiedRow>& rows, bool has_both,
                                double coverage_factor, const Language& say);

/// Which part of each statistic decides, and where in the user's files it comes from.
[[nodiscard]] Table deciding_table(const std::vector<VerifiedRow>& rows, const Language& say);

/// Every value that a statistic was found from.
[[nodiscard]] Table parts_table(const std::vector<VerifiedRow>& rows, const Language& say);

/// What the certificates say of the artefacts, a row for each length; saved before documents had
/// them: no rows.
[[nodiscard]] Table artefacts_table(const DocumentView& document, const Language& say);

/// What each statistic is, once for those that share a definition.
[[nodiscard]] Table definitions_table(const std::vector<VerifiedRow>& rows, const Language& say);

}  // namespace armcal
