// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// Any result, key by key: single values as a list, lists of alike objects and matrices as tables.
/// Keys stand as in the document, whose page of the documentation explains them; a value beside its
/// uncertainty `u` is rounded to match.
[[nodiscard]] Page plain_page(const DocumentView& document, const Language& say);

}  // namespace armcal
