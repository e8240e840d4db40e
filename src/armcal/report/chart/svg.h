// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "armcal/report/html/page.h"

namespace armcal {

enum class TextAnchor { start, middle, end };

struct TextLook {
  const char* style = "label";  ///< class: label, tick, legend
  TextAnchor anchor = TextAnchor::start;
  double size = 13.0;
  const char* fill = "currentColor";
  bool has_halo = false;  ///< stands over other things
  bool is_bold = false;
  double most_width = 1e9;  ///< longer text is cut, and whole when hovered
};

/// An SVG drawing while it grows. Everything has presentation attributes, so that it looks right
/// without a style sheet, and classes by which a style sheet may say otherwise. Ink is the colour
/// of the text around the drawing: light or dark as that is.
class SvgDrawing {
 public:
  SvgDrawing(double width, double height) : width_(width), height_(height) {}

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  /// A text as it came from anywhere: it is escaped here.
  void text(double x, double y, std::string_view text, const TextLook& look = {});
  // Attributes are the drawer's own: nothing from outside may stand in them.
  void line(double x1, double y1, double x2, double y2, std::string_view attributes);
  void rectangle(double x, double y, double width, double height, std::string_view attributes);
  void circle(double x, double y, double radius, std::string_view attributes);
  /// @param hover  text that is shown over the path; empty: none
  void path(std::string_view d, std::string_view attributes, std::string_view hover = {});
  void element(std::string_view svg) { body_ += svg; }

  /// The whole element.
  /// @param style  further classes
  [[nodiscard]] std::string finished(std::string_view title, std::string_view description,
                                     std::string_view style = {}) const;

 private:
  double width_;
  double height_;
  std::string body_;
};

/// A drawing that says that there is nothing to draw.
[[nodiscard]] std::string nothing_drawn(std::string_view title, std::string_view description,
                                        std::string_view nothing);

/// At most two decimals and no zeros behind them; finite.
[[nodiscard]] std::string coordinate(double value);
/// "12.5 7": rounded to a tenth.
[[nodiscard]] std::string point(double x, double y);

/// A little more than the text will take.
[[nodiscard]] double text_width(std::string_view text, double size);
/// As much of the text as there is room for, with an ellipsis where that is not all.
[[nodiscard]] std::string shortened(std::string_view text, double width, double size);

/// "var(--series-0, #0072b2)": the theme's colour, else one of the Okabe-Ito palette.
[[nodiscard]] std::string series_colour(int style);
[[nodiscard]] const char* tone_colour(Tone tone);

inline constexpr const char* kPaperColour = "var(--paper, Canvas)";
inline constexpr double kTextSize = 13.0;

}  // namespace armcal
