// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

#include "armcal/core/spelling.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

constexpr std::size_t kSniffedLines = 50;
// Rows between two reports of progress.
constexpr std::size_t kRowsPerReport = 100000;

constexpr std::array<std::string_view, 15> kUnits = {"mm", "m",    "cm",  "um",       "\xC2\xB5m",
                                                     "in", "inch", "deg", "\xC2\xB0", "rad",
                                                     "c",  "k",    "s",   "n",        "arcsec"};

bool is_unit(std::string_view text) {
  return std::find(kUnits.begin(), kUnits.end(), text) != kUnits.end();
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '\r')) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return result;
}

// Name and unit from "q1_deg", "X [mm]", "x (mm)", "x mm", "x".
CsvColumn column_from_header(std::string_view header) {
  CsvColumn column;
  column.header = header;
  std::string name = lower(trimmed(header));
  const std::size_t open = name.find_last_of("[(");
  if (open != std::string::npos && (name.back() == ']' || name.back() == ')')) {
    column.unit = trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2));
    name.erase(open);
  } else if (const std::size_t cut = name.find_last_of("_ "); cut != std::string::npos && cut > 0) {
    const std::string_view tail = std::string_view(name).substr(cut + 1);
    if (is_unit(tail)) {
      column.unit = tail;
      name.erase(cut);
    }
  }
  name = trimmed(name);
  std::replace(name.begin(), name.end(), ' ', '_');
  column.name = name;
  return column;
}

std::string unit_from_cell(std::string_view cell) {
  std::string unit = lower(trimmed(cell));
  if (unit.size() >= 2 && (unit.front() == '[' || unit.front() == '(')) {
    unit = unit.substr(1, unit.size() - 2);
  }
  return unit;
}

