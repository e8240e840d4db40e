// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal plan verification`: how many points, what they exercise of each joint, and
/// for each standard where spheres, seats and bars go, drawn to scale and as tables.
[[nodiscard]] Page verification_plan_page(const DocumentView& document, const Language& say);

}  // namespace armcal
