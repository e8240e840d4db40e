// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armcal/report/chart/chart.h"
#include "armcal/report/chart/svg.h"

namespace armcal {

struct DrawnPoint {
  double x = 0.0;
  double y = 0.0;
};

/// The path of a mark of each point: a circle, diamond, triangle, square, plus or cross by the
/// style. Marks at the same place to 0.1 are drawn once.
[[nodiscard]] std::string shapes_path(int style, std::span<const DrawnPoint> points, double radius);

/// How the marks of a style are drawn: colour, fill, width of strokes, classes. The second six
/// styles are hollow.
[[nodiscard]] std::string shape_attributes(int style, double radius);
/// The same for a line of a style.
[[nodiscard]] std::string line_attributes(int style);
[[nodiscard]] std::string bar_attributes(int style);

/// Pieces of a line through places: a piece ends where a value is missing.
[[nodiscard]] std::string line_path(std::span<const std::vector<DrawnPoint>> pieces);

/// Half of a mark where there are so many.
[[nodiscard]] double mark_radius(std::size_t count);

}  // namespace armcal
