// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/document_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

DocumentView view_of(const Json& json) { return {json, "saved.json"}; }

std::string complaint(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().error_count(), 1U);
    return error.what();
  }
  return "";
}

const Json kDocument = Json::parse(R"({
  "name": "arm", "length": 2.5, "count": 3, "good": true, "nothing": null,
  "values": [1, null, 2.5], "words": ["a", "b"], "inner": {"deep": {"x": 1}},
  "tests": [{"value_mm": 1.0}, {"value_mm": 2.0}, {"value_mm": "much"}]})");

TEST(DocumentView, ReadsValuesOfEachType) {
  const DocumentView view = view_of(kDocument);
  EXPECT_EQ(view.text("name"), "arm");
  EXPECT_EQ(view.number("length"), 2.5);
  EXPECT_EQ(view.number("count"), 3.0);
  EXPECT_TRUE(view.flag("good"));
  EXPECT_THAT(view.texts("words"), ElementsAre("a", "b"));
  EXPECT_EQ(view["inner"]["deep"].number("x"), 1.0);
  EXPECT_EQ(view.list("tests").size(), 3U);
  EXPECT_EQ(view.list("tests")[1].number("value_mm"), 2.0);
}

// A joint of 1e300, in a document edited by hand, overflowed an int.
TEST(DocumentView, CountsFromOneAndNamesWhatIsNoSuchThing) {
  const DocumentView view = view_of(kDocument);
  EXPECT_EQ(view.ordinal("count", 3), 3);
  const Json edited = Json::parse(R"({"zero": 0, "half": 1.5, "huge": 1e300, "less": -1})");
  for (const char* key : {"zero", "half", "huge", "less"}) {
    EXPECT_THAT(complaint([&] { static_cast<void>(view_of(edited).ordinal(key, 6)); }),
                StartsWith(std::string("saved.json: error: key ") + key + ": is none of 1 to 6"));
  }
}

TEST(DocumentView, ReadsNullAmongNumbersAsNotANumber) {
  const std::vector<double> values = view_of(kDocument).numbers("values");
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0], 1.0);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], 2.5);
  EXPECT_TRUE(view_of(Json::array()).as_numbers().empty());
}

TEST(DocumentView, HasNothingUnderNullAndInWhatIsNoObject) {
  const DocumentView view = view_of(kDocument);
  EXPECT_TRUE(view.has("good"));
  EXPECT_FALSE(view.has("nothing"));
  EXPECT_FALSE(view.has("missing"));
  EXPECT_FALSE(view["name"].has("name"));
  EXPECT_FALSE(view["words"].has("0"));
}

TEST(DocumentView, GivesNothingForWhatMayBeMissing) {
  const DocumentView view = view_of(kDocument);
  for (const char* key : {"nothing", "missing"}) {
    EXPECT_EQ(view.text_if(key), std::nullopt);
    EXPECT_EQ(view.number_if(key), std::nullopt);
  }
  EXPECT_EQ(view.text_if("name"), "arm");
  EXPECT_EQ(view.number_if("count"), 3.0);
  EXPECT_EQ(view_of(nullptr).as_number_if(), std::nullopt);
  // Of another type is not the same as missing.
  EXPECT_THAT(complaint([&] { (void)view.text_if("count"); }), HasSubstr("is not a text"));
  EXPECT_THAT(complaint([&] { (void)view.number_if("name"); }), HasSubstr("is not a number"));
}

TEST(DocumentView, NamesFileKeyAndRemedy) {
  EXPECT_EQ(complaint([] { (void)view_of(kDocument).list("tests")[2].number("value_mm"); }),
            "saved.json: error: key tests[2].value_mm: is not a number\n"
            "  help: a result is what armcal prints with --json or saves with --save; make it "
            "anew\n");
}

TEST(DocumentView, NamesTheWholePath) {
  const DocumentView view = view_of(kDocument);
  EXPECT_THAT(complaint([&] { (void)view["inner"]["deep"].text("x"); }),
              HasSubstr("key inner.deep.x: is not a text"));
  EXPECT_THAT(complaint([&] { (void)view["inner"]["deep"]["y"]; }),
              HasSubstr("key inner.deep.y: is missing"));
  EXPECT_THAT(complaint([&] { (void)view["nothing"]; }), HasSubstr("key nothing: is missing"));
  EXPECT_THAT(complaint([&] { (void)view["name"]["first"]; }),
              HasSubstr("key name.first: is missing"));
  const Json matrix = Json::parse("[[1, 2], [3, \"x\"]]");
  EXPECT_THAT(complaint([&] { (void)view_of(matrix).items()[1].items()[1].as_number(); }),
              HasSubstr("key [1][1]: is not a number"));
  // At the root there is no key to name.
  EXPECT_THAT(complaint([] { view_of(kDocument).complain("is no result"); }),
              StartsWith("saved.json: error: is no result\n"));
}

TEST(DocumentView, ComplainsOfEveryOtherType) {
  using Read = std::function<void(const DocumentView&)>;
  struct Reader {
    const char* wants;
    Read read;
    std::string complaint;
  };
  const std::vector<Reader> readers = {
      {"text", [](const DocumentView& view) { (void)view.text("v"); }, "is not a text"},
      {"number", [](const DocumentView& view) { (void)view.number("v"); }, "is not a number"},
      {"flag", [](const DocumentView& view) { (void)view.flag("v"); }, "is neither true nor false"},
      {"list", [](const DocumentView& view) { (void)view.numbers("v"); }, "is not a list"},
      {"list", [](const DocumentView& view) { (void)view.texts("v"); }, "is not a list"},
      {"list", [](const DocumentView& view) { (void)view.list("v"); }, "is not a list"}};
  const std::vector<std::pair<const char*, Json>> values = {
      {"text", "1"},   {"number", 1},          {"number", 0.5},
      {"flag", false}, {"object", {{"v", 1}}}, {"list", Json::array()}};
  for (const Reader& reader : readers) {
    for (const auto& [type, value] : values) {
      const Json json = {{"v", value}};
      const std::string said = complaint([&] { reader.read(view_of(json)); });
      if (std::string_view(type) == reader.wants) {
        EXPECT_EQ(said, "") << reader.wants;
      } else {
        EXPECT_THAT(said, HasSubstr("key v: " + reader.complaint + "\n")) << type;
      }
    }
  }
}

TEST(DocumentView, ComplainsOfListsThatHoldOtherTypes) {
  const Json json = {{"numbers", {1, "2"}}, {"words", {"a", 2}}};
  EXPECT_THAT(complaint([&] { (void)view_of(json).numbers("numbers"); }),
              HasSubstr("key numbers: holds what is not a number"));
  EXPECT_THAT(complaint([&] { (void)view_of(json).texts("words"); }),
              HasSubstr("key words[1]: is not a text"));
}

TEST(DocumentView, SaysKeysOfUsersAsTheyAre) {
  const Json json = {{"<script> \"a\".b", Json::object()}};
  EXPECT_THAT(complaint([&] { (void)view_of(json)["<script> \"a\".b"].as_text(); }),
              HasSubstr("key <script> \"a\".b: is not a text"));
}

}  // namespace
}  // namespace armcal
