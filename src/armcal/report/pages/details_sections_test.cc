// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/details_sections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pair;
using testing::words_of;

const Language& english() { return Language::named("en"); }

Page page_with(const ReportDetails& details, const std::string& language = "en") {
  Page page;
  page.head.rows = {{"Arm", "A-1"}};
  page.sections = {{"summary", "Summary", "", {}}};
  add_details(details, Language::named(language), page);
  return page;
}

ReportDetails full_details() {
  ReportDetails details;
  details.laboratory = {"Lab", "Street 1", "D-K-1"};
  details.replaces = "R-1";
  details.customer = {"Customer", "Road 2"};
  details.place = "hall 3";
  details.item = {"arm", "maker", "model", "S-17", "probe 6 mm", "worn"};
  details.dates = {"2026-01-01", "2026-01-02", "2026-01-03"};
  details.environment = {"20.1 C", "45 %", "on a tripod", "quiet"};
  details.references = {{"bar", "B-9", "C-1", "PTB", "1 um", "2027-01-01"}};
  details.method = {"ISO 10360-12", "2016", "none"};
  details.statements = {"k = 2", "simple acceptance", "see over"};
  details.externals = {{"Bar Lab", "length of the bar"}};
  details.released_by = {"A. Person", "head"};
  return details;
}

TEST(DetailsSections, LeaveAPageAsItIsWhereThereIsNothingToSay) {
  const Page page = page_with({});
  EXPECT_EQ(page.sections.size(), 1U);
  EXPECT_EQ(words_of(page).find("this item"), std::string::npos);
}

TEST(DetailsSections, SayEverythingBesideTheTitleAndBehindTheResult) {
  const Page page = page_with(full_details());
  EXPECT_THAT(page.head.rows,
              ElementsAre(Pair("Replaces report", "R-1"), Pair("Laboratory", "Lab, Street 1"),
                          Pair("Accreditation", "D-K-1"), Pair(::testing::_, "hall 3"),
                          Pair("Customer", "Customer, Road 2"),
                          Pair(::testing::_, "arm, maker, model"), Pair(::testing::_, "S-17"),
                          Pair(::testing::_, "probe 6 mm"), Pair(::testing::_, "worn"),
                          Pair(::testing::_, "2026-01-01"), Pair(::testing::_, "2026-01-02"),
                          Pair(::testing::_, "2026-01-03"), Pair("Arm", "A-1")));
  ASSERT_EQ(page.sections.size(), 2U);
  EXPECT_EQ(page.sections[1].id, "conditions");
  const auto& facts = std::get<Facts>(page.sections[1].blocks.at(0)).rows;
  std::vector<std::string> values;
  for (const auto& [name, value] : facts) values.push_back(value);
  EXPECT_THAT(values, ElementsAre("20.1 C", "45 %", "on a tripod", "quiet", "ISO 10360-12, 2016",
                                  "none", "k = 2", "simple acceptance", "see over"));
  EXPECT_THAT(words_of(page), HasSubstr("bar | B-9 | C-1 | PTB | 1 um | 2027-01-01 | "));
  EXPECT_THAT(words_of(page), HasSubstr("External provider | Results | \nBar Lab | length of the "
                                        "bar | "));
  // The last word has who released it.
  const auto& blocks = page.sections[1].blocks;
  EXPECT_TRUE(std::holds_alternative<Paragraph>(blocks.at(blocks.size() - 2)));
  const auto& signature = std::get<Signature>(blocks.back());
  EXPECT_EQ(signature.label, "Released by");
  EXPECT_EQ(signature.name, "A. Person");
  EXPECT_EQ(signature.role, "head");
}

TEST(DetailsSections, HaveNoLineToSignOnWhereNobodyIsNamed) {
  ReportDetails details = full_details();
  details.released_by = {};
  const Page page = page_with(details);
  EXPECT_TRUE(std::holds_alternative<Paragraph>(page.sections[1].blocks.back()));
  details = {};
  details.released_by.role = "head";
  EXPECT_THAT(words_of(page_with(details)), HasSubstr("Released by\n\nhead\n"));
}

TEST(DetailsSections, SayInWordsOfTheStandardWhatReplacesAndWhatIsOfOthers) {
  const std::string words = words_of(page_with(full_details(), "zh"));
  EXPECT_THAT(words, HasSubstr("来自外部供应者的结果"));
  EXPECT_THAT(words, HasSubstr("所替代的原报告: R-1"));
  EXPECT_THAT(words, HasSubstr("批准人\nA. Person\nhead"));
}

