// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/marks.h"

#include <fmt/format.h>

#include <set>

namespace armcal {
namespace {

enum class Shape { circle, diamond, triangle, square, plus, cross };

int within_six(int style) { return (style % 6 + 6) % 6; }
Shape shape_of(int style) { return static_cast<Shape>(within_six(style)); }
bool is_hollow(int style) { return style / 6 % 2 != 0; }
bool is_open(Shape shape) { return shape == Shape::plus || shape == Shape::cross; }

// The shape about a point; a circle is a stroke of no length with round ends, the shortest there
// is.
std::string outline(Shape shape, bool hollow, double x, double y, double r) {
  const std::string s = coordinate(r);
  const std::string d = coordinate(2.0 * r);
  const auto start = [&](double dx, double dy) {
    return fmt::format("M{}", point(x + dx, y + dy));
  };
  switch (shape) {
    case Shape::circle:
      return hollow ? fmt::format("{}a{} {} 0 1 1 0 .01z", start(-r, 0.0), s, s)
                    : fmt::format("{}h0", start(0.0, 0.0));
    case Shape::diamond:
      return fmt::format("{}l{} {}-{} {}-{}-{}z", start(0.0, -r), s, s, s, s, s, s);
    case Shape::triangle:
      return fmt::format("{}l{} {}h-{}z", start(0.0, -r), s, coordinate(1.8 * r), d);
    case Shape::square:
      return fmt::format("{}h{}v{}h-{}z", start(-0.85 * r, -0.85 * r), coordinate(1.7 * r),
                         coordinate(1.7 * r), coordinate(1.7 * r));
    case Shape::plus:
      return fmt::format("{}h{}m-{}-{}v{}", start(-r, 0.0), d, s, s, d);
    case Shape::cross:
      break;
  }
  const std::string side = coordinate(1.6 * r);
  return fmt::format("{}l{} {}m0-{}l-{} {}", start(-0.8 * r, -0.8 * r), side, side, side, side,
                     side);
}

}  // namespace

std::string shapes_path(int style, std::span<const DrawnPoint> points, double radius) {
  std::set<std::string> seen;
  std::string path;
  // Strokes have their own width: a diamond and a circle of one radius shall look as large.
  const double r = shape_of(style) == Shape::diamond ? 1.25 * radius : radius;
  for (const DrawnPoint& at : points) {
    if (!seen.insert(point(at.x, at.y)).second) continue;
    path += outline(shape_of(style), is_hollow(style), at.x, at.y, r);
  }
  return path;
}

std::string shape_attributes(int style, double radius) {
  const std::string colour = series_colour(style);
  const Shape shape = shape_of(style);
  const std::string classes = fmt::format("class=\"dots s{}\"", within_six(style));
  if (shape == Shape::circle && !is_hollow(style)) {
    return fmt::format(
        "{} stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-opacity=\".8\"",
        classes, colour, coordinate(2.0 * radius));
  }
  if (is_hollow(style) || is_open(shape)) {
    return fmt::format("{} stroke=\"{}\" stroke-width=\"1.5\"", classes, colour);
  }
  return fmt::format("{} fill=\"{}\" fill-opacity=\".8\"", classes, colour);
}

std::string line_attributes(int style) {
  static constexpr const char* kDashes[] = {"", "7 4", "2 3", "9 3 2 3", "12 4", "4 2"};
  const char* dash = kDashes[within_six(style)];
  return fmt::format(
      "class=\"line s{}\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"{}",
      within_six(style), series_colour(style),
      *dash == '\0' ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash));
}

std::string bar_attributes(int style) {
  const std::string colour = series_colour(style);
  return fmt::format(
      "class=\"bars s{}\" fill=\"{}\" fill-opacity=\".3\" stroke=\"{}\" stroke-width=\"1\"",
      within_six(style), colour, colour);
}

std::string line_path(std::span<const std::vector<DrawnPoint>> pieces) {
  std::string path;
  for (const auto& piece : pieces) {
    std::string before;
    for (const DrawnPoint& at : piece) {
      const std::string here = point(at.x, at.y);
      if (here == before && piece.size() > 1) continue;
      path += (before.empty() ? "M" : "L") + here;
      before = here;
    }
    // A point between two that are missing is a short stroke.
    if (piece.size() == 1) path += "m-1.5 0h3";
  }
  return path;
}

double mark_radius(std::size_t count) { return count <= 60 ? 3.6 : count <= 300 ? 2.8 : 2.0; }

}  // namespace armcal
