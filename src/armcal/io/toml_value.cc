// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/toml_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

// toml++ 3.3 asserts that the name of a table begins with a letter, digit or quote, where it should
// complain; and without assertions it takes that for granted. So they stay on, and throw.
#ifdef NDEBUG
#undef NDEBUG
#define ARMCAL_HAD_NDEBUG
#endif
namespace armcal {
static constexpr void toml_expects(bool condition) {
  if (!condition) throw std::logic_error("toml++ did not expect this");
}
}  // namespace armcal
#define TOML_ASSERT(condition) ::armcal::toml_expects(static_cast<bool>(condition))
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>
#ifdef ARMCAL_HAD_NDEBUG
#define NDEBUG
#endif

#include "armcal/core/invariant.h"
#include "armcal/core/spelling.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

// toml++ 3.3 leaves defined behaviour when it asks whether some letters outside ASCII are white
// space
// (`is_non_ascii_horizontal_whitespace`). It never asks of those beyond U+FFFF, so while it parses,
// every character from U+0080 to U+FFFF stands in private use plane 15, as U+F0000 more.

std::string in_plane_15(std::string_view utf8) {
  std::string result;
  result.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const int lead = static_cast<unsigned char>(utf8[i]);
    if (lead >= 0xC0 && lead < 0xE0) {
      result += {'\xF3', '\xB0', static_cast<char>(0x80 | (lead & 0x1F))};
    } else if (lead >= 0xE0 && lead < 0xF0) {
      result += {'\xF3', static_cast<char>(0xB0 | (lead & 0x0F))};
    } else {
      result += utf8[i];
    }
  }
  return result;
}

std::string from_plane_15(std::string_view utf8) {
  std::string result;
  result.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    if (utf8[i] != '\xF3' || i + 3 >= utf8.size()) {
      result += utf8[i];
      continue;
    }
    const int second = static_cast<unsigned char>(utf8[++i]);
    const int third = static_cast<unsigned char>(utf8[++i]);
    if (second == 0xB0 && third < 0xA0) {
      result += static_cast<char>(0xC0 | (third & 0x1F));
    } else {
      result += {static_cast<char>(0xE0 | (second & 0x0F)), static_cast<char>(third)};
    }
  }
  return result;
}

SourcePosition position(const std::string& file, const toml::source_region& region) {
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

std::string date_text(const toml::node& node) {
  std::ostringstream text;
  if (const auto* date = node.as_date()) text << date->get();
  if (const auto* time = node.as_time()) text << time->get();
  if (const auto* date_time = node.as_date_time()) text << date_time->get();
  return text.str();
}

TomlValue converted(const std::string& file, const toml::node& node) {
  TomlValue result{position(file, node.source()), {}};
  if (const auto* table = node.as_table()) {
    TomlTable entries;
    for (const auto& [key, value] : *table) {
      TomlValue entry = converted(file, value);
      entry.where = position(file, key.source());
      entries.emplace_back(from_plane_15(key.str()), std::move(entry));
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& one, const auto& other) {
      const SourcePosition& a = one.second.where;
      const SourcePosition& b = other.second.where;
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    result.value = std::move(entries);
  } else if (const auto* array = node.as_array()) {
    TomlArray items;
    for (const toml::node& item : *array) items.push_back(converted(file, item));
    result.value = std::move(items);
  } else if (const auto* text = node.as_string()) {
    result.value = from_plane_15(text->get());
  } else if (const auto* integer = node.as_integer()) {
    result.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.value = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    result.value = flag->get();
  } else {
    result.value = TomlDate{date_text(node)};
  }
  return result;
}

std::string_view type_name(const TomlValue& value) {
  constexpr std::string_view kNames[] = {"a date", "true or false", "a whole number", "a number",
                                         "a text", "an array",      "a table"};
  return kNames[value.value.index()];
}

std::optional<double> as_number(const TomlValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.value)) {
    return static_cast<double>(*integer);
  }
  const auto* number = std::get_if<double>(&value.value);
  if (number == nullptr || !std::isfinite(*number)) return std::nullopt;
  return *number;
}

/// The line at which an assertion of toml++ fails: the first that the text cannot end with.
int line_that_fails(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) {
    ends.push_back(end);
  }
  const auto passes = [&](std::size_t end) {
    try {
      static_cast<void>(toml::parse(text.substr(0, end)));
    } catch (const toml::parse_error&) {
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
    return true;
  };
  const auto first = std::partition_point(ends.begin(), ends.end(), passes);
  return static_cast<int>(first - ends.begin()) + 1;
}

}  // namespace

