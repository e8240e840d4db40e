// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace armcal {

enum class Align { left, right };

/// A table of text with aligned columns, for terminals and mails. Columns are wide enough for their
/// widest cell; Chinese and other wide characters count double.
class TextTable {
 public:
  struct Column {
    std::string title;
    Align align = Align::right;
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
  void add_row(std::vector<std::string> cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// Title row and all rows, each indented and ended by a newline.
  [[nodiscard]] std::string text(std::size_t indent = 2) const;
  /// The same as a table of a Markdown page.
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Columns that a text takes on a terminal.
[[nodiscard]] std::size_t display_width(std::string_view utf8);

}  // namespace armcal
