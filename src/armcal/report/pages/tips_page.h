// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of a result of `armcal fk` or `armcal predict`: where the tip is at each posture, with
/// its uncertainties where the result has them.
[[nodiscard]] Page tips_page(const DocumentView& document, const Language& say);

}  // namespace armcal