std::optional<TomlValue> parse_toml(const TextFile& file, Diagnostics& diagnostics) {
  const std::string text = in_plane_15(file.text);
  try {
    return converted(file.path, toml::parse(text, std::string_view(file.path)));
  } catch (const toml::parse_error& error) {
    diagnostics.error(position(file.path, error.source()),
                      fmt::format("is not TOML: {}", from_plane_15(error.description())));
  } catch (const std::logic_error&) {
    diagnostics.error({file.path, line_that_fails(text), 0},
                      "is not TOML: a name of a table with other characters than letters, digits, "
                      "_ and - stands outside quotes");
  }
  return std::nullopt;
}

TomlSection::TomlSection(const TomlValue& table, Diagnostics& diagnostics)
    : table_(&table), diagnostics_(&diagnostics) {
  ARMCAL_INVARIANT(std::holds_alternative<TomlTable>(table.value));
}

bool TomlSection::has(std::string_view key) const {
  const auto& entries = std::get<TomlTable>(table_->value);
  return std::any_of(entries.begin(), entries.end(),
                     [&](const auto& entry) { return entry.first == key; });
}

const TomlValue* TomlSection::find(std::string_view key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
  for (const auto& [name, value] : std::get<TomlTable>(table_->value)) {
    if (name == key) return &value;
  }
  return nullptr;
}

void TomlSection::wrong_type(const TomlValue& value, std::string_view key,
                             std::string_view expected) {
  const auto* number = std::get_if<double>(&value.value);
  const bool not_finite = number != nullptr && !std::isfinite(*number);
  diagnostics_->error(value.where, fmt::format("{} must be {}, not {}", key, expected,
                                               not_finite ? "nan or inf" : type_name(value)));
}

std::optional<double> TomlSection::number(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto result = as_number(*value);
  if (!result) wrong_type(*value, key, "a number");
  return result;
}

std::optional<int> TomlSection::integer(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* result = std::get_if<std::int64_t>(&value->value);
  constexpr std::int64_t kLargest = 1000000000;
  if (result == nullptr || *result < -kLargest || *result > kLargest) {
    wrong_type(*value, key, "a whole number");
    return std::nullopt;
  }
  return static_cast<int>(*result);
}

std::optional<bool> TomlSection::boolean(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* result = std::get_if<bool>(&value->value);
  if (result == nullptr) {
    wrong_type(*value, key, "true or false");
    return std::nullopt;
  }
  return *result;
}

std::optional<std::string> TomlSection::text(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* result = std::get_if<std::string>(&value->value);
  if (result == nullptr) {
    wrong_type(*value, key, "a text");
    return std::nullopt;
  }
  return *result;
}

std::optional<std::string> TomlSection::number_or_text(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* text = std::get_if<std::string>(&value->value)) return *text;
  const auto number = as_number(*value);
  if (!number) {
    wrong_type(*value, key, "a number or a text");
    return std::nullopt;
  }
  return shortest_text(*number);
}

std::optional<std::string> TomlSection::spelled(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* text = std::get_if<std::string>(&value->value)) return *text;
  if (const auto* date = std::get_if<TomlDate>(&value->value)) return date->text;
  if (const auto* whole = std::get_if<std::int64_t>(&value->value)) return std::to_string(*whole);
  if (std::holds_alternative<double>(value->value)) {
    diagnostics_->error(value->where, fmt::format("{} is a decimal number without quotes", key),
                        "write it in quotes, so that it stays as it is typed");
  } else {
    wrong_type(*value, key, "a text");
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> TomlSection::numbers(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* items = std::get_if<TomlArray>(&value->value);
  if (items == nullptr) {
    wrong_type(*value, key, "an array of numbers");
    return std::nullopt;
  }
  Eigen::VectorXd result(static_cast<Eigen::Index>(items->size()));
  for (std::size_t i = 0; i < items->size(); ++i) {
    const auto item = as_number((*items)[i]);
    if (!item) {
      wrong_type((*items)[i], fmt::format("entry {} of {}", i + 1, key), "a number");
      return std::nullopt;
    }
    result(static_cast<Eigen::Index>(i)) = *item;
  }
  return result;
}

std::optional<std::vector<std::string>> TomlSection::texts(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* single = std::get_if<std::string>(&value->value)) return std::vector{*single};
  const auto* items = std::get_if<TomlArray>(&value->value);
  if (items == nullptr) {
    wrong_type(*value, key, "an array of texts");
    return std::nullopt;
  }
  std::vector<std::string> result;
  for (const TomlValue& item : *items) {
    const auto* text = std::get_if<std::string>(&item.value);
    if (text == nullptr) {
      wrong_type(item, fmt::format("entry {} of {}", result.size() + 1, key), "a text");
      return std::nullopt;
    }
    result.push_back(*text);
  }
  return result;
}

