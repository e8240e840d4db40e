// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/page_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "armcal/core/version.h"
#include "armcal/io/sha256.h"
#include "armcal/report/document.h"
#include "armcal/report/html/assets.h"
#include "armcal/report/html/paper_style.h"
#include "armcal/report/html/script_json.h"
#include "armcal/report/html/visible_text.h"

namespace armcal {
namespace {

using Data = kainjow::mustache::data;

// Up to the attributes that may follow.
constexpr std::string_view kDocumentBegin =
    "<script type=\"application/json\" id=\"armcal-result\"";
constexpr std::string_view kDetailsBegin =
    "<script type=\"application/json\" id=\"armcal-details\"";
constexpr std::string_view kEmbeddedEnd = "</script>";
constexpr std::string_view kSha256Begin = " data-sha256=\"";
constexpr std::string_view kLanguageBegin = "<html lang=\"";

Data text_data(const std::string& text) { return Data(visible_text(text)); }

// Every key is always there: a name that a template does not find here it would look for further
// out.
Data text_or_false(const std::string& text) {
  return text.empty() ? Data(Data::type::bool_false) : text_data(text);
}

Data boolean(bool value) { return Data(value ? Data::type::bool_true : Data::type::bool_false); }

void set_tone(Data& data, Tone tone, const Language& language) {
  data.set("tone", tone_class(tone));
  data.set("sign", text_or_false(tone_sign(tone)));
  const bool has_word = tone != Tone::neutral;
  data.set("tone_word", has_word ? language(fmt::format("tone.{}", tone_class(tone))) : "");
}

Data list_of(const std::vector<std::string>& texts) {
  Data list(Data::type::list);
  for (const std::string& text : texts) list.push_back(text_data(text));
  return list;
}

// Too long for a page of paper to hold it whole: it may break there.
bool is_long(const std::string& text) {
  constexpr std::size_t kLettersOfLine = 100;
  constexpr std::size_t kMostLines = 40;
  std::size_t lines = 1;
  std::size_t letters = 0;
  for (const char c : text) {
    const bool is_full = c == '\n' || ++letters == kLettersOfLine;
    if (!is_full) continue;
    ++lines;
    letters = 0;
  }
  return lines > kMostLines;
}

Data data_of(const Facts& facts) {
  Data rows(Data::type::list);
  for (const auto& [name, value] : facts.rows) {
    if (value.empty()) continue;
    Data row;
    row.set("name", text_data(name));
    row.set("value", text_data(value));
    rows.push_back(row);
  }
  return rows;
}

// One block as data: the key of its kind, and its own keys under it.
struct BlockData {
  const Language& language;
  const Section& section;
  int& tables;  // on the page so far

