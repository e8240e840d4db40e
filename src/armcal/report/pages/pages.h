// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/io/report_details_file.h"
#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The page of a result document, chosen by its `command`: a page of its own for results that
/// people look at (pages.cc lists them), a plain one with every key for the others. Around it stand
/// what the details say (ISO/IEC 17025:2017, 7.8) and where the numbers come from.
/// @throws InputError where the document is no result or lacks what its page needs
[[nodiscard]] Page page_of(const DocumentView& document, const Language& say,
                           const ReportDetails& details);

}  // namespace armcal
