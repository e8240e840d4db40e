// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "armcal/report/chart/scale.h"
#include "armcal/report/chart/svg.h"

namespace armcal {
namespace {

constexpr double kMapWidth = 480.0;
constexpr double kMapMostNames = 130.0;  // room for names
constexpr double kLeastCell = 13.0;      // a name is as high
constexpr double kMostCell = 40.0;
constexpr double kSigned = 0.15;  // of the full colour: weaker cells have no sign, unless asked for
constexpr int kMapShades = 20;
constexpr double kStrong = 0.6;  // shade on which text must be white
constexpr std::size_t kMostHovered = 400;
constexpr double kKey = 46.0;  // height of the colour key

constexpr const char* kNegative = "var(--negative, #2166ac)";
constexpr const char* kPositive = "var(--positive, #b35806)";

std::string shade_attributes(int shade) {
  return fmt::format("class=\"{}\" fill=\"{}\" fill-opacity=\"{}\"",
                     shade < 0 ? "negative" : "positive", shade < 0 ? kNegative : kPositive,
                     coordinate(static_cast<double>(std::abs(shade)) / kMapShades));
}

struct HeatCell {
  Eigen::Index row, column;
  double value;
  int shade;  // -kMapShades to kMapShades
};

class HeatPicture {
 public:
  explicit HeatPicture(const HeatMap& map) : map_(map) {
    for (Eigen::Index r = 0; r < map.values.rows(); ++r) {
      for (Eigen::Index c = 0; c < map.values.cols(); ++c) {
        if (std::isfinite(map.values(r, c))) cells_.push_back({r, c, map.values(r, c), 0});
      }
    }
    find_shades();
    lay_out();
  }

  [[nodiscard]] bool is_wide() const { return width_ > kMapWidth; }

  [[nodiscard]] std::string svg() const {
    if (cells_.empty()) return nothing_drawn(map_.title, map_.text, map_.nothing);
    SvgDrawing drawing(width_, top_ + cell_ * static_cast<double>(map_.values.rows()) + kKey);
    draw_names(drawing);
    drawing.rectangle(left_, top_, cell_ * static_cast<double>(map_.values.cols()),
                      cell_ * static_cast<double>(map_.values.rows()),
                      "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".3\"");
    draw_cells(drawing);
    draw_signs(drawing);
    draw_key(drawing);
    return drawing.finished(map_.title, map_.text, is_wide() ? "heat wide" : "heat");
  }

 private:
  void find_shades() {
    largest_ = std::isfinite(map_.largest) ? map_.largest : 0.0;
    if (!(largest_ > 0.0)) {
      largest_ = 0.0;
      for (const HeatCell& cell : cells_) largest_ = std::max(largest_, std::abs(cell.value));
    }
    if (!(largest_ > 0.0)) largest_ = 1.0;
    for (HeatCell& cell : cells_) {
      const double part = std::clamp(cell.value / largest_, -1.0, 1.0);
      cell.shade = static_cast<int>(std::lround(part * kMapShades));
    }
  }

  void lay_out() {
    double widest = 0.0;
    for (const std::string& name : map_.rows) widest = std::max(widest, text_width(name, 12.0));
    left_ = std::min(kMapMostNames, widest) + 10.0;
    widest = 0.0;
    for (const std::string& name : map_.columns) widest = std::max(widest, text_width(name, 12.0));
    top_ = std::min(kMapMostNames, widest) + 10.0;
    const auto columns = static_cast<double>(std::max<Eigen::Index>(1, map_.values.cols()));
    cell_ = std::clamp((kMapWidth - left_ - 8.0) / columns, kLeastCell, kMostCell);
    width_ = std::max(kMapWidth, left_ + cell_ * columns + 8.0);
  }

  [[nodiscard]] double x_of(Eigen::Index column) const {
    return left_ + cell_ * static_cast<double>(column);
  }
  [[nodiscard]] double y_of(Eigen::Index row) const {
    return top_ + cell_ * static_cast<double>(row);
  }

  void draw_names(SvgDrawing& drawing) const {
    for (Eigen::Index r = 0; r < map_.values.rows(); ++r) {
      drawing.text(left_ - 5.0, y_of(r) + 0.5 * cell_ + 4.0, name_of(map_.rows, r),
                   {.anchor = TextAnchor::end, .size = 12.0, .most_width = left_ - 8.0});
    }
    for (Eigen::Index c = 0; c < map_.values.cols(); ++c) {
      drawing.element(fmt::format("<g transform=\"translate({}) rotate(-90)\">",
                                  point(x_of(c) + 0.5 * cell_ + 4.0, top_ - 5.0)));
      drawing.text(0.0, 0.0, name_of(map_.columns, c), {.size = 12.0, .most_width = top_ - 8.0});
      drawing.element("</g>\n");
    }
  }

  [[nodiscard]] static std::string name_of(const std::vector<std::string>& names,
                                           Eigen::Index place) {
    const auto at = static_cast<std::size_t>(place);
    return at < names.size() ? names[at] : std::string();
  }

