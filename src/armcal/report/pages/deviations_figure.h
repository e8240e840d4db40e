// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

struct DeviationWords {
  std::string title, text;
  std::string point_axis, deviation_axis;
  std::string point;  ///< key of the name of a point, with {0} for its number from 1
};

/// Are some negative? Distances in space are not.
[[nodiscard]] bool have_signs(const std::vector<double>& deviations_mm);

/// Deviations of points in their order, mm. Where some are negative, with lines at the largest and
/// the smallest; distances without a sign need none.
[[nodiscard]] Figure deviations_figure(const std::vector<double>& deviations_mm,
                                       const DeviationWords& words, const Language& say);

}  // namespace armcal
