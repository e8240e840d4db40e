// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace armcal {

/// How a thing stands. Shown by a sign and a word, and by colour beside them.
enum class Tone { neutral, good, bad, warning };

/// Its class in report.css: "good".
[[nodiscard]] const char* tone_class(Tone tone);
/// Its sign, which needs no colour; empty for neutral.
[[nodiscard]] const char* tone_sign(Tone tone);

/// A figure that is read first.
struct Headline {
  std::string label;
  std::string value;  ///< "0.0312"
  std::string unit;   ///< "mm"
  std::string note;   ///< what it is held against, a few words
  Tone tone = Tone::neutral;
};
struct Headlines {
  std::vector<Headline> items;
};

struct Paragraph {
  std::string text;
};

/// What has to be said: findings, warnings, what data cannot see.
struct Notice {
  Tone tone = Tone::neutral;
  std::string title;
  std::vector<std::string> lines;
};

/// Names and values, one below the other; a pair without value is left out.
struct Facts {
  std::vector<std::pair<std::string, std::string>> rows;
};

struct Cell {
  std::string text;
  Tone tone = Tone::neutral;
};
/// What stands in a column: numbers are aligned right, in digits of one width; words (units, dates,
/// limits) stay on one line; prose gets room.
enum class ColumnKind { number, word, text, prose };

/// Its class in report.css: "num".
[[nodiscard]] const char* column_class(ColumnKind kind);

struct TableColumn {
  std::string title;
  ColumnKind kind = ColumnKind::number;
};
struct Table {
  std::string caption;
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;
  std::string note;  ///< below it
  /// Rows that are seen at first on a screen, 0: all; on paper all are.
  std::size_t shown = 0;
};

/// A picture: an SVG drawing that needs no script, and, where there is one, what a script makes of
/// it (zoom, hover, turning in space).
struct Figure {
  std::string id;     ///< unique on the page, of a-z 0-9 -
  std::string title;  ///< above it
  std::string
      text;  ///< what it shows, in a sentence or two: below it, and for those who cannot see it
  std::string svg;   ///< whole element; everything from outside in it is escaped already
  std::string live;  ///< JSON for the script (docs/theory/report.md); empty: nothing to play with
  bool is_wide = false;  ///< takes a row of its own
};
/// Figures beside each other where there is room.
struct Figures {
  std::vector<Figure> items;
};

/// Text as it was typed or printed.
struct Verbatim {
  std::string text;
};

/// Who answers for the report; on paper with a line to sign on.
struct Signature {
  std::string label;  ///< "Released by"
  std::string name;
  std::string role;
};

using Block =
    std::variant<Headlines, Paragraph, Notice, Facts, Table, Figures, Verbatim, Signature>;

struct Section {
  std::string id;  ///< unique on the page, of a-z 0-9 -
  std::string title;
  std::string lead;  ///< a sentence or two that says what follows; may be empty
  std::vector<Block> blocks;
};

/// What a result is in one word, where it is one.
struct Stamp {
  std::string word;
  std::string sentence;
  Tone tone = Tone::neutral;
};

/// A report, ready to be laid out: everything in the language of the reader, every number a text
/// already. Texts are plain; laying out escapes them.
struct Page {
  std::string title;
  std::string subtitle;  ///< of what
  std::string number;    ///< unique; on every page of paper
  Stamp stamp;           ///< no word: none is shown
  Facts head;            ///< customer, item, dates: beside the title
  std::vector<Section> sections;
};

}  // namespace armcal