TEST(DetailsSections, NameThemInTheLanguageOfTheReader) {
  const Page page = page_with(full_details(), "zh");
  for (std::size_t i = 0; i + 1 < page.head.rows.size(); ++i) {
    EXPECT_NE(page.head.rows[i].first, page_with(full_details()).head.rows[i].first);
    EXPECT_EQ(page.head.rows[i].second, page_with(full_details()).head.rows[i].second);
  }
}

TEST(DetailsSections, PutNoCommaWhereAPartIsMissing) {
  ReportDetails details;
  details.customer.address = "Road 2";
  details.item.model = "model";
  const std::string words = words_of(page_with(details));
  EXPECT_THAT(words, HasSubstr("Customer: Road 2\n"));
  EXPECT_THAT(words, HasSubstr(": model\n"));
}

// --- where the numbers come from

std::string typed(const std::vector<std::string>& words) {
  Json document = document_of("fk", Json::object());
  document["command_line"] = words;
  const Section section = origin_section(DocumentView(document, "saved.json"), english());
  return std::get<Verbatim>(section.blocks.at(1)).text;
}

// Words that a shell makes of a line that begins with `armcal`.
std::vector<std::string> words_in_shell(const std::string& line) {
  const std::string script = "armcal() { printf '%s\\0' \"$@\"; }\n" + line;
  std::string quoted;
  for (const char c : script) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("sh -c '" + quoted + "'").c_str(), "r"),
                                                   pclose);
  std::vector<std::string> words(1);
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
    if (c != 0) {
      words.back() += static_cast<char>(c);
    } else {
      words.emplace_back();
    }
  }
  words.pop_back();
  return words;
}

TEST(OriginSection, ShowsTheCommandLineSoThatItCanBeTypedAgain) {
  EXPECT_EQ(typed({"fk", "a.arm.toml", "--scale=1e-3"}), "armcal fk a.arm.toml --scale=1e-3");
  EXPECT_EQ(typed({"fk", "my arm.toml", ""}), "armcal fk 'my arm.toml' ''");
  const std::vector<std::string> words = {
      "fit circle",  "it's", "\"quoted\"",  "two\nlines",       "tab\there",
      "$HOME",       "`id`", "back\\slash", "*?[a]~",           "",
      "a;b|c&d>e<f", "''",   "!1 #no",      "\xe8\x87\x82.csv", "{0}",
      "-o"};
  EXPECT_EQ(words_in_shell(typed(words)), words);
}

TEST(OriginSection, NamesFilesVersionAndSeed) {
  DocumentHead head;
  head.command = "simulate";
  head.inputs = {{"arm.toml", std::string(64, 'a')}, {"q.csv", std::string(64, 'b')}};
  head.seed = 18446744073709551615U;
  const Json document = Json::parse(json_document(head, Json::object()));
  Page page;
  page.sections = {origin_section(DocumentView(document, "saved.json"), english())};
  const std::string words = words_of(page);
  EXPECT_THAT(words, HasSubstr("arm.toml | " + std::string(64, 'a')));
  EXPECT_THAT(words, HasSubstr("q.csv | " + std::string(64, 'b')));
  EXPECT_THAT(words, HasSubstr(": 18446744073709551615\n"));
  EXPECT_THAT(words, HasSubstr(document["tool_version"].get<std::string>()));
}

TEST(OriginSection, RepeatsWarningsWithTheirPlaces) {
  DocumentHead head;
  head.diagnostics.warning({"q.csv", 7, 2}, "looks odd", "");
  head.diagnostics.warning({}, "nothing to see", "");
  const Json document = Json::parse(json_document(head, Json::object()));
  const Section section = origin_section(DocumentView(document, "saved.json"), english());
  const Notice& notice = std::get<Notice>(section.blocks.back());
  EXPECT_THAT(notice.lines, ElementsAre("q.csv:7: looks odd", "nothing to see"));
  EXPECT_EQ(notice.tone, Tone::warning);
}

TEST(OriginSection, HasNoEmptyTablesAndNoticesOfNothing) {
  Json document = document_of("fk", Json::object());
  document.erase("command_line");
  const Section section = origin_section(DocumentView(document, "saved.json"), english());
  EXPECT_EQ(section.blocks.size(), 1U);
}

}  // namespace
}  // namespace armcal
