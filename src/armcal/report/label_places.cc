// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/label_places.h"

#include <algorithm>
#include <cmath>

#include "armcal/report/text_table.h"

namespace armcal {
namespace {

// Where the box of a text stands about its point: the shares of its size by which its lower left
// corner is moved, and the direction in which it is kept off.
struct LabelSide {
  double share_x, share_y, away_x, away_y;
};
constexpr LabelSide kSides[] = {{0.0, 0.0, 1, -1},  {0.0, 1.0, 1, 1}, {-1.0, 0.0, -1, -1},
                                {-1.0, 1.0, -1, 1}, {0.0, 0.5, 1, 0}, {-1.0, 0.5, -1, 0},
                                {-0.5, 0.0, 0, -1}, {-0.5, 1.0, 0, 1}};
// Lines are rows of boxes this far apart.
constexpr double kLineStep = 4.0;
constexpr double kGaps[] = {5.0, 12.0, 22.0, 34.0};

}  // namespace

void LabelPlaces::reserve(double x, double y, double half_size) {
  taken_.push_back({x - half_size, y - half_size, x + half_size, y + half_size});
}

void LabelPlaces::reserve_line(double x1, double y1, double x2, double y2) {
  const int steps = 1 + static_cast<int>(std::hypot(x2 - x1, y2 - y1) / kLineStep);
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    reserve(x1 + part * (x2 - x1), y1 + part * (y2 - y1), 0.5 * kLineStep);
  }
}

PlacedLabel LabelPlaces::place(const std::string& text, double x, double y) {
  const double width = kLabelCharacter * static_cast<double>(display_width(text));
  const auto box_at = [&](double gap, const LabelSide& side) -> Box {
    const double left = x + side.share_x * width + gap * side.away_x;
    const double bottom = y + side.share_y * kLabelHeight + gap * side.away_y;
    return {left, bottom - kLabelHeight, left + width, bottom};
  };
  Box chosen = box_at(kGaps[0], kSides[0]);
  [&] {
    for (const double gap : kGaps) {
      for (const LabelSide& side : kSides) {
        const Box box = box_at(gap, side);
        if (!is_free(box)) continue;
        chosen = box;
        return;
      }
    }
  }();
  taken_.push_back(chosen);
  return {text, chosen.left, chosen.bottom - 0.2 * kLabelHeight};
}

bool LabelPlaces::is_free(const Box& box) const {
  if (box.left < 0.0 || box.top < 0.0 || box.right > width_ || box.bottom > height_) return false;
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return box.left < other.right && other.left < box.right && box.top < other.bottom &&
           other.top < box.bottom;
  });
}

}  // namespace armcal
