// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal demo`. Paper: the symmetric-point page of the printed readings, and Table 2
/// of the paper beside the program. Virtual: what the truth says of each kit, and the calibration
/// page of the best one.
[[nodiscard]] Page demo_page(const DocumentView& document, const Language& say);

}  // namespace armcal
