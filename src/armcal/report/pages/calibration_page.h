// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal calibrate`: before and after on fitted and held-out rows against the noise
/// floor, the arm to turn in space, its parameters, what the readings cannot see, residuals, the
/// worst rows, coverage, correlations, convergence. Results that were saved before the document
/// knew its rows have the tables and no pictures of rows.
[[nodiscard]] Page calibration_page(const DocumentView& document, const Language& say);

/// The page of `armcal identifiability`: what readings would determine, and what they cannot see.
[[nodiscard]] Page identifiability_page(const DocumentView& document, const Language& say);

}  // namespace armcal
