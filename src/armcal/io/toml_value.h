// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"

namespace armcal {

struct TomlValue;
/// A date, a time or both, as TOML spells it.
struct TomlDate {
  std::string text;
};
using TomlArray = std::vector<TomlValue>;
using TomlTable = std::vector<std::pair<std::string, TomlValue>>;  // in the order of the file

/// A value of a TOML file and where it stands.
struct TomlValue {
  SourcePosition where;
  std::variant<TomlDate, bool, std::int64_t, double, std::string, TomlArray, TomlTable> value;
};

/// Parses a TOML 1.0 document; the root is a table. What is not TOML goes to `diagnostics`.
[[nodiscard]] std::optional<TomlValue> parse_toml(const TextFile& file, Diagnostics& diagnostics);

/// One table while it is read: values by key and type, complaints with line and column, and at the
/// end a complaint about every key that nobody asked for.
class TomlSection {
 public:
  /// @param table  must hold a table and outlive the section
  TomlSection(const TomlValue& table, Diagnostics& diagnostics);

  [[nodiscard]] bool has(std::string_view key) const;
  /// Each tells a wrong type as an error and a missing key by returning nothing.
  std::optional<double> number(std::string_view key);
  std::optional<int> integer(std::string_view key);
  std::optional<bool> boolean(std::string_view key);
  std::optional<std::string> text(std::string_view key);
  /// A text, or a number as the text that spells it: for formulas.
  std::optional<std::string> number_or_text(std::string_view key);
  /// A text, or a whole number or date as its text: for what is printed as it was typed. A decimal
  /// number is an error: 1.10 would come back as 1.1.
  std::optional<std::string> spelled(std::string_view key);
  std::optional<Eigen::VectorXd> numbers(std::string_view key);
  std::optional<std::vector<std::string>> texts(std::string_view key);
  /// Rows of pairs, as [[1.0, 2.0], [3.0, 4.0]].
  std::optional<std::vector<Eigen::Vector2d>> pairs(std::string_view key);
  std::optional<TomlSection> section(std::string_view key);
  std::vector<TomlSection> sections(std::string_view key);

  /// Same, but missing is an error too.
  std::optional<double> required_number(std::string_view key);
  std::optional<std::string> required_text(std::string_view key);

  /// Every key with a number: for tables whose keys are names (claims).
  std::vector<std::pair<std::string, double>> all_numbers();

  /// The same for texts: tables whose keys are column names.
  std::vector<std::pair<std::string, std::string>> all_texts();

  /// Place of a key, or of the table where the key is missing.
  [[nodiscard]] SourcePosition where(std::string_view key) const;
  [[nodiscard]] SourcePosition where() const { return table_->where; }

  /// Complains about keys that were never asked for. Call it last.
  void finish();

 private:
  [[nodiscard]] const TomlValue* find(std::string_view key);
  void wrong_type(const TomlValue& value, std::string_view key, std::string_view expected);

  const TomlValue* table_;
  Diagnostics* diagnostics_;
  std::vector<std::string> asked_;
};

/// A basic string of TOML, with quotes and escapes.
[[nodiscard]] std::string toml_quoted(std::string_view text);

/// Checks the key `schema` of a document against "armcal.<kind>/1": the same major version is read.
void check_schema(TomlSection& root, std::string_view kind, Diagnostics& diagnostics);

}  // namespace armcal