// Blank-separated words that are all numbers with a decimal comma: "0,1 0,2 0,3".
bool is_blank_separated_with_commas(std::string_view line) {
  std::size_t words = 0;
  while (!(line = trimmed(line)).empty()) {
    std::size_t end = 0;
    while (end < line.size() && !is_blank(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    if (!parse_number(word, true)) return false;
    ++words;
    line.remove_prefix(end);
  }
  return words > 1;
}

}  // namespace

// Takes a file apart in one pass; the table is its product.
class CsvParser {
 public:
  CsvParser(TextFile file, const ColumnMap& map, Diagnostics& diagnostics, const Monitor& monitor,
            UnmatchedMap unmatched)
      : map_(map), diagnostics_(diagnostics), monitor_(monitor), unmatched_(unmatched) {
    table_.file_ = std::move(file);
    text_ = table_.file_.text;
  }

  std::optional<CsvTable> parse() {
    const std::size_t errors_before = diagnostics_.error_count();
    sniff();
    split_rows();
    if (table_.lines_.empty()) {
      diagnostics_.error({path(), 0, 0}, "has no rows", "is it the file you meant?");
      return std::nullopt;
    }
    name_columns();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    detect_decimal_comma();
    if (table_.lines_.empty()) {
      diagnostics_.error({path(), 0, 0}, "has a header but no rows below it");
      return std::nullopt;
    }
    return std::move(table_);
  }

 private:
  [[nodiscard]] const std::string& path() const { return table_.file_.path; }

  // The separator that the first lines agree on; a semicolon or tab anywhere beats commas and
  // blanks.
  void sniff() {
    std::array<std::size_t, 3> lines_with{};  // ; tab ,
    bool commas_are_decimal = true;
    std::size_t seen = 0;
    for (std::size_t begin = 0; begin < text_.size() && seen < kSniffedLines;) {
      std::size_t end = text_.find_first_of("\n\r", begin);
      if (end == std::string_view::npos) end = text_.size();
      const std::string_view line = trimmed(text_.substr(begin, end - begin));
      begin = end + 1;
      if (line.empty() || line.front() == '#') continue;
      ++seen;
      lines_with[0] += line.find(';') != std::string_view::npos;
      lines_with[1] += line.find('\t') != std::string_view::npos;
      const bool comma = line.find(',') != std::string_view::npos;
      lines_with[2] += comma;
      // The header line may be words; any later line must be numbers for commas to be decimal.
      if (comma && seen > 1 && !is_blank_separated_with_commas(line)) commas_are_decimal = false;
      if (comma && seen == 1 && line.find(' ') == std::string_view::npos)
        commas_are_decimal = false;
    }
    if (lines_with[0] > 0 && lines_with[0] >= seen / 2) {
      table_.separator_ = ';';
    } else if (lines_with[1] > 0 && lines_with[1] >= seen / 2) {
      table_.separator_ = '\t';
    } else if (lines_with[2] > 0 && !commas_are_decimal) {
      table_.separator_ = ',';
    } else {
      table_.separator_ = ' ';
    }
  }

  void split_rows() {
    std::size_t line_number = 0;
    const char* const base = text_.data();
    const char* const end = base + text_.size();
    const char* at = base;
    bool any_newline_left =
        true;  // asked once only: looking to the end for every line would take forever
    while (at < end) {
      ++line_number;
      const auto left = static_cast<std::size_t>(end - at);
      const auto* newline =
          any_newline_left ? static_cast<const char*>(std::memchr(at, '\n', left)) : nullptr;
      any_newline_left = newline != nullptr;
      const char* line_end = newline != nullptr ? newline : end;
      const char* next = newline != nullptr ? newline + 1 : end;
      if (newline == nullptr) {
        // Old Macintosh files end lines with CR alone.
        const auto* cr = static_cast<const char*>(std::memchr(at, '\r', left));
        if (cr != nullptr && cr + 1 < end) {
          line_end = cr;
          next = cr + 1;
        }
      }
      std::string_view line(at, static_cast<std::size_t>(line_end - at));
      while (!line.empty() &&
             (line.back() == '\r' || line.back() == '\x1A' || is_blank_end(line.back()))) {
        line.remove_suffix(1);
      }
      at = next;
      const std::string_view content = trimmed(line);
      if (content.empty() || content.front() == '#') continue;
      split_line(line, static_cast<std::uint32_t>(line_number));
      if (diagnostics_.is_hopeless(path())) return;
      if (table_.lines_.size() % kRowsPerReport == 0) {
        monitor_.report("reading " + path(),
                        static_cast<double>(at - base) / static_cast<double>(text_.size()));
      }
    }
  }

  // Blanks at the end of a line are never fields; tabs are, when they separate.
  [[nodiscard]] bool is_blank_end(char c) const {
    return c == ' ' || (c == '\t' && table_.separator_ != '\t');
  }

  void split_line(std::string_view line, std::uint32_t line_number) {
    const std::size_t first = table_.fields_.size();
    const auto offset = static_cast<std::uint32_t>(line.data() - text_.data());
    const auto size = static_cast<std::uint32_t>(line.size());
    const bool blanks = table_.separator_ == ' ';
    std::uint32_t begin = 0;
    while (begin <= size) {
      while (begin < size && (line[begin] == ' ' || (blanks && line[begin] == '\t'))) ++begin;
      std::uint32_t end = begin;
      if (begin < size && line[begin] == '"') {
        const std::size_t close = line.find('"', begin + 1);
        if (close == std::string_view::npos) {
          diagnostics_.error({path(), static_cast<int>(line_number), static_cast<int>(begin + 1)},
                             "quotation mark is never closed");
          table_.fields_.resize(first);
          return;
        }
        table_.fields_.push_back({offset + begin + 1, offset + static_cast<std::uint32_t>(close)});
        end = static_cast<std::uint32_t>(close) + 1;
        while (end < size && !is_separator(line[end])) ++end;
      } else {
        while (end < size && !is_separator(line[end])) ++end;
        std::uint32_t stop = end;
        while (stop > begin && is_blank(line[stop - 1])) --stop;
        table_.fields_.push_back({offset + begin, offset + stop});
      }
      if (end >= size) break;
      begin = end + 1;
    }
    finish_row(first, line_number);
  }

  [[nodiscard]] bool is_separator(char c) const {
    return c == table_.separator_ || (table_.separator_ == ' ' && c == '\t');
  }

  // Every row has as many fields as the first; one empty field at the end (a trailing separator) is
  // forgiven.
  void finish_row(std::size_t first, std::uint32_t line_number) {
    std::size_t count = table_.fields_.size() - first;
    const auto drop_empty_end = [&] {
      const CsvTable::Field& last = table_.fields_.back();
      if (count < 2 || last.begin != last.end) return;
      table_.fields_.pop_back();
      --count;
    };
    if (width_ == 0) {
      drop_empty_end();
      width_ = count;
    } else if (count == width_ + 1) {
      drop_empty_end();
    }
    if (count != width_) {
      const bool cut_off = table_.fields_.back().end + 2 >= text_.size() && count < width_;
      diagnostics_.error(
          {path(), static_cast<int>(line_number), 0},
          fmt::format("has {} field{}, the first row has {}", count, count == 1 ? "" : "s", width_),
          cut_off ? "is the file cut off at its end?" : "");
      table_.fields_.resize(first);
      return;
    }
    table_.lines_.push_back(line_number);
  }

  [[nodiscard]] std::string_view raw(std::size_t row, std::size_t column) const {
    return table_.field(row, column);
  }

  [[nodiscard]] bool is_number(std::string_view text) const {
    return parse_number(text, false) || parse_number(text, table_.separator_ != ',');
  }

  void drop_first_row() {
    table_.fields_.erase(table_.fields_.begin(),
                         table_.fields_.begin() + static_cast<std::ptrdiff_t>(width_));
    table_.lines_.erase(table_.lines_.begin());
  }

  void name_columns() {
    table_.columns_.resize(width_);
    bool words = false;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::string_view text = raw(0, c);
      if (!text.empty() && !is_number(text) && !spells_missing(text)) words = true;
    }
    table_.has_header_ = words;
    if (words) {
      header_line_ = table_.lines_.front();
      for (std::size_t c = 0; c < width_; ++c) table_.columns_[c] = column_from_header(raw(0, c));
      drop_first_row();
      take_unit_row();
    }
    apply_map();
    check_duplicate_names();
  }

  void take_unit_row() {
    if (table_.lines_.empty()) return;
    bool any = false;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::string unit = unit_from_cell(raw(0, c));
      if (unit.empty() || unit == "-" || unit == "1") continue;
      if (!is_unit(unit)) return;
      any = true;
    }
    if (!any) return;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::string unit = unit_from_cell(raw(0, c));
      CsvColumn& column = table_.columns_[c];
      if (unit.empty() || unit == "-" || unit == "1") continue;
      if (!column.unit.empty() && column.unit != unit) {
        diagnostics_.error(
            table_.where(0, c),
            fmt::format("the row of units says {} but the header says {}", unit, column.header));
      }
      column.unit = unit;
    }
    drop_first_row();
  }

  // The column of this header, or of this number.
  [[nodiscard]] std::optional<std::size_t> column_called(const std::string& theirs) const {
    std::optional<std::size_t> index;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::string& header = table_.columns_[c].header;
      if (!header.empty() && lower(trimmed(header)) == lower(trimmed(theirs))) index = c;
    }
    const auto number = parse_number(theirs);
    if (!index && number && *number >= 1 && *number <= static_cast<double>(width_)) {
      index = static_cast<std::size_t>(*number) - 1;
    }
    return index;
  }

  void apply_map() {
    std::map<std::size_t, std::string> mapped_already;
    for (const auto& [ours, theirs] : map_) {
      const auto index = column_called(theirs);
      if (!index) {
        complain_of_unmatched(ours, theirs);
        continue;
      }
      const auto [first, is_new] = mapped_already.emplace(*index, ours);
      if (!is_new) {
        diagnostics_.error({path(), 0, 0},
                           fmt::format("--map takes {} twice: as {} and as {}",
                                       table_.column_in_words(*index), first->second, ours));
        continue;
      }
      rename(table_.columns_[*index], ours);
    }
  }

  void complain_of_unmatched(const std::string& ours, const std::string& theirs) {
    if (unmatched_ == UnmatchedMap::skip) {
      table_.unmatched_.push_back(ours);
      return;
    }
    std::vector<std::string> headers;
    for (const CsvColumn& column : table_.columns_) headers.push_back(column.header);
    diagnostics_.error(
        {path(), 0, 0}, fmt::format("--map {}={}: no column \"{}\"", ours, theirs, theirs),
        table_.has_header_
            ? did_you_mean(theirs, headers)
            : fmt::format("the file has no header; give a column number from 1 to {}", width_));
  }

  void rename(CsvColumn& column, const std::string& ours) {
    CsvColumn mapped = column_from_header(ours);
    mapped.header = column.header;
    if (mapped.unit.empty()) mapped.unit = column.unit;
    if (!column.unit.empty() && column.unit != mapped.unit) {
      diagnostics_.warning({path(), 0, 0},
                           fmt::format("column {} is read in {} as --map asks, against its name",
                                       column.header, mapped.unit));
    }
    column = mapped;
  }

  void check_duplicate_names() {
    std::map<std::string, std::size_t> seen;
    for (std::size_t c = 0; c < width_; ++c) {
      const std::string& name = table_.columns_[c].name;
      if (name.empty()) continue;
      const auto [first, is_new] = seen.emplace(name, c);
      if (is_new) continue;
      diagnostics_.error({path(), static_cast<int>(header_line_), 0},
                         fmt::format("{} (number {}) and {} (number {}) are both \"{}\"",
                                     table_.column_in_words(first->second), first->second + 1,
                                     table_.column_in_words(c), c + 1, name),
                         "rename or delete one of them");
    }
  }

  // Some field is a number only with a comma for the point.
  void detect_decimal_comma() {
    if (table_.separator_ == ',') return;
    const std::size_t looked_at = std::min<std::size_t>(table_.lines_.size(), kSniffedLines);
    for (std::size_t row = 0; row < looked_at; ++row) {
      for (std::size_t c = 0; c < width_; ++c) {
        const std::string_view text = raw(row, c);
        if (text.find(',') != std::string_view::npos && !parse_number(text, false) &&
            parse_number(text, true)) {
          table_.decimal_comma_ = true;
          return;
        }
      }
    }
  }

  CsvTable table_;
  std::string_view text_;
  const ColumnMap& map_;
  Diagnostics& diagnostics_;
  const Monitor& monitor_;
  UnmatchedMap unmatched_;
  std::size_t width_ = 0;
  std::uint32_t header_line_ = 0;
};

