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

/// Deviations of points in their order, mm, with lines at the largest and the smallest.
[[nodiscard]] Figure deviations_figure(const std::vector<double>& deviations_mm,
                                       const DeviationWords& words, const Language& say);

}  // namespace armcal
