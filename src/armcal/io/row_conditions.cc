// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/row_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/utc_time.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

constexpr const char* kHowToWriteTimes =
    "write dates as 2026-03-02T09:15:30Z (UTC where no zone is given), or seconds as a number";
constexpr std::size_t kQuoted = 40;

struct Instant {
  double time_s = 0.0;
  bool is_utc = false;
};

std::optional<Instant> instant_of(std::string_view text, bool decimal_comma) {
  if (const auto seconds = parse_number(text, decimal_comma)) return Instant{*seconds, false};
  const auto time = parse_fractional_utc_time(text);
  if (!time) return std::nullopt;
  return Instant{*time, true};
}

// Reads one optional column; fields that say nothing stay NaN.
class ConditionReader {
 public:
  ConditionReader(const CsvTable& table, Diagnostics& diagnostics)
      : table_(table), diagnostics_(diagnostics) {}

  // The column of this name, if its unit is one of these. An empty unit always is.
  std::optional<std::size_t> column(std::string_view name, const std::vector<std::string>& units,
                                    const char* remedy) {
    const auto at = table_.find(name);
    if (!at) return std::nullopt;
    const std::string& unit = table_.columns()[*at].unit;
    if (unit.empty() || std::find(units.begin(), units.end(), unit) != units.end()) return at;
    diagnostics_.error({table_.file().path, 0, 0},
                       fmt::format("the {} is in \"{}\"", name, unit.substr(0, kQuoted)), remedy);
    return std::nullopt;
  }

  template <typename ReadField>
  Eigen::VectorXd values(std::size_t column, ReadField read_field) {
    const std::size_t rows = table_.row_count();
    Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(rows),
                                                       std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < rows; ++row) {
      const std::string_view text = table_.field(row, column);
      if (text.empty() || spells_missing(text)) continue;
      if (const auto value = read_field(text, table_.where(row, column))) {
        result(static_cast<Eigen::Index>(row)) = *value;
      }
      if (diagnostics_.is_hopeless(table_.file().path)) break;
    }
    return result;
  }

 private:
  const CsvTable& table_;
  Diagnostics& diagnostics_;
};

void read_times(const CsvTable& table, ObservationGroup& group, Diagnostics& diagnostics) {
  ConditionReader reader(table, diagnostics);
  const auto column = reader.column("time", {"s", "utc"}, kHowToWriteTimes);
  if (!column) return;
  std::optional<bool> is_utc;
  group.time_s = reader.values(
      *column, [&](std::string_view text, const SourcePosition& where) -> std::optional<double> {
        const auto instant = instant_of(text, table.decimal_comma());
        if (!instant) {
          diagnostics.error(where, fmt::format("\"{}\" is no time", text.substr(0, kQuoted)),
                            kHowToWriteTimes);
          return std::nullopt;
        }
        if (is_utc.value_or(instant->is_utc) != instant->is_utc) {
          diagnostics.error(where, "dates and plain seconds stand in one column time",
                            "write all times of a table in one way");
          return std::nullopt;
        }
        is_utc = instant->is_utc;
        return instant->time_s;
      });
  group.time_is_utc = is_utc.value_or(false);
}

void read_temperatures(const CsvTable& table, ObservationGroup& group, Diagnostics& diagnostics) {
  // Beyond any laboratory or shop floor: kelvins and degrees Fahrenheit are found out.
  constexpr double kColdest_c = -50.0;
  constexpr double kHottest_c = 60.0;
  const char* const remedy = "call the column temperature_c and give degrees Celsius";
  ConditionReader reader(table, diagnostics);
  const auto column = reader.column("temperature",
                                    {"c", "degc",
                                     "\xC2\xB0"
                                     "c"},
                                    remedy);
  if (!column) return;
  group.temperature_c = reader.values(
      *column, [&](std::string_view text, const SourcePosition& where) -> std::optional<double> {
        const auto value = parse_number(text, table.decimal_comma());
        if (value && *value >= kColdest_c && *value <= kHottest_c) return value;
        diagnostics.error(
            where,
            value ? fmt::format("a temperature of {} deg C cannot be", *value)
                  : fmt::format("temperature \"{}\" is not a number", text.substr(0, kQuoted)),
            value ? remedy : "");
        return std::nullopt;
      });
}

}  // namespace

void read_conditions(const CsvTable& table, ObservationGroup& group, Diagnostics& diagnostics) {
  read_times(table, group, diagnostics);
  read_temperatures(table, group, diagnostics);
}

}  // namespace armcal
