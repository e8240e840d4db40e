// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal diff`: change of every parameter in units of its standard uncertainty.
[[nodiscard]] Page diff_page(const DocumentView& document, const Language& say);

}  // namespace armcal
