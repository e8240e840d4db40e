// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/svg.h"

#include <fmt/format.h>

#include <cmath>

#include "armcal/io/xml_text.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

// Width of a character in the height of the text; digits of wide sans-serif faces take 0.636, most
// take 0.556.
constexpr double kCharacter = 0.6;
constexpr double kMostEnlarged = 1.1;

std::string trimmed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text.empty() || text == "-" || text == "-0" ? "0" : text;
}

const char* name_of(TextAnchor anchor) {
  switch (anchor) {
    case TextAnchor::middle:
      return " text-anchor=\"middle\"";
    case TextAnchor::end:
      return " text-anchor=\"end\"";
    case TextAnchor::start:
      break;
  }
  return "";
}

std::string hover_title(std::string_view text) {
  return fmt::format("<title>{}</title>", xml_escaped(text));
}

}  // namespace

std::string coordinate(double value) { return trimmed(std::isfinite(value) ? value : 0.0, 2); }

std::string point(double x, double y) {
  const auto short_text = [](double value) {
    return trimmed(std::isfinite(value) ? value + 0.0 : 0.0, 1);
  };
  return short_text(x) + " " + short_text(y);
}

double text_width(std::string_view text, double size) {
  return kCharacter * size * static_cast<double>(display_width(text));
}

std::string shortened(std::string_view text, double width, double size) {
  if (text_width(text, size) <= width) return std::string(text);
  std::size_t kept = 0;
  double used = size;  // of the ellipsis
  while (kept < text.size()) {
    // Whole characters: bytes 10xxxxxx continue one.
    std::size_t next = kept + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0u) == 0x80u) ++next;
    used += text_width(text.substr(kept, next - kept), size);
    if (used > width) break;
    kept = next;
  }
  return std::string(text.substr(0, kept)) + "\u2026";
}

void SvgDrawing::text(double x, double y, std::string_view text, const TextLook& look) {
  if (text.empty()) return;
  const std::string shown = shortened(text, look.most_width, look.size);
  body_ += fmt::format(
      "<text class=\"{}\" x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{}{}{}>{}{}</text>\n",
      look.style, coordinate(x), coordinate(y), coordinate(look.size), look.fill,
      name_of(look.anchor), look.is_bold ? " font-weight=\"600\"" : "",
      look.has_halo ? fmt::format(" stroke=\"{}\" stroke-width=\"4\" stroke-linejoin=\"round\" "
                                  "paint-order=\"stroke\"",
                                  kPaperColour)
                    : "",
      xml_escaped(shown), shown == text ? "" : hover_title(text));
}

void SvgDrawing::line(double x1, double y1, double x2, double y2, std::string_view attributes) {
  path(fmt::format("M{} {}L{} {}", coordinate(x1), coordinate(y1), coordinate(x2), coordinate(y2)),
       attributes);
}

void SvgDrawing::rectangle(double x, double y, double width, double height,
                           std::string_view attributes) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", coordinate(x),
                       coordinate(y), coordinate(width), coordinate(height), attributes);
}

void SvgDrawing::circle(double x, double y, double radius, std::string_view attributes) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", coordinate(x), coordinate(y),
                       coordinate(radius), attributes);
}

void SvgDrawing::path(std::string_view d, std::string_view attributes, std::string_view hover) {
  if (d.empty()) return;
  body_ += fmt::format("<path d=\"{}\" {}{}\n", d, attributes,
                       hover.empty() ? "/>" : fmt::format(">{}</path>", hover_title(hover)));
}

std::string SvgDrawing::finished(std::string_view title, std::string_view description,
                                 std::string_view style) const {
  // Never so large that its text shouts.
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart{}{}\" viewBox=\"0 0 {} {}\" "
      "role=\"img\" style=\"max-width:{:.0f}px\" fill=\"none\" "
      "font-family=\"system-ui, sans-serif\">\n<title>{}</title>\n<desc>{}</desc>\n{}</svg>\n",
      style.empty() ? "" : " ", style, coordinate(width_), coordinate(height_),
      kMostEnlarged * width_, xml_escaped(title), xml_escaped(description), body_);
}

std::string nothing_drawn(std::string_view title, std::string_view description,
                          std::string_view nothing) {
  constexpr double kWidth = 480.0, kHeight = 120.0;
  SvgDrawing drawing(kWidth, kHeight);
  drawing.rectangle(1.0, 1.0, kWidth - 2.0, kHeight - 2.0,
                    "class=\"grid\" rx=\"6\" stroke=\"currentColor\" stroke-opacity=\".25\" "
                    "stroke-dasharray=\"4 4\"");
  drawing.text(0.5 * kWidth, 0.5 * kHeight + 4.0, nothing,
               {.anchor = TextAnchor::middle, .most_width = kWidth - 24.0});
  return drawing.finished(title, description, "nothing");
}

std::string series_colour(int style) {
  static constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73",
                                             "#cc79a7", "#e69f00", "#56b4e9"};
  const int colour = (style % 6 + 6) % 6;
  return fmt::format("var(--series-{}, {})", colour, kColours[colour]);
}

const char* tone_colour(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "var(--good, #1a7f37)";
    case Tone::bad:
      return "var(--bad, #cf222e)";
    case Tone::warning:
      return "var(--warning, #9a6700)";
    case Tone::neutral:
      break;
  }
  return "currentColor";
}

}  // namespace armcal
