// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/language.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/report/html/assets.h"

namespace armcal {
namespace {

// {"a": {"b": "text"}} becomes a.b.
void collect(const nlohmann::json& json, const std::string& prefix,
             std::map<std::string, std::string, std::less<>>& texts) {
  for (const auto& [name, value] : json.items()) {
    const std::string key = prefix.empty() ? name : fmt::format("{}.{}", prefix, name);
    if (value.is_object()) {
      collect(value, key, texts);
    } else {
      texts.emplace(key, value.get<std::string>());
    }
  }
}

}  // namespace

Language::Language(std::string code, std::string_view json) : code_(std::move(code)) {
  collect(nlohmann::json::parse(json), "", texts_);
}

std::vector<std::string> Language::codes() { return {"en", "zh"}; }

const Language& Language::named(std::string_view code) {
  static const Language english("en", report_asset("en.json"));
  static const Language chinese("zh", report_asset("zh.json"));
  if (code == "en") return english;
  if (code == "zh") return chinese;
  throw std::invalid_argument(fmt::format("there is no language \"{}\" (there are: en, zh)", code));
}

bool Language::has(std::string_view key) const { return texts_.find(key) != texts_.end(); }

std::vector<std::string> Language::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, text] : texts_) keys.push_back(key);
  return keys;
}

std::string Language::say(std::string_view key, std::span<const std::string> values) const {
  const auto found = texts_.find(key);
  if (found == texts_.end()) {
    throw std::logic_error(fmt::format("languages/{}.json has no text \"{}\"", code_, key));
  }
  const std::string& text = found->second;
  std::string said;
  for (std::size_t i = 0; i < text.size(); ++i) {
    // {0} to {9}; values may hold braces themselves and are not looked at again.
    const bool is_slot = text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}' &&
                         text[i + 1] >= '0' && text[i + 1] <= '9';
    if (!is_slot) {
      said += text[i];
      continue;
    }
    const auto place = static_cast<std::size_t>(text[i + 1] - '0');
    if (place >= values.size()) {
      throw std::logic_error(fmt::format("text \"{}\" wants more values than it gets", key));
    }
    said += values[place];
    i += 2;
  }
  return said;
}

}  // namespace armcal
