// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/report/html/page.h"

namespace armcal {

struct IntervalRow {
  std::string name;
  double value = 0.0;
  double half_width = 0.0;  ///< of the interval about it; 0: none is drawn
  std::string text;         ///< at the right; may be empty
  bool is_held = false;     ///< not estimated
};

/// Rows on one axis.
struct IntervalGroup {
  std::string label;  ///< of the axis, with unit
  std::vector<IntervalRow> rows;
};

/// What was estimated, one row below the other, each as a point with the interval about it: changes
/// of parameters in units of their standard uncertainties, or with +-U, grouped by unit.
struct IntervalChart {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;
  std::string estimated, held;  ///< words of the legend
  std::vector<IntervalGroup> groups;
};

/// Estimated ones filled, held ones hollow; zero is a line. Rows whose value is not finite keep
/// their names. An interval that leaves zero out is drawn strong.
[[nodiscard]] Figure figure_of(const IntervalChart& chart);

}  // namespace armcal