std::optional<CsvTable> CsvTable::parse(TextFile file, const ColumnMap& map,
                                        Diagnostics& diagnostics, const Monitor& monitor,
                                        UnmatchedMap unmatched) {
  return CsvParser(std::move(file), map, diagnostics, monitor, unmatched).parse();
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (columns_[c].name == name) return c;
  }
  return std::nullopt;
}

CsvTable CsvTable::with_rows(std::span<const std::size_t> rows) const {
  CsvTable part = *this;
  part.fields_.clear();
  part.lines_.clear();
  for (const std::size_t row : rows) {
    const auto first = fields_.begin() + static_cast<std::ptrdiff_t>(row * columns_.size());
    part.fields_.insert(part.fields_.end(), first,
                        first + static_cast<std::ptrdiff_t>(columns_.size()));
    part.lines_.push_back(lines_[row]);
  }
  return part;
}

std::string CsvTable::header_list() const {
  std::string list;
  for (const CsvColumn& column : columns_) list += (list.empty() ? "" : ", ") + column.header;
  return list;
}

std::string CsvTable::columns_in_words() const {
  return has_header_ ? fmt::format("its columns: {}", header_list())
                     : fmt::format("it has no header and {} columns", columns_.size());
}

std::string CsvTable::column_in_words(std::size_t column) const {
  const std::string& header = columns_[column].header;
  return header.empty() ? fmt::format("column {}", column + 1) : fmt::format("column {}", header);
}

