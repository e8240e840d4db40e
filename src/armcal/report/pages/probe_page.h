// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal probe`: the tip before and after with its uncertainty, whether it is another
/// stylus, and how well the readings show each of its coordinates.
[[nodiscard]] Page probe_page(const DocumentView& document, const Language& say);

}  // namespace armcal
