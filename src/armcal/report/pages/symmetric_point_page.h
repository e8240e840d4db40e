// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal symmetric-point`: what was found, the chain and the adjustment, every
/// reading with its residual and redundancy, claims, leakage, and a drawing of each posture.
[[nodiscard]] Page symmetric_point_page(const DocumentView& document, const Language& say);

}  // namespace armcal
