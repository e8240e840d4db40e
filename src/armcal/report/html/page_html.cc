// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/page_html.h"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "armcal/core/version.h"
#include "armcal/io/sha256.h"
#include "armcal/report/document.h"
#include "armcal/report/html/assets.h"

namespace armcal {
namespace {

using Data = kainjow::mustache::data;

constexpr std::string_view kDocumentBegin =
    "<script type=\"application/json\" id=\"armcal-result\">";
constexpr std::string_view kDocumentEnd = "</script>";

// Every key is always there: a name that a template does not find here it would look for further
// out.
Data text_or_false(const std::string& text) {
  return text.empty() ? Data(kainjow::mustache::data::type::bool_false) : Data(text);
}

Data boolean(bool value) {
  using Type = kainjow::mustache::data::type;
  return Data(value ? Type::bool_true : Type::bool_false);
}

const char* class_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::bad:
      return "bad";
    case Tone::warning:
      return "warning";
    case Tone::neutral:
      break;
  }
  return "neutral";
}

const char* sign_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "\u2713";
    case Tone::bad:
      return "\u2717";
    case Tone::warning:
      return "\u26a0\ufe0e";
    case Tone::neutral:
      break;
  }
  return "";
}

void set_tone(Data& data, Tone tone) {
  data.set("tone", class_of(tone));
  data.set("sign", text_or_false(sign_of(tone)));
}

Data list_of(const std::vector<std::string>& texts) {
  Data list(Data::type::list);
  for (const std::string& text : texts) list.push_back(Data(text));
  return list;
}

Data data_of(const Facts& facts) {
  Data rows(Data::type::list);
  for (const auto& [name, value] : facts.rows) {
    if (value.empty()) continue;
    Data row;
    row.set("name", name);
    row.set("value", value);
    rows.push_back(row);
  }
  return rows;
}

// JSON inside a script element: nothing in it may end the element or start a comment.
std::string script_safe(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

// What script_safe() wrote instead of a character; 0: something else.
char character_of(std::string_view escape) {
  return escape == "\\u003c" ? '<' : escape == "\\u003e" ? '>' : escape == "\\u0026" ? '&' : '\0';
}

// One block as data: the key of its kind, and its own keys under it.
struct BlockData {
  Data operator()(const Headlines& headlines) const {
    Data list(Data::type::list);
    for (const Headline& each : headlines.items) {
      Data item;
      item.set("label", each.label);
      item.set("value", each.value);
      item.set("unit", text_or_false(each.unit));
      item.set("note", text_or_false(each.note));
      set_tone(item, each.tone);
      list.push_back(item);
    }
    Data inner;
    inner.set("items", list);
    return kind("headlines", inner);
  }
  Data operator()(const Paragraph& paragraph) const {
    Data inner;
    inner.set("text", paragraph.text);
    return kind("paragraph", inner);
  }
  Data operator()(const Notice& notice) const {
    Data inner;
    inner.set("title", text_or_false(notice.title));
    inner.set("lines", list_of(notice.lines));
    set_tone(inner, notice.tone);
    return kind("notice", inner);
  }
  Data operator()(const Facts& facts) const {
    Data inner;
    inner.set("rows", data_of(facts));
    return kind("facts", inner);
  }
  Data operator()(const Verbatim& verbatim) const {
    Data inner;
    inner.set("text", verbatim.text);
    return kind("verbatim", inner);
  }
  Data operator()(const Table& table) const {
    Data columns(Data::type::list);
    for (const TableColumn& each : table.columns) {
      Data column;
      column.set("title", each.title);
      column.set("is_number", boolean(each.is_number));
      columns.push_back(column);
    }
    Data rows(Data::type::list);
    for (std::size_t r = 0; r < table.rows.size(); ++r) rows.push_back(row_data(table, r));
    Data inner;
    inner.set("caption", text_or_false(table.caption));
    inner.set("note", text_or_false(table.note));
    inner.set("columns", columns);
    inner.set("rows", rows);
    const bool folds = table.shown > 0 && table.rows.size() > table.shown;
    inner.set("folds", boolean(folds));
    inner.set("count", std::to_string(table.rows.size()));
    return kind("table", inner);
  }
  Data operator()(const Figures& figures) const {
    Data list(Data::type::list);
    for (const Figure& each : figures.items) {
      Data item;
      item.set("id", each.id);
      item.set("title", each.title);
      item.set("text", text_or_false(each.text));
      item.set("svg", each.svg);
      item.set("live", text_or_false(script_safe(each.live)));
      item.set("is_wide", boolean(each.is_wide));
      list.push_back(item);
    }
    Data inner;
    inner.set("items", list);
    return kind("figures", inner);
  }

 private:
  static Data kind(const char* name, const Data& inner) {
    Data block;
    for (const char* other :
         {"headlines", "paragraph", "notice", "facts", "table", "figures", "verbatim"}) {
      block.set(other, boolean(false));
    }
    block.set(name, inner);
    return block;
  }
  static Data row_data(const Table& table, std::size_t r) {
    Data cells(Data::type::list);
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const Cell& each = table.rows[r][c];
      Data cell;
      cell.set("text", each.text);
      cell.set("is_number", boolean(c < table.columns.size() && table.columns[c].is_number));
      cell.set("is_first", boolean(c == 0));
      set_tone(cell, each.tone);
      cells.push_back(cell);
    }
    Data row;
    row.set("cells", cells);
    row.set("is_folded", boolean(table.shown > 0 && r >= table.shown));
    return row;
  }
};

