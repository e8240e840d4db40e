// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal verify sphere`: diameter and form against their limits, the deviation of
/// each point in order and by direction, how far the joints moved, and what the test could not have
/// shown. Results that were saved before they knew directions have no map of them.
[[nodiscard]] Page sphere_test_page(const DocumentView& document, const Language& say);

}  // namespace armcal
