// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/limit_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

constexpr double kBarWidth = 520.0;
constexpr double kBarMargin = 10.0;
constexpr double kBarRow = 88.0;                        // two lines of text and a track
constexpr double kExtraLine = 17.0;                     // for a second value
constexpr double kTrack = 14.0;                         // height of the track
constexpr double kBarMark = 4.6;                        // half of a mark
constexpr double kLeastShown = 1.25, kMostShown = 2.0;  // end of the scale in MPE

// An id of the page's own letters, unique as the figure's is.
std::string hatch_of(const LimitBars& bars) { return bars.id + "-hatch"; }

bool is_finite(const std::optional<LimitedValue>& value) {
  return value && std::isfinite(value->value);
}

double share(const LimitBarRow& row, const std::optional<LimitedValue>& value) {
  if (!is_finite(value) || !(row.mpe > 0.0)) return 0.0;
  const double u = std::isfinite(value->U) ? value->U : 0.0;
  return (std::abs(value->value) + u) / row.mpe;
}

double end_of_scale(const LimitBars& bars) {
  double end = kLeastShown;
  for (const LimitBarRow& row : bars.rows) {
    if (!(row.mpe > 0.0)) continue;
    end = std::max({end, 1.03 * share(row, row.as_found), 1.03 * share(row, row.as_left),
                    1.05 + (row.is_undecided_beyond ? row.guard / row.mpe : 0.0)});
  }
  return std::min(end, kMostShown);
}

bool has_two_sided(const LimitBars& bars) {
  return std::any_of(bars.rows.begin(), bars.rows.end(),
                     [](const LimitBarRow& row) { return row.is_two_sided && row.mpe > 0.0; });
}

void draw_mark(SvgDrawing& drawing, double x, double y, bool is_filled, const std::string& colour) {
  const std::string attributes =
      fmt::format("class=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"",
                  is_filled ? "as-left" : "as-found", is_filled ? colour : kPaperColour, colour);
  if (is_filled) {
    drawing.circle(x, y, kBarMark, attributes);
  } else {
    drawing.path(fmt::format("M{}l5.5 5.5-5.5 5.5-5.5-5.5z", point(x, y - 5.5)), attributes);
  }
}

std::string hatch(const std::string& id) { return fmt::format("url(#{})", id); }

void draw_hatch(SvgDrawing& drawing, const std::string& id, double x1, double x2, double y) {
  drawing.rectangle(std::min(x1, x2), y, std::abs(x2 - x1), kTrack,
                    fmt::format("class=\"guarded\" fill=\"{}\"", hatch(id)));
}

std::string pattern(const std::string& id) {
  return fmt::format(
      "<defs><pattern id=\"{}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><path d=\"M0 0v6\" stroke=\"{}\" stroke-width=\"3\" "
      "stroke-opacity=\".75\"/></pattern></defs>\n",
      id, tone_colour(Tone::warning));
}

std::string pass_attributes() {
  return fmt::format("class=\"passes\" fill=\"{}\" fill-opacity=\".22\"", tone_colour(Tone::good));
}

class LimitPicture {
 public:
  explicit LimitPicture(const LimitBars& bars)
      : bars_(bars),
        end_(end_of_scale(bars)),
        x_(AxisScale::linear, {has_two_sided(bars) ? -end_ : 0.0, end_}, kBarMargin,
           kBarWidth - kBarMargin),
        legend_(entries(), 4.0, kBarWidth - 4.0) {
    for (const LimitBarRow& row : bars.rows) {
      for (const auto* value : {&row.as_found, &row.as_left}) {
        if (*value) verdicts_ = std::max(verdicts_, text_width(verdict_of(**value), kTextSize));
      }
    }
  }

  [[nodiscard]] std::string svg() const {
    if (bars_.rows.empty()) return nothing_drawn(bars_.title, bars_.text, bars_.nothing);
    const double legend_height = ChartLegend::kRowHeight * legend_.rows() + 10.0;
    double height = legend_height + 4.0;
    for (const LimitBarRow& row : bars_.rows) height += height_of(row);
    SvgDrawing drawing(kBarWidth, height);
    drawing.element(pattern(hatch_of(bars_)));
    legend_.draw(drawing, 16.0);
    double y = legend_height;
    for (const LimitBarRow& row : bars_.rows) {
      draw(drawing, row, y);
      y += height_of(row);
    }
    return drawing.finished(bars_.title, bars_.text, "limits");
  }

