// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal check`: the numbers of the check against their limits, and for each watched
/// value its history as a control chart with its drift. A look at a history alone has no check, a
/// check without history no trends.
[[nodiscard]] Page check_page(const DocumentView& document, const Language& say);

}  // namespace armcal
