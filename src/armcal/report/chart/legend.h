// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "armcal/report/chart/svg.h"

namespace armcal {

/// What a sign in a drawing means.
struct LegendEntry {
  std::string name;
  /// Draws a sample about the middle of a place 22 wide.
  std::function<void(SvgDrawing&, double x, double y)> sample;
};

/// Rows of samples with their names, each as wide as it needs.
class ChartLegend {
 public:
  /// @param taken  of the first row at the left by something else, as a label of an axis: then the
  /// entries stand at the right of that row, or in rows below it where they need more
  ChartLegend(std::vector<LegendEntry> entries, double left, double right, double taken = 0.0);

  /// Those in use, with that where something else stands.
  [[nodiscard]] int rows() const { return rows_; }
  /// Do the entries stand in the row where something else is?
  [[nodiscard]] bool is_beside() const { return places_.empty() || places_.front().row == 0; }
  /// @param y  of the base line of the first row
  void draw(SvgDrawing& drawing, double y) const;

  static constexpr double kRowHeight = 19.0;

 private:
  struct Place {
    double x;
    int row;
  };
  std::vector<LegendEntry> entries_;
  std::vector<Place> places_;
  double most_width_;
  int rows_ = 0;
};

}  // namespace armcal
