// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of `armcal plan symmetric-point`: what the planned half turns promise, each of them in
/// the order of reading with what has to be set, and as the arm stands.
[[nodiscard]] Page half_turn_plan_page(const DocumentView& document, const Language& say);

}  // namespace armcal