Data data_of(const std::vector<Section>& sections) {
  Data list(Data::type::list);
  for (const Section& each : sections) {
    Data blocks(Data::type::list);
    for (const Block& block : each.blocks) blocks.push_back(std::visit(BlockData{}, block));
    Data section;
    section.set("id", each.id);
    section.set("title", each.title);
    section.set("lead", text_or_false(each.lead));
    section.set("blocks", blocks);
    list.push_back(section);
  }
  return list;
}

// Texts of the language that stand in the template ("page.contents" as {{say_contents}}), and those
// that scripts need, as JSON.
void set_words(Data& data, const Language& language) {
  Json for_script;
  for (const std::string& key : language.keys()) {
    if (key.rfind("page.", 0) == 0) data.set("say_" + key.substr(5), language(key));
    if (key.rfind("script.", 0) == 0) for_script[key.substr(7)] = language(key);
  }
  data.set("words_for_script", script_safe(for_script.dump()));
}

std::string policy_for(const std::string& script) {
  std::string policy =
      "default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:";
  if (!script.empty()) policy += "; script-src 'sha256-" + sha256_base64(script) + "'";
  return policy;
}

}  // namespace

bool reports_have_scripts() { return !report_asset("report.js").empty(); }

std::string html_of(const Page& page, const Language& language, const std::string& document) {
  const std::string script(report_asset("report.js"));
  Data data;
  data.set("language", language.code());
  data.set("title", page.title);
  data.set("subtitle", text_or_false(page.subtitle));
  data.set("number", text_or_false(page.number));
  data.set("head", data_of(page.head));
  Data stamp(Data::type::bool_false);
  if (!page.stamp.word.empty()) {
    stamp = Data();
    stamp.set("word", page.stamp.word);
    stamp.set("sentence", text_or_false(page.stamp.sentence));
    set_tone(stamp, page.stamp.tone);
  }
  data.set("stamp", stamp);
  data.set("sections", data_of(page.sections));
  data.set("style", std::string(report_asset("report.css")));
  data.set("script", text_or_false(script));
  data.set("policy", policy_for(script));
  data.set("version", std::string(kVersion));
  set_words(data, language);
  // Put in last and by hand: the document may be large, and is no text of the template.
  kainjow::mustache::mustache layout{std::string(report_asset("page.mustache"))};
  std::string html = layout.render(data);
  const std::string slot = std::string(kDocumentBegin);
  const std::size_t at = html.find(slot);
  if (at == std::string::npos) throw std::logic_error("page.mustache has no place for the result");
  html.insert(at + slot.size(), script_safe(document));
  return html;
}

std::optional<std::string> document_in_html(std::string_view html) {
  const std::size_t begin = html.rfind(kDocumentBegin);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t from = begin + kDocumentBegin.size();
  const std::size_t end = html.find(kDocumentEnd, from);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view safe = html.substr(from, end - from);
  std::string document;
  document.reserve(safe.size());
  for (std::size_t i = 0; i < safe.size(); ++i) {
    if (safe[i] != '\\') {
      document += safe[i];
    } else if (const char c = character_of(safe.substr(i, 6)); c != '\0') {
      document += c;
      i += 5;
    } else {  // an escape of the document itself: two characters that belong together
      document += safe.substr(i, 2);
      ++i;
    }
  }
  return document;
}

}  // namespace armcal
