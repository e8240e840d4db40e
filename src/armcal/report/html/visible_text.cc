// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/visible_text.h"

#include <fmt/format.h>

namespace armcal {
namespace {

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\n' && c != '\t' && c != '\r') || code == 0x7f;
}

// The last byte of a direction mark, E2 80 AA .. AE and E2 81 A6 .. A9; 0: there is none here.
int direction_mark(std::string_view text) {
  if (text.size() < 3 || text[0] != '\xe2') return 0;
  const auto middle = static_cast<unsigned char>(text[1]);
  const auto last = static_cast<unsigned char>(text[2]);
  if (middle == 0x80 && last >= 0xaa && last <= 0xae) return 0x2000 + (last - 0x80);
  if (middle == 0x81 && last >= 0xa6 && last <= 0xa9) return 0x2040 + (last - 0x80);
  return 0;
}

}  // namespace

std::string visible_text(std::string_view utf8) {
  std::string seen;
  seen.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    if (is_control(utf8[i])) {
      const auto code = static_cast<unsigned char>(utf8[i]);
      seen += "\xe2\x90";  // U+2400 onwards
      seen += static_cast<char>(code == 0x7f ? 0xa1 : 0x80 + code);
    } else if (const int mark = direction_mark(utf8.substr(i)); mark != 0) {
      seen += fmt::format("[U+{:04X}]", mark);
      i += 2;
    } else {
      seen += utf8[i];
    }
  }
  return seen;
}

}  // namespace armcal
