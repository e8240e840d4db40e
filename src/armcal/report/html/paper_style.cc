// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/paper_style.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

namespace armcal {
namespace {

// A text of CSS: what could end it, or the style element, is written as a number.
std::string css_text(std::string_view text) {
  std::string css = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain =
        std::isalnum(code) != 0 || c == ' ' || c == '-' || c == '.' || code >= 0x80;
    css += is_plain ? std::string(1, c) : fmt::format("\\{:x} ", code);
  }
  return css + "\"";
}

}  // namespace

std::string paper_style(const std::string& foot, const Language& language) {
  const std::string_view slot = "\x1f";
  const std::string counted = language("paper.page_of", slot, slot);
  const std::size_t first = counted.find(slot);
  const std::size_t second = counted.find(slot, first + 1);
  const std::string_view text = counted;
  return fmt::format(
      "@page{{@bottom-left{{content:{}}}@bottom-right{{content:{} counter(page) {} counter(pages) "
      "{}}}}}",
      css_text(foot), css_text(text.substr(0, first)),
      css_text(text.substr(first + 1, second - first - 1)), css_text(text.substr(second + 1)));
}

}  // namespace armcal
