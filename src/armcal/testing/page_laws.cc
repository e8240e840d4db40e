// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/page_laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>
#include <vector>

#include "armcal/report/html/page_html.h"
#include "armcal/report/pages/pages.h"

namespace armcal::testing {
namespace {

const std::string kEndOfAttribute = "\" onload=\"";
const std::string kHostile =
    "<script>alert('1')</script> \"&" + kEndOfAttribute + " {{title}} \u202e{0}";
constexpr std::size_t kTriedOfLists = 1;

struct Words {
  std::string text;
  void add(const std::string& line) { text += line + '\n'; }
  void operator()(const Headlines& headlines) {
    for (const Headline& each : headlines.items) {
      add(each.label);
      add(each.value + ' ' + each.unit);
      add(each.note);
    }
  }
  void operator()(const Paragraph& paragraph) { add(paragraph.text); }
  void operator()(const Notice& notice) {
    add(notice.title);
    for (const std::string& line : notice.lines) add(line);
  }
  void operator()(const Facts& facts) {
    for (const auto& [name, value] : facts.rows) add(name + ": " + value);
  }
  void operator()(const Table& table) {
    add(table.caption);
    std::string line;
    for (const TableColumn& column : table.columns) line += column.title + " | ";
    add(line);
    for (const auto& row : table.rows) {
      line.clear();
      for (const Cell& cell : row) line += cell.text + " | ";
      add(line);
    }
    add(table.note);
  }
  void operator()(const Figures& figures) {
    for (const Figure& each : figures.items) {
      add(each.title);
      add(each.text);
    }
  }
  void operator()(const Verbatim& verbatim) { add(verbatim.text); }
  void operator()(const Signature& signature) {
    add(signature.label);
    add(signature.name);
    add(signature.role);
  }
};

void add_paths(const Json& json, const Json::json_pointer& path,
               std::vector<Json::json_pointer>& paths) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      paths.push_back(path / key);
      add_paths(value, path / key, paths);
    }
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < std::min(json.size(), kTriedOfLists); ++i) {
      paths.push_back(path / i);
      add_paths(json[i], path / i, paths);
    }
  }
}

void expect_page_or_named(const Json& document, const Json::json_pointer& path,
                          const Json& changed_to) {
  try {
    const Page page = page_in("zh", document);
    if (changed_to != kHostile) return;
    const std::string html = html_of(page, Language::named("zh"), document.dump());
    for (const std::string& markup : {std::string("<script>alert"), kEndOfAttribute}) {
      EXPECT_EQ(html.find(markup), std::string::npos) << path.to_string();
    }
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("key "), std::string::npos) << error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << path.to_string() << " as " << changed_to.dump() << ": " << error.what();
  }
}

}  // namespace

Json document_of(const std::string& command, const Json& result) {
  DocumentHead head;
  head.command = command;
  return Json::parse(json_document(head, result));
}

Page page_in(const std::string& language, const Json& document) {
  return page_of(DocumentView(document, "saved.json"), Language::named(language), {});
}

std::string words_of(const Page& page) {
  Words words;
  for (const std::string* each :
       {&page.title, &page.subtitle, &page.stamp.word, &page.stamp.sentence}) {
    words.add(*each);
  }
  words(page.head);
  for (const Section& section : page.sections) {
    words.add(section.title);
    words.add(section.lead);
    for (const Block& block : section.blocks) std::visit(words, block);
  }
  return words.text;
}

Section section_of(const Page& page, const std::string& id) {
  for (const Section& section : page.sections) {
    if (section.id == id) return section;
  }
  ADD_FAILURE() << "no section " << id;
  return {};
}

namespace {

// Sections and figures are found by their ids.
void expect_ids_of_their_own(const Page& page) {
  std::set<std::string> ids;
  const auto expect_new = [&](const std::string& id) {
    EXPECT_FALSE(id.empty());
    EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos)
        << id;
    EXPECT_TRUE(ids.insert(id).second) << id << " twice";
  };
  for (const Section& section : page.sections) {
    expect_new(section.id);
    for (const Block& block : section.blocks) {
      if (const auto* figures = std::get_if<Figures>(&block)) {
        for (const Figure& figure : figures->items) expect_new(figure.id);
      }
    }
  }
}

// A cell without a column stands under the wrong title.
void expect_rows_as_wide_as_columns(const Page& page) {
  for (const Section& section : page.sections) {
    for (const Block& block : section.blocks) {
      const auto* table = std::get_if<Table>(&block);
      if (table == nullptr) continue;
      for (const std::vector<Cell>& row : table->rows) {
        EXPECT_EQ(row.size(), table->columns.size()) << section.id << ": " << table->caption;
      }
    }
  }
}

}  // namespace

void expect_page_laws(const Json& document) {
  for (const char* language : {"en", "zh"}) {
    const Page page = page_in(language, document);
    EXPECT_FALSE(page.sections.empty());
    expect_ids_of_their_own(page);
    expect_rows_as_wide_as_columns(page);
  }
  std::vector<Json::json_pointer> paths;
  add_paths(document, Json::json_pointer(), paths);
  for (const Json::json_pointer& path : paths) {
    const std::string key = path.back();
    if (key == "schema" || key == "command") continue;
    for (const Json& value :
         {Json(nullptr), Json(kHostile), Json(1e300), Json(-1.0), Json::array()}) {
      Json changed = document;
      changed[path] = value;
      expect_page_or_named(changed, path, value);
    }
  }
}

}  // namespace armcal::testing
