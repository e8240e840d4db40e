// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of a result of `armcal fit`: the element with its uncertainties, and how far each point
/// is from it.
[[nodiscard]] Page fit_page(const DocumentView& document, const Language& say);

/// The page of a result of `armcal register`: rotation, translation, and how far each pair is
/// apart.
[[nodiscard]] Page registration_page(const DocumentView& document, const Language& say);

}  // namespace armcal
