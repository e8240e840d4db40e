// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal verify iso10360-12` and `armcal verify b89.4.22`: verdict, every statistic
/// against its limit with the uncertainty of the test, the decision rule, what decides, what is
/// missing, each length or position, budgets, definitions.
[[nodiscard]] Page verification_page(const DocumentView& document, const Language& say);

}  // namespace armcal
