// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/chart/chart.h"

namespace armcal {

/// A chart for a script, as JSON: docs/theory/report.md. Numbers have 6 significant digits; values
/// that are not finite are null.
[[nodiscard]] std::string live_chart(const Chart& chart);

}  // namespace armcal
