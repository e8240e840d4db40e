// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/quiet_place.h"

#include <algorithm>
#include <cmath>

namespace armcal {
namespace {

constexpr double kStep = 5.0;
constexpr long kBesideAnother = 1000000;  // worse than any count of points

bool meet(const DrawnBox& a, const DrawnBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

void QuietPlaces::add_line(double x1, double y1, double x2, double y2) {
  const int steps = 1 + static_cast<int>(std::hypot(x2 - x1, y2 - y1) / kStep);
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    add_point(x1 + part * (x2 - x1), y1 + part * (y2 - y1));
  }
}

std::size_t QuietPlaces::choose(std::span<const DrawnBox> boxes) {
  std::size_t best = 0;
  long least = -1;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const DrawnBox& box = boxes[i];
    long count = std::count_if(points_.begin(), points_.end(), [&](const Place& at) {
      return at.x > box.left && at.x < box.right && at.y > box.top && at.y < box.bottom;
    });
    for (const DrawnBox& other : taken_) count += meet(box, other) ? kBesideAnother : 0;
    if (least >= 0 && count >= least) continue;
    least = count;
    best = i;
  }
  if (!boxes.empty()) taken_.push_back(boxes[best]);
  return best;
}

}  // namespace armcal
