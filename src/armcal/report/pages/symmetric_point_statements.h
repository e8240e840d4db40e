// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"

namespace armcal {

/// Readings that fail their check, each with those that it cannot be told apart from.
[[nodiscard]] std::vector<std::vector<DocumentView>> failing_groups(const DocumentView& document);

/// What a reader of a symmetric-point result has to know, one sentence each: as `findings` of the
/// text report, in any language.
[[nodiscard]] std::vector<std::string> symmetric_findings(const DocumentView& document,
                                                          const Language& say);

}  // namespace armcal
