// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/script_json.h"

namespace armcal {
namespace {

// What script_safe() wrote instead of a character; 0: something else.
char character_of(std::string_view escape) {
  return escape == "\\u003c" ? '<' : escape == "\\u003e" ? '>' : escape == "\\u0026" ? '&' : '\0';
}

}  // namespace

std::string script_safe(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string from_script(std::string_view safe) {
  std::string json;
  json.reserve(safe.size());
  for (std::size_t i = 0; i < safe.size(); ++i) {
    if (safe[i] != '\\') {
      json += safe[i];
    } else if (const char c = character_of(safe.substr(i, 6)); c != '\0') {
      json += c;
      i += 5;
    } else {  // an escape of the JSON itself: two characters that belong together
      json += safe.substr(i, 2);
      ++i;
    }
  }
  return json;
}

}  // namespace armcal
