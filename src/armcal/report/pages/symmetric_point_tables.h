// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// Each parameter: nominal, by the chain, by the adjustment, with standard uncertainties.
[[nodiscard]] Table symmetric_parameters(const DocumentView& document, const Language& say);

/// Each reading with its residual and what checks it.
[[nodiscard]] Table symmetric_readings(const DocumentView& document, const Language& say);

/// Where a reading came as points: what its two ends, its arc or its search gave.
[[nodiscard]] Table symmetric_reductions(const DocumentView& document, const Language& say);

/// Published values, held against the readings; nothing where there are none.
[[nodiscard]] std::optional<Table> symmetric_claims(const DocumentView& document,
                                                    const Language& say);

}  // namespace armcal
