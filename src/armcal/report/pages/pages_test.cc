// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "armcal/testing/page_laws.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using testing::page_in;
using testing::section_of;

std::string refusal_of_any(const Json& document) {
  try {
    (void)page_in("en", document);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Json circle() { return document_of("fit circle", {{"radius", 1.5}}); }

TEST(PageOf, EndsWithTheOriginOfTheNumbers) {
  const Page page = page_in("en", circle());
  EXPECT_EQ(page.sections.back().id, "origin");
  EXPECT_EQ(page.title, "Result of armcal fit circle");
  EXPECT_TRUE(page.stamp.word.empty());
}

TEST(PageOf, RefusesWhatIsNoResult) {
  for (const Json& document : {Json(), Json(1), Json("x"), Json::array(), Json::object(),
                               Json{{"schema", nullptr}}, Json{{"radius", 1.5}}}) {
    EXPECT_THAT(refusal_of_any(document), HasSubstr("saved.json: error: is no result of armcal\n"));
  }
  EXPECT_THAT(refusal_of_any({{"schema", 1}}), HasSubstr("key schema: is not a text"));
}

TEST(PageOf, ReadsEveryMinorVersionOfItsSchemaAndNoOther) {
  Json document = circle();
  document["schema"] = "armcal.result/1.4";  // minor versions only add
  EXPECT_EQ(refusal_of_any(document), "");
  for (const char* schema : {"armcal.result/2", "armcal.result/10", "armcal.result/1x",
                             "armcal.result", "armcal.session/1", "", "<script>"}) {
    document["schema"] = schema;
    EXPECT_THAT(
        refusal_of_any(document),
        HasSubstr(fmt::format("key schema: is \"{}\"; this armcal reads armcal.result/1", schema)));
  }
}

TEST(PageOf, RefusesTheDocumentOfAFailure) {
  DocumentHead head;
  head.command = "calibrate";
  EXPECT_THAT(refusal_of_any(Json::parse(json_error(head, 2, "error: no such file\n"))),
              HasSubstr("key error: the command failed, so there is no result to report"));
}

TEST(PageOf, WantsToKnowTheCommand) {
  Json document = circle();
  document.erase("command");
  EXPECT_THAT(refusal_of_any(document), HasSubstr("key command: is missing"));
}

std::string number_of(const Json& document) { return page_in("en", document).number; }

TEST(PageNumber, IsTheSameWhereverTheResultIsReported) {
  const Json document = circle();
  EXPECT_THAT(number_of(document), MatchesRegex("armcal-[0-9a-f]{12}"));
  EXPECT_EQ(number_of(Json::parse(document.dump(8))), number_of(document));
  EXPECT_EQ(page_in("zh", document).number, number_of(document));
}

// Another name for the report made another number.
TEST(PageNumber, IsTheSameHoweverTheCommandWasTyped) {
  const Json document = circle();
  Json typed = document;
  typed["command_line"] = {"fit", "circle", "p.csv", "--report", "again.html"};
  typed["seed"] = 7;
  EXPECT_EQ(number_of(typed), number_of(document));
  for (const char* key : {"command_line", "seed"}) typed.erase(key);
  EXPECT_EQ(number_of(typed), number_of(document));
  Json of_others = document;
  of_others["inputs"].push_back(Json::object({{"path", "p.csv"}, {"sha256", "0"}}));
  EXPECT_NE(number_of(of_others), number_of(document));
}

TEST(PageNumber, IsAnotherOneForAnotherResult) {
  Json document = circle();
  std::set<std::string> numbers;
  for (int digit = 0; digit < 100; ++digit) {
    document["radius"] = 1.5 + 1e-12 * digit;
    numbers.insert(number_of(document));
  }
  EXPECT_EQ(numbers.size(), 100U);
}

TEST(PageOf, TakesTitleAndNumberFromTheDetails) {
  const Json document = circle();
  ReportDetails details;
  details.title = "Certificate";
  details.number = "A-17";
  details.customer.name = "Customer";
  const Page page = page_of(DocumentView(document, "x"), Language::named("en"), details);
  EXPECT_EQ(page.title, "Certificate");
  EXPECT_EQ(page.number, "A-17");
  EXPECT_EQ(page.head.rows.front().second, "");
  ASSERT_GE(page.sections.size(), 2U);
  EXPECT_EQ(page.sections[page.sections.size() - 2].id, "conditions");  // before the origin
}

}  // namespace
}  // namespace armcal
