// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/phrase_book.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <vector>

namespace armcal {
namespace {

constexpr std::size_t kMostSlots = 6;

// Written where a value belongs: control characters, which no text of the language files has.
const std::array<std::string, kMostSlots> kMarks = {"\x01", "\x02", "\x03", "\x04", "\x05", "\x06"};

struct Pattern {
  std::string key;
  std::vector<std::string> between;  // one more than slots; the first and the last may be empty
  std::vector<std::size_t> slots;    // which value each slot is of
  std::size_t literal = 0;           // characters that are not of slots
};

// An English text taken apart at its slots.
Pattern pattern_of(const std::string& key) {
  const std::string text =
      Language::named("en")(key, kMarks[0], kMarks[1], kMarks[2], kMarks[3], kMarks[4], kMarks[5]);
  Pattern pattern;
  pattern.key = key;
  pattern.between.emplace_back();
  for (const char c : text) {
    if (c >= '\x01' && c <= '\x06') {
      pattern.slots.push_back(static_cast<std::size_t>(c - '\x01'));
      pattern.between.emplace_back();
    } else {
      pattern.between.back() += c;
      ++pattern.literal;
    }
  }
  return pattern;
}

const std::vector<Pattern>& all_patterns() {
  static const std::vector<Pattern> patterns = [] {
    std::vector<Pattern> found;
    for (const std::string& key : Language::named("en").keys()) {
      if (key.find(".phrase.") != std::string::npos) found.push_back(pattern_of(key));
    }
    return found;
  }();
  return patterns;
}

using Values = std::array<std::string, kMostSlots>;

std::optional<Values> matched(const Pattern& pattern, std::string_view phrase) {
  if (phrase.rfind(pattern.between.front(), 0) != 0) return std::nullopt;
  std::size_t at = pattern.between.front().size();
  if (pattern.slots.empty()) return at == phrase.size() ? std::optional(Values{}) : std::nullopt;
  Values values;
  for (std::size_t i = 0; i < pattern.slots.size(); ++i) {
    const std::string& next = pattern.between[i + 1];
    const bool is_last = i + 1 == pattern.slots.size();
    std::size_t end = std::string_view::npos;
    if (!is_last) {
      end = phrase.find(next, at + 1);
    } else if (phrase.size() > at + next.size() && phrase.ends_with(next)) {
      end = phrase.size() - next.size();
    }
    if (end == std::string_view::npos || end <= at) return std::nullopt;
    values[pattern.slots[i]] = std::string(phrase.substr(at, end - at));
    at = end + next.size();
  }
  return values;
}

}  // namespace

std::string in_language(const std::string& phrase, std::string_view under, const Language& say) {
  const std::string prefix = fmt::format("{}.", under);
  const Pattern* best = nullptr;
  Values values;
  for (const Pattern& pattern : all_patterns()) {
    if (pattern.key.rfind(prefix, 0) != 0) continue;
    if (best != nullptr && pattern.literal <= best->literal) continue;
    if (auto found = matched(pattern, phrase)) {
      best = &pattern;
      values = std::move(*found);
    }
  }
  if (best == nullptr) return phrase;
  return say(best->key, values[0], values[1], values[2], values[3], values[4], values[5]);
}

}  // namespace armcal