std::string_view CsvTable::field(std::size_t row, std::size_t column) const {
  const Field& f = fields_[row * columns_.size() + column];
  return std::string_view(file_.text).substr(f.begin, f.end - f.begin);
}

SourcePosition CsvTable::where(std::size_t row, std::size_t column) const {
  const Field& f = fields_[row * columns_.size() + column];
  const std::size_t newline =
      f.begin == 0 ? std::string::npos : file_.text.rfind('\n', f.begin - 1);
  const std::size_t line_begin = newline == std::string::npos ? 0 : newline + 1;
  return {file_.path, line(row), static_cast<int>(f.begin - line_begin) + 1};
}

std::vector<double> CsvTable::numbers(std::size_t column, std::string_view quantity,
                                      Diagnostics& diagnostics) const {
  std::vector<double> values(row_count(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < row_count(); ++row) {
    const std::string_view text = field(row, column);
    if (const auto value = parse_number(text, decimal_comma_)) {
      values[row] = *value;
      continue;
    }
    if (text.empty() || spells_missing(text)) {
      diagnostics.error(where(row, column),
                        fmt::format("{} is missing{}", quantity,
                                    text.empty() ? "" : fmt::format(" (\"{}\")", text)),
                        "delete the row, or write the value that was read");
    } else {
      constexpr std::size_t kQuoted = 40;
      diagnostics.error(where(row, column),
                        fmt::format("{} \"{}{}\" is not a number", quantity,
                                    text.substr(0, kQuoted), text.size() > kQuoted ? ".." : ""));
    }
    if (diagnostics.is_hopeless(file_.path)) break;
  }
  return values;
}

}  // namespace armcal