  [[nodiscard]] std::string square(const HeatCell& cell) const {
    const std::string side = coordinate(cell_ - 1.0);
    return fmt::format("M{}h{}v{}h-{}z", point(x_of(cell.column) + 0.5, y_of(cell.row) + 0.5), side,
                       side, side);
  }

  // The strongest cells one by one, with what is shown when they are hovered; the others of one
  // shade together, which keeps the drawing of a large matrix small.
  void draw_cells(SvgDrawing& drawing) const {
    std::vector<HeatCell> sorted = cells_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const HeatCell& a, const HeatCell& b) {
      return std::abs(a.value) > std::abs(b.value);
    });
    std::array<std::string, 2 * kMapShades + 1> others;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const HeatCell& cell = sorted[i];
      if (i < kMostHovered) {
        drawing.path(square(cell), shade_attributes(cell.shade),
                     fmt::format("{}, {}: {}", name_of(map_.rows, cell.row),
                                 name_of(map_.columns, cell.column),
                                 signed_text(cell.value, map_.decimals)));
      } else if (cell.shade != 0) {
        others[static_cast<std::size_t>(cell.shade + kMapShades)] += square(cell);
      }
    }
    for (int shade = -kMapShades; shade <= kMapShades; ++shade) {
      drawing.path(others[static_cast<std::size_t>(shade + kMapShades)], shade_attributes(shade));
    }
  }

  void draw_signs(SvgDrawing& drawing) const {
    if (has_values()) {
      for (const HeatCell& cell : cells_) {
        if (!is_marked(cell, map_.least_marked)) continue;
        const bool is_strong = std::abs(cell.shade) > kStrong * kMapShades;
        drawing.element("<g pointer-events=\"none\">");
        drawing.text(x_of(cell.column) + 0.5 * cell_, y_of(cell.row) + 0.5 * cell_ + 4.0,
                     signed_text(cell.value, map_.decimals),
                     {.style = "value",
                      .anchor = TextAnchor::middle,
                      .size = 11.0,
                      .fill = is_strong ? "#fff" : "currentColor"});
        drawing.element("</g>");
      }
      return;
    }
    std::array<std::string, 2> signs;  // on weak and on strong shades
    for (const HeatCell& cell : cells_) {
      if (!is_marked(cell, map_.least_marked > 0.0 ? map_.least_marked : kSigned)) continue;
      const double half = 0.22 * cell_;
      const double x = x_of(cell.column) + 0.5 * cell_;
      const double y = y_of(cell.row) + 0.5 * cell_;
      std::string sign = fmt::format("M{}h{}", point(x - half, y), coordinate(2.0 * half));
      if (cell.value > 0.0) {
        sign += fmt::format("M{}v{}", point(x, y - half), coordinate(2.0 * half));
      }
      signs[std::abs(cell.shade) > kStrong * kMapShades ? 1 : 0] += sign;
    }
    drawing.path(signs[0], "class=\"cell-sign\" stroke=\"currentColor\" pointer-events=\"none\"");
    drawing.path(signs[1], "class=\"cell-sign\" stroke=\"#fff\" pointer-events=\"none\"");
  }

  [[nodiscard]] bool is_marked(const HeatCell& cell, double least) const {
    return std::abs(cell.value) >= least * largest_;
  }

  [[nodiscard]] bool has_values() const {
    double widest = 0.0;
    for (const HeatCell& cell : cells_) {
      widest = std::max(widest, text_width(signed_text(cell.value, map_.decimals), 11.0));
    }
    return widest < cell_ - 2.0 && cells_.size() <= kMostHovered;
  }

  void draw_key(SvgDrawing& drawing) const {
    const double y = drawing.height() - kKey + 14.0;
    const double step = 9.0;
    const int steps = 10;
    double x = left_;
    for (int i = -steps; i <= steps; ++i) {
      drawing.rectangle(x + step * (i + steps), y, step, 11.0,
                        shade_attributes(i * kMapShades / steps));
    }
    const double end = x + step * (2 * steps + 1);
    drawing.rectangle(x, y, end - x, 11.0,
                      "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".3\"");
    const TextLook tick{.style = "tick", .anchor = TextAnchor::middle, .size = 12.0};
    drawing.text(x, y + 25.0, signed_text(-largest_, map_.decimals), tick);
    drawing.text(0.5 * (x + end), y + 25.0, "0", tick);
    drawing.text(end, y + 25.0, signed_text(largest_, map_.decimals), tick);
    drawing.text(end + 12.0, y + 10.0, map_.key_label,
                 {.style = "legend", .size = 12.0, .most_width = width_ - end - 16.0});
  }

  const HeatMap& map_;
  std::vector<HeatCell> cells_;
  double largest_ = 1.0;
  double left_ = 0.0, top_ = 0.0, cell_ = 0.0, width_ = kMapWidth;
};

}  // namespace

Figure figure_of(const HeatMap& map) {
  const HeatPicture picture(map);
  return {.id = map.id,
          .title = map.title,
          .text = map.text,
          .svg = picture.svg(),
          .live = "",
          .is_wide = picture.is_wide()};
}

}  // namespace armcal
