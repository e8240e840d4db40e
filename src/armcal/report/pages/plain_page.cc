// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/plain_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "armcal/report/number_format.h"

namespace armcal {
namespace {

constexpr std::size_t kShownRows = 20;
constexpr std::size_t kMostRows = 2000;

// Keys that stand at the end of every report.
const std::set<std::string> kElsewhere = {"schema", "tool_version", "command", "command_line",
                                          "inputs", "seed",         "warnings"};

bool is_number_or_null(const Json& value) { return value.is_number() || value.is_null(); }

bool is_scalar(const Json& value) { return !value.is_array() && !value.is_object(); }

std::string scalar_text(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.9g}", value.get<double>());
  return value.dump();
}

// A list of scalars in one line; what is nested deeper as JSON.
std::string short_text(const Json& value) {
  if (is_scalar(value)) return scalar_text(value);
  if (value.is_array() && std::all_of(value.begin(), value.end(), is_scalar)) {
    std::string text;
    for (std::size_t i = 0; i < value.size(); ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : ", ", scalar_text(value[i]));
    }
    return text;
  }
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_multiline(const Json& value) {
  return value.is_string() && value.get_ref<const std::string&>().find('\n') != std::string::npos;
}

// Rows of one object: a value beside its uncertainty is rounded to match it.
std::string cell_text(const Json& row, const std::string& key) {
  const auto found = row.find(key);
  if (found == row.end()) return "";
  const auto u = row.find("u");
  const bool has_u = u != row.end() && u->is_number() && u->get<double>() > 0.0;
  const bool rounded =
      has_u && found->is_number_float() && (key == "value" || key == "nominal" || key == "u");
  return rounded ? fixed(found->get<double>(), decimals_for_uncertainty(u->get<double>()))
                 : short_text(*found);
}

bool is_list_of_objects(const Json& value) {
  return value.is_array() && !value.empty() &&
         std::all_of(value.begin(), value.end(), [](const Json& each) { return each.is_object(); });
}

bool is_matrix(const Json& value) {
  return value.is_array() && !value.empty() &&
         std::all_of(value.begin(), value.end(), [&](const Json& row) {
           return row.is_array() && row.size() == value.front().size() &&
                  std::all_of(row.begin(), row.end(), is_scalar);
         });
}

void keep_to_limit(Table& table, std::size_t all, const Language& say) {
  table.shown = all > kShownRows ? kShownRows : 0;
  if (all > kMostRows) table.note = say("plain.rows_left_out", kMostRows, all);
}

Table table_of_objects(const Json& list, const Language& say) {
  std::vector<std::string> keys;
  for (const Json& row : list) {
    for (const auto& [key, value] : row.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }
  Table table;
  for (const std::string& key : keys) {
    const bool is_number = std::all_of(list.begin(), list.end(), [&](const Json& row) {
      const auto found = row.find(key);
      return found == row.end() || found->is_number() || found->is_null();
    });
    table.columns.push_back({key, is_number ? ColumnKind::number : ColumnKind::text});
  }
  for (std::size_t r = 0; r < std::min(list.size(), kMostRows); ++r) {
    std::vector<Cell> cells;
    for (const std::string& key : keys) cells.push_back({cell_text(list[r], key)});
    table.rows.push_back(std::move(cells));
  }
  keep_to_limit(table, list.size(), say);
  return table;
}

Table table_of_matrix(const Json& matrix, const Language& say) {
  Table table;
  for (std::size_t c = 0; c < matrix.front().size(); ++c) {
    table.columns.push_back({fmt::format("{}", c + 1)});
  }
  for (std::size_t r = 0; r < std::min(matrix.size(), kMostRows); ++r) {
    std::vector<Cell> cells;
    for (const Json& value : matrix[r]) {
      cells.push_back(
          {value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : scalar_text(value)});
    }
    table.rows.push_back(std::move(cells));
  }
  keep_to_limit(table, matrix.size(), say);
  return table;
}

// Numbered from 1.
Table table_of_list(const Json& list, const Language& say) {
  Table table;
  const bool is_number = std::all_of(list.begin(), list.end(), is_number_or_null);
  table.columns = {{"#"}, {"", is_number ? ColumnKind::number : ColumnKind::text}};
  for (std::size_t r = 0; r < std::min(list.size(), kMostRows); ++r) {
    table.rows.push_back({{fmt::format("{}", r + 1)}, {short_text(list[r])}});
  }
  keep_to_limit(table, list.size(), say);
  return table;
}

Block block_of(const Json& value, const Language& say) {
  if (is_list_of_objects(value)) return table_of_objects(value, say);
  if (is_matrix(value)) return table_of_matrix(value, say);
  if (value.is_string()) return Verbatim{value.get<std::string>()};
  if (value.is_object()) {
    Facts facts;
    for (const auto& [key, each] : value.items()) facts.rows.emplace_back(key, short_text(each));
    return facts;
  }
  return table_of_list(value, say);
}

}  // namespace

Page plain_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("plain.title", document.text("command"));
  Facts values;
  std::vector<Section> sections;
  for (const auto& [key, value] : document.json().items()) {
    if (kElsewhere.contains(key)) continue;
    const bool is_short = (is_scalar(value) && !is_multiline(value)) ||
                          (value.is_array() && value.size() <= 6 &&
                           std::all_of(value.begin(), value.end(), is_scalar));
    if (is_short) {
      values.rows.emplace_back(key, short_text(value));
    } else if (!value.empty()) {
      sections.push_back(
          {fmt::format("key-{}", sections.size() + 1), key, "", {block_of(value, say)}});
    }
  }
  page.sections.push_back({"result", say("plain.result"), "", {values}});
  for (Section& section : sections) page.sections.push_back(std::move(section));
  return page;
}

}  // namespace armcal
