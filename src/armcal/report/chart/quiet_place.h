// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace armcal {

struct DrawnBox {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// Where in a drawing there is the least: for words that shall not lie on data.
class QuietPlaces {
 public:
  void add_point(double x, double y) { points_.push_back({x, y}); }
  /// Points along a straight line.
  void add_line(double x1, double y1, double x2, double y2);

  /// The box that holds the fewest points and meets none that was chosen before, where there is
  /// such a one; of equals the first. It is taken then.
  [[nodiscard]] std::size_t choose(std::span<const DrawnBox> boxes);

 private:
  struct Place {
    double x, y;
  };
  std::vector<Place> points_;
  std::vector<DrawnBox> taken_;
};

}  // namespace armcal
