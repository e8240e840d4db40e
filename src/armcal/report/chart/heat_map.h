// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/report/html/page.h"

namespace armcal {

/// A matrix of numbers about zero: correlations, or what one thing adds to another.
struct HeatMap {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;  ///< said where there are no cells
  std::vector<std::string> rows, columns;
  Eigen::MatrixXd values;  ///< a cell that is not finite stays blank
  /// Of the full colour; 0: the largest value there is.
  double largest = 0.0;
  /// Part of the full colour from which a cell has a number or a sign; 0: all have numbers where
  /// there is room, else signs from 0.15 on.
  double least_marked = 0.0;
  int decimals = 2;       ///< of values in cells and when hovered
  std::string key_label;  ///< beside the colour key, with unit
};

/// Blue for negative, orange for positive, the paper for zero. Where cells are large their values
/// stand in them, where smaller a plus or minus on those that count: so it can be read without
/// colours. Values are shown when hovered: of all cells where these are few,
/// else of the strongest. Names beyond those of the matrix's rows and columns are left out.
[[nodiscard]] Figure figure_of(const HeatMap& map);

}  // namespace armcal
