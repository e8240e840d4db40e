// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/core/progress.h"
#include "armcal/io/text_file.h"

namespace armcal {

/// Header names of a file by the names that we know: `--map q1_deg=A1` is {"q1_deg", "A1"}. A file
/// without a header is mapped by column numbers: {"q1_deg", "1"}.
using ColumnMap = std::map<std::string, std::string>;

/// What to do with an entry of the map whose column a file does not have.
enum class UnmatchedMap {
  error,
  skip,  ///< and list it: the map is for several files, of which one has the column
};

/// One column: its name without unit, in lower case, and the unit from the name, from brackets or
/// from a row of units. `q1_deg`, `Q1 [deg]`, and `q1` above a row with `deg` are all name "q1",
/// unit "deg".
struct CsvColumn {
  std::string header;  ///< as in the file; empty without a header row
  std::string name;
  std::string unit;  ///< empty where nothing says
};

/// A table of text fields with everything that real files vary in taken care of: separator ; , tab
/// or blanks, decimal comma, quotes, comments (#), CRLF, blank lines, header or none, a row of
/// units.
class CsvTable {
 public:
  /// Problems of the table as such (no rows, ragged rows, quotes, duplicate or unmapped names) go
  /// to `diagnostics`; with errors nothing is returned.
  [[nodiscard]] static std::optional<CsvTable> parse(TextFile file, const ColumnMap& map,
                                                     Diagnostics& diagnostics,
                                                     const Monitor& monitor = {},
                                                     UnmatchedMap unmatched = UnmatchedMap::error);

  [[nodiscard]] const TextFile& file() const { return file_; }
  [[nodiscard]] const std::vector<CsvColumn>& columns() const { return columns_; }
  [[nodiscard]] bool has_header() const { return has_header_; }
  /// Entries of the map that were skipped, by our names.
  [[nodiscard]] const std::vector<std::string>& unmatched() const { return unmatched_; }
  [[nodiscard]] char separator() const { return separator_; }
  [[nodiscard]] bool decimal_comma() const { return decimal_comma_; }
  [[nodiscard]] std::size_t row_count() const { return lines_.size(); }

  /// The same table with some of its rows, in this order; each keeps its line.
  [[nodiscard]] CsvTable with_rows(std::span<const std::size_t> rows) const;

  /// Index of the column of this name (without unit), or nothing.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// Headers of the file in one line, for messages.
  [[nodiscard]] std::string header_list() const;

  /// "its columns: A1, A2" or "it has no header and 6 columns", for messages.
  [[nodiscard]] std::string columns_in_words() const;
  /// "column q1_deg", or "column 1" where there is no header.
  [[nodiscard]] std::string column_in_words(std::size_t column) const;

  [[nodiscard]] std::string_view field(std::size_t row, std::size_t column) const;
  [[nodiscard]] int line(std::size_t row) const { return static_cast<int>(lines_[row]); }
  /// Line and character column of a field, for messages.
  [[nodiscard]] SourcePosition where(std::size_t row, std::size_t column) const;

  /// All numbers of a column. Fields that are not numbers are reported, named by `quantity` ("joint
  /// 4 angle"), and come out as NaN.
  [[nodiscard]] std::vector<double> numbers(std::size_t column, std::string_view quantity,
                                            Diagnostics& diagnostics) const;

 private:
  struct Field {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  friend class CsvParser;

  TextFile file_;
  std::vector<CsvColumn> columns_;
  std::vector<Field> fields_;         // row by row
  std::vector<std::uint32_t> lines_;  // of each row
  std::vector<std::string> unmatched_;
  char separator_ = ',';
  bool decimal_comma_ = false;
  bool has_header_ = false;
};

}  // namespace armcal
