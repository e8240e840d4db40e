// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/sphere_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/svg.h"
#include "armcal/report/number_format.h"

namespace armcal {
namespace {

constexpr double kSphereWidth = 520.0;
constexpr double kRadius = 112.0;
constexpr double kTop = 52.0;
constexpr double kCentre_y = kTop + kRadius;
constexpr double kSphereHeight = kCentre_y + kRadius + 34.0;
constexpr double kMiddles_x[] = {134.0, 386.0};
constexpr double kLargestMark = 9.0, kSmallestMark = 2.0;
constexpr double kHalfWayDown = 0.5;  // of the height of a half sphere, as a circle

// Distance from the middle of a half for a height z of the direction, 1 at its edge.
double lambert(double z) { return std::sqrt(std::max(0.0, 1.0 - std::abs(z))); }

void draw_half(SvgDrawing& drawing, double x, const std::string& caption) {
  constexpr const char* kThin = "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".25\"";
  drawing.circle(x, kCentre_y, kRadius,
                 "class=\"frame\" stroke=\"currentColor\" stroke-opacity=\".6\"");
  drawing.circle(x, kCentre_y, kRadius * lambert(kHalfWayDown), kThin);
  drawing.line(x - kRadius, kCentre_y, x + kRadius, kCentre_y, kThin);
  drawing.line(x, kCentre_y - kRadius, x, kCentre_y + kRadius, kThin);
  drawing.text(x + kRadius + 5.0, kCentre_y + 4.0, "x", {.style = "tick", .size = 12.0});
  drawing.text(x, kCentre_y - kRadius - 6.0, "y",
               {.style = "tick", .anchor = TextAnchor::middle, .size = 12.0});
  drawing.text(x, kSphereHeight - 10.0, caption,
               {.anchor = TextAnchor::middle, .most_width = 0.48 * kSphereWidth});
}

void draw_mark(SvgDrawing& drawing, double x, double y, double radius, bool is_outside,
               const std::string& hover) {
  const std::string colour = series_colour(is_outside ? 0 : 1);
  const std::string circle =
      fmt::format("M{}m-{r} 0a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0z", point(x, y),
                  fmt::arg("r", coordinate(radius)), fmt::arg("d", coordinate(2.0 * radius)));
  drawing.path(circle,
               fmt::format("class=\"mark\" fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\" "
                           "stroke-width=\"1.6\"",
                           is_outside ? colour : kPaperColour, is_outside ? ".55" : ".3", colour),
               hover);
}

ChartLegend legend_of(const SphereMap& map) {
  std::vector<LegendEntry> entries;
  for (const bool outside : {true, false}) {
    entries.push_back(
        {outside ? map.outside : map.inside, [outside](SvgDrawing& drawing, double x, double y) {
           draw_mark(drawing, x, y, 5.0, outside, "");
         }});
  }
  return {std::move(entries), 4.0, kSphereWidth - 4.0};
}

}  // namespace

Figure figure_of(const SphereMap& map) {
  Figure figure{map.id, map.title, map.text, "", "", false};
  const std::size_t count = std::min(map.directions.size(), map.deviations_mm.size());
  double largest = 0.0;
  for (const double each : map.deviations_mm) {
    if (std::isfinite(each)) largest = std::max(largest, std::abs(each));
  }
  if (count == 0) {
    figure.svg = nothing_drawn(map.title, map.text, map.nothing);
    return figure;
  }
  SvgDrawing drawing(kSphereWidth, kSphereHeight);
  legend_of(map).draw(drawing, 16.0);
  draw_half(drawing, kMiddles_x[0], map.upper);
  draw_half(drawing, kMiddles_x[1], map.lower);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d& direction = map.directions[i];
    const double deviation = map.deviations_mm[i];
    if (!direction.allFinite() || !std::isfinite(deviation)) continue;
    const double level = direction.head<2>().norm();
    const double from_middle = kRadius * lambert(direction.z());
    const Eigen::Vector2d at = level > 0.0
                                   ? Eigen::Vector2d(direction.head<2>() * from_middle / level)
                                   : Eigen::Vector2d::Zero();
    const double share = largest > 0.0 ? std::abs(deviation) / largest : 0.0;
    draw_mark(drawing, kMiddles_x[direction.z() >= 0.0 ? 0 : 1] + at.x(), kCentre_y - at.y(),
              std::max(kSmallestMark, kLargestMark * std::sqrt(share)), deviation >= 0.0,
              fmt::format("{}: {} mm", i + 1, fixed(deviation, 4)));
  }
  figure.svg = drawing.finished(map.title, map.text, "sphere");
  return figure;
}

}  // namespace armcal
