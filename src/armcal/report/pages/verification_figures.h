// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"
#include "armcal/report/pages/verification_values.h"

namespace armcal {

/// Every statistic against its limit, as found and as left.
/// @param rule  name of the decision rule, as documents write it
[[nodiscard]] Figure limit_figure(const std::vector<VerifiedRow>& rows, const std::string& rule,
                                  const Language& say);

/// What the statistics were found from, where there is more to see than the statistic says: errors
/// over calibrated lengths between the limits, deviations of each articulation.
[[nodiscard]] Figures part_figures(const std::vector<VerifiedRow>& rows, const Language& say);

}  // namespace armcal
