// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/text_table.h"

#include <algorithm>

#include "armcal/core/invariant.h"

namespace armcal {
namespace {

// East Asian wide and fullwidth blocks (Unicode UAX 11, the parts that occur in names and units).
bool is_wide(char32_t c) {
  return (c >= 0x1100 && c <= 0x115F) || (c >= 0x2E80 && c <= 0xA4CF) ||
         (c >= 0xAC00 && c <= 0xD7A3) || (c >= 0xF900 && c <= 0xFAFF) ||
         (c >= 0xFE30 && c <= 0xFE6F) || (c >= 0xFF00 && c <= 0xFF60) ||
         (c >= 0xFFE0 && c <= 0xFFE6) || (c >= 0x20000 && c <= 0x3FFFD);
}

}  // namespace

std::size_t display_width(std::string_view utf8) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k) {
      code = code << 6 | (static_cast<unsigned char>(utf8[i + k]) & 0x3Fu);
    }
    width += is_wide(code) ? 2u : 1u;
    i += length;
  }
  return width;
}

void TextTable::add_row(std::vector<std::string> cells) {
  ARMCAL_INVARIANT(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(std::size_t indent) const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t width = display_width(columns_[c].title);
    for (const auto& row : rows_) width = std::max(width, display_width(row[c]));
    widths.push_back(width);
  }
  const auto line = [&](const auto& cell) {
    std::string text(indent, ' ');
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::string_view content = cell(c);
      const std::string padding(widths[c] - display_width(content), ' ');
      if (c > 0) text += "  ";
      if (columns_[c].align == Align::right) text += padding;
      text += content;
      if (columns_[c].align == Align::left) text += padding;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string result = line([&](std::size_t c) -> std::string_view { return columns_[c].title; });
  for (const auto& row : rows_) {
    result += line([&](std::size_t c) -> std::string_view { return row[c]; });
  }
  return result;
}

std::string TextTable::markdown() const {
  std::string titles = "|";
  std::string rule = "|";
  for (const Column& column : columns_) {
    titles += " " + column.title + " |";
    rule += column.align == Align::right ? "---:|" : "---|";
  }
  std::string result = titles + "\n" + rule + "\n";
  for (const auto& row : rows_) {
    result += "|";
    for (const std::string& cell : row) result += cell.empty() ? " |" : " " + cell + " |";
    result += "\n";
  }
  return result;
}

}  // namespace armcal