  Data operator()(const Headlines& headlines) const {
    Data list(Data::type::list);
    for (const Headline& each : headlines.items) {
      Data item;
      item.set("label", text_data(each.label));
      item.set("value", text_data(each.value));
      item.set("unit", text_or_false(each.unit));
      item.set("note", text_or_false(each.note));
      set_tone(item, each.tone, language);
      list.push_back(item);
    }
    Data inner;
    inner.set("items", list);
    return kind("headlines", inner);
  }
  Data operator()(const Paragraph& paragraph) const {
    Data inner;
    inner.set("text", text_data(paragraph.text));
    return kind("paragraph", inner);
  }
  Data operator()(const Notice& notice) const {
    Data inner;
    inner.set("title", text_or_false(notice.title));
    inner.set("lines", list_of(notice.lines));
    inner.set("is_list", boolean(notice.lines.size() > 1));
    set_tone(inner, notice.tone, language);
    return kind("notice", inner);
  }
  Data operator()(const Facts& facts) const {
    Data inner;
    inner.set("rows", data_of(facts));
    return kind("facts", inner);
  }
  Data operator()(const Verbatim& verbatim) const {
    Data inner;
    inner.set("text", text_data(verbatim.text));
    inner.set("is_long", boolean(is_long(verbatim.text)));
    return kind("verbatim", inner);
  }
  Data operator()(const Signature& signature) const {
    Data inner;
    inner.set("label", text_data(signature.label));
    inner.set("name", text_data(signature.name));
    inner.set("role", text_or_false(signature.role));
    return kind("signature", inner);
  }
  Data operator()(const Table& table) const {
    ++tables;
    Data columns(Data::type::list);
    for (const TableColumn& each : table.columns) {
      Data column;
      column.set("title", text_data(each.title));
      column.set("kind", column_class(each.kind));
      columns.push_back(column);
    }
    Data rows(Data::type::list);
    for (std::size_t r = 0; r < table.rows.size(); ++r) rows.push_back(row_data(table, r));
    Data inner;
    inner.set("id", fmt::format("table-{}", tables));
    inner.set("name", text_data(table.caption.empty() ? section.title : table.caption));
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
      item.set("title", text_data(each.title));
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
    for (const char* other : {"headlines", "paragraph", "notice", "facts", "table", "figures",
                              "verbatim", "signature"}) {
      block.set(other, boolean(false));
    }
    block.set(name, inner);
    return block;
  }
  [[nodiscard]] Data row_data(const Table& table, std::size_t r) const {
    Data cells(Data::type::list);
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const Cell& each = table.rows[r][c];
      Data cell;
      cell.set("text", text_data(each.text));
      const ColumnKind kind = c < table.columns.size() ? table.columns[c].kind : ColumnKind::text;
      cell.set("kind", column_class(kind));
      const bool is_header = c == 0 && kind != ColumnKind::number;
      cell.set("is_header", boolean(is_header));
      cell.set("tag", is_header ? "th" : "td");
      set_tone(cell, each.tone, language);
      cells.push_back(cell);
    }
    Data row;
    row.set("cells", cells);
    row.set("is_folded", boolean(table.shown > 0 && r >= table.shown));
    return row;
  }
};

Data data_of(const std::vector<Section>& sections, const Language& language) {
  Data list(Data::type::list);
  int tables = 0;
  for (const Section& each : sections) {
    Data blocks(Data::type::list);
    for (const Block& block : each.blocks)
      blocks.push_back(std::visit(BlockData{language, each, tables}, block));
    Data section;
    section.set("id", each.id);
    section.set("title", text_data(each.title));
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

struct ScriptElement {
  std::string_view attributes;  // behind its id
  std::string_view content;
};

// The script element that begins so; the last one where there are several.
std::optional<ScriptElement> script_element(std::string_view html, std::string_view begin) {
  const std::size_t found = html.rfind(begin);
  if (found == std::string_view::npos) return std::nullopt;
  const std::size_t from = found + begin.size();
  const std::size_t inside = html.find('>', from);
  if (inside == std::string_view::npos) return std::nullopt;
  const std::size_t end = html.find(kEmbeddedEnd, inside);
  if (end == std::string_view::npos) return std::nullopt;
  return ScriptElement{html.substr(from, inside - from), html.substr(inside + 1, end - inside - 1)};
}

std::optional<std::string> embedded(std::string_view html, std::string_view begin) {
  const auto element = script_element(html, begin);
  return element ? std::optional(from_script(element->content)) : std::nullopt;
}

// The value that follows the begin of an attribute, up to its quote.
std::optional<std::string> attribute_value(std::string_view text, std::string_view begin) {
  const std::size_t found = text.find(begin);
  if (found == std::string_view::npos) return std::nullopt;
  const std::size_t from = found + begin.size();
  return std::string(text.substr(from, text.find('"', from) - from));
}

}  // namespace

bool reports_have_scripts() { return !report_asset("report.js").empty(); }

std::string html_of(const Page& page, const Language& language, const std::string& document,
                    const std::string& details) {
  const std::string script(report_asset("report.js"));
  Data data;
  data.set("language", language.code());
  data.set("title", text_data(page.title));
  data.set("subtitle", text_or_false(page.subtitle));
  data.set("number", text_or_false(page.number));
  data.set("head", data_of(page.head));
  data.set("has_head", boolean(std::any_of(page.head.rows.begin(), page.head.rows.end(),
                                           [](const auto& row) { return !row.second.empty(); })));
  Data stamp(Data::type::bool_false);
  if (!page.stamp.word.empty()) {
    stamp = Data();
    stamp.set("word", text_data(page.stamp.word));
    stamp.set("sentence", text_or_false(page.stamp.sentence));
    set_tone(stamp, page.stamp.tone, language);
  }
  data.set("stamp", stamp);
  data.set("sections", data_of(page.sections, language));
  data.set("style", std::string(report_asset("report.css")));
  data.set("paper_style",
           paper_style(page.number.empty()
                           ? page.title
                           : fmt::format("{} {}", language("page.report_number"), page.number),
                       language));
  data.set("script", text_or_false(script));
  data.set("policy", policy_for(script));
  // As JSON, so that every byte of it comes back.
  data.set("details", details.empty() ? Data(Data::type::bool_false)
                                      : Data(script_safe(Json(details).dump(
                                            -1, ' ', true, Json::error_handler_t::replace))));
  data.set("version", std::string(kVersion));
  const std::string safe = script_safe(document);
  data.set("sha256", sha256_hex(from_script(safe)));  // of what document_in_html gives back
  set_words(data, language);
  // Put in last and by hand: the document may be large, and is no text of the template.
  kainjow::mustache::mustache layout{std::string(report_asset("page.mustache"))};
  std::string html = layout.render(data);
  const std::size_t at = html.rfind(kDocumentBegin);
  if (at == std::string::npos) throw std::logic_error("page.mustache has no place for the result");
  html.insert(html.find('>', at) + 1, safe);
  return html;
}

std::optional<std::string> document_in_html(std::string_view html) {
  return embedded(html, kDocumentBegin);
}

std::optional<std::string> sha256_in_html(std::string_view html) {
  const auto element = script_element(html, kDocumentBegin);
  return element ? attribute_value(element->attributes, kSha256Begin) : std::nullopt;
}

std::optional<std::string> language_in_html(std::string_view html) {
  auto code = attribute_value(html, kLanguageBegin);
  const auto codes = Language::codes();
  const bool is_known = code && std::find(codes.begin(), codes.end(), *code) != codes.end();
  return is_known ? std::move(code) : std::nullopt;
}

std::optional<std::string> details_in_html(std::string_view html) {
  const auto text = embedded(html, kDetailsBegin);
  if (!text) return std::nullopt;
  const Json details = Json::parse(*text, nullptr, false);
  return details.is_string() ? std::optional(details.get<std::string>()) : std::nullopt;
}

}  // namespace armcal
