// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/plain_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/report/html/page_html.h"
#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using ::testing::Pair;
using testing::words_of;

Page page_of_keys(const Json& keys) { return page_in("en", document_of("fit circle", keys)); }

// The first section: single values.
const std::vector<std::pair<std::string, std::string>>& values_of(const Page& page) {
  return std::get<Facts>(page.sections.at(0).blocks.at(0)).rows;
}

// What a key that is no single value became.
template <typename Kind>
Kind block_of_key(const Json& value) {
  const Page page = page_of_keys({{"key", value}});
  EXPECT_EQ(page.sections.at(1).title, "key");
  return std::get<Kind>(page.sections.at(1).blocks.at(0));
}

std::vector<std::string> texts(const std::vector<Cell>& row) {
  std::vector<std::string> cells;
  for (const Cell& cell : row) cells.push_back(cell.text);
  return cells;
}

TEST(PlainPage, ListsSingleValuesByTheirKeys) {
  const Page page = page_of_keys({{"radius", 1.25},
                                  {"count", 12},
                                  {"big", 18446744073709551615U},
                                  {"good", true},
                                  {"name", "a b"},
                                  {"nothing", nullptr},
                                  {"centre", {1.5, -2.0, 1e-9}},
                                  {"third", 1.0 / 3.0}});
  EXPECT_THAT(
      values_of(page),
      ElementsAre(Pair("radius", "1.25"), Pair("count", "12"), Pair("big", "18446744073709551615"),
                  Pair("good", "true"), Pair("name", "a b"), Pair("nothing", ""),
                  Pair("centre", "1.5, -2, 1e-09"), Pair("third", "0.333333333")));
}

TEST(PlainPage, LeavesOutWhatStandsAtTheEnd) {
  const Page page = page_of_keys(Json::object());
  EXPECT_TRUE(values_of(page).empty());
  EXPECT_EQ(page.sections.size(), 2U);  // result, origin
}

TEST(PlainPage, ShowsMatricesRowByRow) {
  const Table table = block_of_key<Table>(Json::parse("[[1, 2.5], [null, -1e-7], [3, 4]]"));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.columns.size(), 2U);
  EXPECT_THAT(texts(table.rows[0]), ElementsAre("1", "2.5"));
  EXPECT_THAT(texts(table.rows[1]), ElementsAre("", "-1e-07"));
  EXPECT_EQ(table.shown, 0U);
}

TEST(PlainPage, ShowsListsOfObjectsAsOneTableOfAllTheirKeys) {
  const Table table = block_of_key<Table>(
      Json::parse(R"([{"name": "a", "x": 1}, {"x": null, "more": [1, [2]]}, {"name": "c"}])"));
  std::vector<std::pair<std::string, bool>> columns;
  for (const TableColumn& column : table.columns) {
    columns.emplace_back(column.title, column.kind == ColumnKind::number);
  }
  EXPECT_THAT(columns, ElementsAre(Pair("name", false), Pair("x", true), Pair("more", false)));
  EXPECT_THAT(texts(table.rows[0]), ElementsAre("a", "1", ""));
  EXPECT_THAT(texts(table.rows[1]), ElementsAre("", "", "[1,[2]]"));
}

TEST(PlainPage, RoundsAValueToTheUncertaintyBesideIt) {
  const Table table = block_of_key<Table>(
      Json::parse(R"([{"value": 1.23456, "nominal": 1.0, "u": 0.00995, "other": 1.23456},
                      {"value": 1.23456, "u": 0.0}, {"value": 1.23456, "u": "x"}])"));
  EXPECT_THAT(texts(table.rows[0]), ElementsAre("1.235", "1.000", "0.010", "1.23456"));
  EXPECT_THAT(texts(table.rows[1])[0], "1.23456");
  EXPECT_THAT(texts(table.rows[2])[0], "1.23456");
}

TEST(PlainPage, ShowsObjectsLongListsAndTexts) {
  EXPECT_THAT(block_of_key<Facts>(Json{{"a", 1}, {"b", {1, 2}}}).rows,
              ElementsAre(Pair("a", "1"), Pair("b", "1, 2")));
  const Table list = block_of_key<Table>({1, 2, 3, 4, 5, 6, "x"});
  EXPECT_THAT(texts(list.rows.back()), ElementsAre("7", "x"));
  EXPECT_EQ(list.columns[1].kind, ColumnKind::text);
  EXPECT_EQ(block_of_key<Verbatim>("two\nlines").text, "two\nlines");
}

// Lists that look like matrices or tables and are none.
TEST(PlainPage, ShowsWhatFitsNoTable) {
  for (const char* list :
       {"[[1, 2], [3]]", "[[], []]", "[{}, {}]", "[{\"a\": 1}, 2]", "[[1], {\"a\": 2}]",
        "[[[[1]]]]", "{\"a\": {\"b\": {\"c\": [[1], [2]]}}}"}) {
    const Page page = page_of_keys({{"key", Json::parse(list)}});
    EXPECT_THAT(html_of(page, Language::named("en"), "{}"), HasSubstr("<h2 id=\"key-1-title\">key"))
        << list;
  }
  EXPECT_THAT(words_of(page_of_keys({{"key", Json::parse("{\"a\": {\"b\": [{\"c\": 1}]}}")}})),
              HasSubstr("a: {\"b\":[{\"c\":1}]}"));
}

TEST(PlainPage, SaysWhereRowsAreLeftOut) {
  const std::string note = "The first 2000 of 10000 rows; the embedded result has all.";
  for (const Json& row : {Json::array({1, 2}), Json{{"a", 1}}, Json(1)}) {
    Json list = Json::array();
    for (int i = 0; i < 10000; ++i) list.push_back(row);
    EXPECT_THAT(words_of(page_of_keys({{"key", list}})), HasSubstr(note)) << row;
  }
}

TEST(PlainPage, FoldsLongTables) {
  const Table table = block_of_key<Table>(Json(21, Json::array({1, 2})));
  EXPECT_EQ(table.rows.size(), 21U);
  EXPECT_EQ(table.shown, 20U);
  EXPECT_EQ(table.note, "");
}

TEST(PlainPage, KeepsHostileKeysTexts) {
  const std::string hostile = "<script>alert(1)</script>\" onload=\"{{title}}";
  const Json keys = {{hostile, 1},
                     {hostile + "2", {{{hostile, hostile}}}},
                     {hostile + "3", {{hostile, {hostile}}}},
                     {hostile + "4", hostile + "\n"}};
  const Json document = document_of(hostile, keys);
  const std::string html = html_of(page_in("zh", document), Language::named("zh"), document.dump());
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("\" onload=\"")));
  EXPECT_THAT(html, HasSubstr("{{title}}"));
}

TEST(PlainPage, KeepsTheLawsOfPages) {
  testing::expect_page_laws(document_of(
      "fit circle",
      {{"radius", 1.5}, {"rows", {{{"a", 1}}}}, {"matrix", {{1, 2}}}, {"o", {{"a", 1}}}}));
}

}  // namespace
}  // namespace armcal
