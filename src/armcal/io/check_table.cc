// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/check_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace armcal {
namespace {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n;\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

std::string csv_text(std::span<const CheckRecord> checks) {
  std::vector<std::string> names;
  for (const CheckRecord& check : checks) {
    for (const CheckedValue& each : check.values) {
      if (std::find(names.begin(), names.end(), each.name) == names.end())
        names.push_back(each.name);
    }
  }
  std::string text = "check,time_utc,arm,artefact,kind,points,temperature_c,verdict";
  for (const std::string& name : names) text += fmt::format(",{0}_mm,{0}_limit_mm", name);
  text += ",note,tool_version,arm_sha256,readings_sha256\n";
  for (const CheckRecord& check : checks) {
    text += fmt::format("{},{},{},{},{},{},{},{}", check.id, utc_text(check.time),
                        csv_field(check.arm), csv_field(check.artefact), csv_field(check.kind),
                        check.point_count, csv_number(check.temperature_c), check.verdict);
    for (const std::string& name : names) {
      const auto value = std::find_if(check.values.begin(), check.values.end(),
                                      [&](const CheckedValue& each) { return each.name == name; });
      const bool has = value != check.values.end();
      text += fmt::format(",{},{}", has ? csv_number(value->value_mm) : "",
                          has ? csv_number(value->limit_mm) : "");
    }
    text += fmt::format(",{},{},{},{}\n", csv_field(check.note), check.tool_version,
                        check.arm_sha256, check.readings_sha256);
  }
  return text;
}

}  // namespace armcal
