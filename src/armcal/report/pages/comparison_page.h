// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal compare`, whichever of its three stories the document tells: methods on a
/// drawn arm, methods on a session, or what the 2016 paper neglects. A table, and errors over time
/// and number of readings on logarithmic scales, methods numbered as in the table.
[[nodiscard]] Page comparison_page(const DocumentView& document, const Language& say);

}  // namespace armcal