std::optional<std::vector<Eigen::Vector2d>> TomlSection::pairs(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* rows = std::get_if<TomlArray>(&value->value);
  std::vector<Eigen::Vector2d> result;
  bool good = rows != nullptr;
  for (std::size_t i = 0; good && i < rows->size(); ++i) {
    const auto* pair = std::get_if<TomlArray>(&(*rows)[i].value);
    good = pair != nullptr && pair->size() == 2;
    if (!good) break;
    const auto first = as_number((*pair)[0]);
    const auto second = as_number((*pair)[1]);
    good = first && second;
    if (good) result.emplace_back(*first, *second);
  }
  if (good) return result;
  diagnostics_->error(value->where,
                      fmt::format("{} must be pairs of numbers, as [[0.0, 0.0], [0.0, 0.0]]", key));
  return std::nullopt;
}

std::optional<TomlSection> TomlSection::section(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!std::holds_alternative<TomlTable>(value->value)) {
    wrong_type(*value, key, fmt::format("a table [{}]", key));
    return std::nullopt;
  }
  return TomlSection(*value, *diagnostics_);
}

std::vector<TomlSection> TomlSection::sections(std::string_view key) {
  const TomlValue* value = find(key);
  std::vector<TomlSection> result;
  if (value == nullptr) return result;
  const auto* items = std::get_if<TomlArray>(&value->value);
  const bool tables =
      items != nullptr && std::all_of(items->begin(), items->end(), [](const TomlValue& item) {
        return std::holds_alternative<TomlTable>(item.value);
      });
  if (!tables) {
    wrong_type(*value, key, fmt::format("tables, each headed [[{}]]", key));
    return result;
  }
  for (const TomlValue& item : *items) result.emplace_back(item, *diagnostics_);
  return result;
}

std::optional<double> TomlSection::required_number(std::string_view key) {
  if (!has(key)) diagnostics_->error(where(), fmt::format("{} is missing here", key));
  return number(key);
}

std::optional<std::string> TomlSection::required_text(std::string_view key) {
  if (!has(key)) diagnostics_->error(where(), fmt::format("{} is missing here", key));
  return text(key);
}

std::vector<std::pair<std::string, double>> TomlSection::all_numbers() {
  std::vector<std::pair<std::string, double>> result;
  for (const auto& [key, value] : std::get<TomlTable>(table_->value)) {
    if (const auto number = this->number(key)) result.emplace_back(key, *number);
  }
  return result;
}

std::vector<std::pair<std::string, std::string>> TomlSection::all_texts() {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const auto& [key, value] : std::get<TomlTable>(table_->value)) {
    if (const auto entry = text(key)) entries.emplace_back(key, *entry);
  }
  return entries;
}

SourcePosition TomlSection::where(std::string_view key) const {
  for (const auto& [name, value] : std::get<TomlTable>(table_->value)) {
    if (name == key) return value.where;
  }
  return table_->where;
}

void TomlSection::finish() {
  for (const auto& [key, value] : std::get<TomlTable>(table_->value)) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    diagnostics_->error(value.where, fmt::format("unknown key \"{}\"", key),
                        did_you_mean(key, asked_));
  }
}

std::string toml_quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\u{:04X}", code);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

void check_schema(TomlSection& root, std::string_view kind, Diagnostics& diagnostics) {
  const std::string expected = fmt::format("armcal.{}/1", kind);
  if (!root.has("schema")) {
    diagnostics.error(root.where(), "has no schema",
                      fmt::format("write schema = \"{}\" at its top", expected));
    return;
  }
  const auto schema = root.text("schema");
  // 1.x is read as 1: minor versions only add.
  if (schema && *schema != expected && !schema->starts_with(expected + ".")) {
    diagnostics.error(root.where("schema"),
                      fmt::format("schema \"{}\" is not \"{}\"", *schema, expected),
                      "is it the file you meant?");
  }
}

}  // namespace armcal