 private:
  [[nodiscard]] static double height_of(const LimitBarRow& row) {
    return kBarRow + (row.as_found && row.as_left ? kExtraLine : 0.0) -
           (row.mpe > 0.0 ? 0.0 : 1.6 * kTrack);
  }

  [[nodiscard]] std::vector<LegendEntry> entries() const {
    const auto any = [&](auto&& is_so) {
      return std::any_of(bars_.rows.begin(), bars_.rows.end(), is_so);
    };
    std::vector<LegendEntry> entries;
    const auto add = [&](bool is_drawn, const std::string& name, auto&& sample) {
      if (is_drawn && !name.empty()) entries.push_back({name, sample});
    };
    add(any([](const LimitBarRow& row) { return is_finite(row.as_found); }), bars_.as_found,
        [](SvgDrawing& drawing, double x, double y) {
          draw_mark(drawing, x, y, false, "currentColor");
        });
    add(any([](const LimitBarRow& row) { return is_finite(row.as_left); }), bars_.as_left,
        [](SvgDrawing& drawing, double x, double y) {
          draw_mark(drawing, x, y, true, "currentColor");
        });
    add(any([](const LimitBarRow& row) {
          return (row.as_found && row.as_found->U > 0.0) || (row.as_left && row.as_left->U > 0.0);
        }),
        bars_.uncertainty, [](SvgDrawing& drawing, double x, double y) {
          draw_reach(drawing, x - 11.0, x + 11.0, y, "currentColor");
        });
    add(any([](const LimitBarRow& row) { return row.mpe > 0.0; }), bars_.passes,
        [](SvgDrawing& drawing, double x, double y) {
          drawing.rectangle(x - 11.0, y - 5.5, 22.0, 11.0, pass_attributes());
        });
    add(any([](const LimitBarRow& row) { return row.mpe > 0.0 && row.guard > 0.0; }), bars_.guarded,
        [id = hatch_of(bars_)](SvgDrawing& drawing, double x, double y) {
          drawing.rectangle(x - 11.0, y - 5.5, 22.0, 11.0,
                            fmt::format("class=\"guarded\" fill=\"{}\"", hatch(id)));
        });
    return entries;
  }

  static void draw_reach(SvgDrawing& drawing, double x1, double x2, double y,
                         const std::string& colour) {
    drawing.path(fmt::format("M{}v8M{}v8M{}H{}", point(x1, y - 4.0), point(x2, y - 4.0),
                             point(x1, y), coordinate(x2)),
                 fmt::format("class=\"reach\" stroke=\"{}\" stroke-width=\"2\"", colour));
  }

  void draw(SvgDrawing& drawing, const LimitBarRow& row, double top) const {
    const double right = kBarWidth - kBarMargin;
    double value_width = 0.0;
    double line = top + 15.0;
    const bool has_both = row.as_found && row.as_left;
    if (has_both) {
      value_width = write(drawing, *row.as_found, false, right, line);
      line += kExtraLine;
    }
    if (row.as_left || row.as_found) {
      const bool is_left = row.as_left.has_value();
      value_width = std::max(value_width, write(drawing, is_left ? *row.as_left : *row.as_found,
                                                is_left, right, line));
    }
    const double room = right - kBarMargin - value_width - 14.0;
    drawing.text(kBarMargin, top + 15.0, row.name, {.is_bold = true, .most_width = room});
    drawing.text(
        kBarMargin, top + 31.0, row.symbol,
        {.style = "tick", .size = 12.0, .most_width = has_both ? room : right - kBarMargin});
    if (row.mpe > 0.0) draw_track(drawing, row, top + (has_both ? kExtraLine : 0.0) + 43.0);
  }

  [[nodiscard]] static std::string verdict_of(const LimitedValue& value) {
    return value.word.empty() ? "" : fmt::format("{} {}", tone_sign(value.tone), value.word);
  }

  // Mark, value, sign and word, in columns at the right. @return how wide they are
  [[nodiscard]] double write(SvgDrawing& drawing, const LimitedValue& value, bool is_left,
                             double right, double base) const {
    const double values_right = right - verdicts_ - (verdicts_ > 0.0 ? 12.0 : 0.0);
    drawing.text(values_right + 12.0, base, verdict_of(value),
                 {.fill = tone_colour(value.tone), .is_bold = true});
    drawing.text(values_right, base, value.text, {.anchor = TextAnchor::end});
    const double mark = values_right - text_width(value.text, kTextSize) - 17.0;
    draw_mark(drawing, mark, base - 4.5, is_left, tone_colour(value.tone));
    return right - mark + 8.0;
  }

  void draw_track(SvgDrawing& drawing, const LimitBarRow& row, double y) const {
    const double guard = std::isfinite(row.guard) ? row.guard / row.mpe : 0.0;
    const double low = row.is_two_sided ? -end_ : 0.0;
    drawing.rectangle(x_.at(low), y, x_.at(end_) - x_.at(low), kTrack,
                      "class=\"track\" fill=\"currentColor\" fill-opacity=\".08\"");
    const double passing = std::max(0.0, 1.0 - guard);
    const double passing_low = row.is_two_sided ? -passing : 0.0;
    drawing.rectangle(x_.at(passing_low), y, x_.at(passing) - x_.at(passing_low), kTrack,
                      pass_attributes());
    for (const int side : {-1, 1}) {
      if (side < 0 && !row.is_two_sided) continue;
      const double beyond = row.is_undecided_beyond ? 1.0 + guard : 1.0;
      if (guard > 0.0) {
        draw_hatch(drawing, hatch_of(bars_), x_.at(side * passing), x_.at(side * beyond), y);
      }
      const double x = x_.at(side);
      drawing.line(x, y - 4.0, x, y + kTrack + 4.0,
                   "class=\"limit neutral\" stroke=\"currentColor\" stroke-width=\"2\"");
    }
    const double zero = x_.at(0.0);
    drawing.line(zero, y, zero, y + kTrack, "class=\"axis\" stroke=\"currentColor\"");
    // Above the limit's tick, where nothing else is.
    const double limit = x_.at(1.0);
    const double half = 0.5 * text_width(row.limit, 12.0);
    drawing.text(std::min(limit, kBarWidth - 2.0 - half), y + kTrack + 15.0, row.limit,
                 {.style = "tick", .anchor = TextAnchor::middle, .size = 12.0});
    if (row.as_found) draw(drawing, row, *row.as_found, false, y + 0.5 * kTrack);
    if (row.as_left) draw(drawing, row, *row.as_left, true, y + 0.5 * kTrack);
  }

  void draw(SvgDrawing& drawing, const LimitBarRow& row, const LimitedValue& value, bool is_left,
            double y) const {
    if (!std::isfinite(value.value)) return;
    const std::string colour = tone_colour(value.tone);
    const double at = row.is_two_sided ? value.value / row.mpe : std::abs(value.value) / row.mpe;
    const bool is_beyond = std::abs(at) > end_;
    if (value.U > 0.0 && std::isfinite(value.U) && !is_beyond) {
      draw_reach(drawing, x_.at(at - value.U / row.mpe), x_.at(at + value.U / row.mpe), y, colour);
    }
    if (!is_beyond) {
      draw_mark(drawing, x_.at(at), y, is_left, colour);
      return;
    }
    const double x = x_.at(at) - (at > 0.0 ? 2.0 : -2.0);
    drawing.path(fmt::format("M{}l{} -6v12z", point(x, y), at > 0.0 ? "-11" : "11"),
                 fmt::format("class=\"beyond\" fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"",
                             is_left ? colour : kPaperColour, colour));
  }

  const LimitBars& bars_;
  double end_;
  ChartScale x_;
  ChartLegend legend_;
  double verdicts_ = 0.0;  // width of their column
};

}  // namespace

Figure figure_of(const LimitBars& bars) {
  return {.id = bars.id,
          .title = bars.title,
          .text = bars.text,
          .svg = LimitPicture(bars).svg(),
          .live = "",
          .is_wide = false};
}

}  // namespace armcal
