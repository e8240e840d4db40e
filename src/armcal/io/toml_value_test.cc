// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/toml_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Document {
  Diagnostics diagnostics;
  std::optional<TomlValue> value;
  explicit Document(const std::string& text)
      : value(parse_toml({"a.toml", text, "UTF-8", ""}, diagnostics)) {}
  TomlSection root() { return {*value, diagnostics}; }
};

TEST(Toml, GivesValuesByKeyAndType) {
  Document document(
      "n = 1.5\ni = 3\nt = 'x'\nb = true\nv = [1, 2.5]\ns = ['a', 'b']\np = [[1, 2], [3, "
      "4]]\n[sub]\nk = 1\n[[row]]\nk = 1\n[[row]]\nk = 2\n");
  TomlSection root = document.root();
  EXPECT_EQ(root.number("n"), 1.5);
  EXPECT_EQ(root.number("i"), 3.0);
  EXPECT_EQ(root.integer("i"), 3);
  EXPECT_EQ(root.text("t"), "x");
  EXPECT_EQ(root.boolean("b"), true);
  EXPECT_THAT(root.numbers("v").value(), ElementsAre(1.0, 2.5));
  EXPECT_THAT(root.texts("s").value(), ElementsAre("a", "b"));
  EXPECT_THAT(root.texts("t").value(), ElementsAre("x"));  // one text stands for a list of one
  EXPECT_EQ(root.pairs("p").value()[1], Eigen::Vector2d(3, 4));
  EXPECT_EQ(root.section("sub")->number("k"), 1.0);
  EXPECT_EQ(root.sections("row")[1].number("k"), 2.0);
  EXPECT_FALSE(root.number("absent").has_value());
  root.finish();
  EXPECT_FALSE(document.diagnostics.has_errors()) << document.diagnostics.to_text();
}

TEST(Toml, NamesThePlaceOfAWrongType) {
  Document document("a = 'x'\n\n  b = nan\nc = [1, 'two']\nd = 1.5\ne = [[1, 2, 3]]\n");
  TomlSection root = document.root();
  EXPECT_FALSE(root.number("a").has_value());
  EXPECT_FALSE(root.number("b").has_value());
  EXPECT_FALSE(root.numbers("c").has_value());
  EXPECT_FALSE(root.integer("d").has_value());
  EXPECT_FALSE(root.pairs("e").has_value());
  const std::string text = document.diagnostics.to_text();
  EXPECT_THAT(text, HasSubstr("a.toml:1:1: error: a must be a number, not a text"));
  EXPECT_THAT(text, HasSubstr("a.toml:3:3: error: b must be a number, not nan or inf"));
  EXPECT_THAT(text, HasSubstr("a.toml:4:9: error: entry 2 of c must be a number, not a text"));
  EXPECT_THAT(text, HasSubstr("a.toml:5:1: error: d must be a whole number, not a number"));
  EXPECT_THAT(text, HasSubstr("e must be pairs of numbers"));
}

// 20260117 was printed as "20260117.0", 1.10 as "1.1".
TEST(Toml, SpellsWhatIsPrintedAsItWasTyped) {
  Document document(
      "whole = 20260117\nlarge = 9007199254740993\ndate = 2026-01-17\ntext = '1.10'\n"
      "decimal = 1.10\nlate = 1e3\nflag = true\n");
  TomlSection root = document.root();
  EXPECT_EQ(root.spelled("whole"), "20260117");
  EXPECT_EQ(root.spelled("large"), "9007199254740993");
  EXPECT_EQ(root.spelled("date"), "2026-01-17");
  EXPECT_EQ(root.spelled("text"), "1.10");
  EXPECT_EQ(root.spelled("absent"), std::nullopt);
  EXPECT_FALSE(document.diagnostics.has_errors()) << document.diagnostics.to_text();
  for (const char* key : {"decimal", "late", "flag"}) EXPECT_EQ(root.spelled(key), std::nullopt);
  EXPECT_EQ(document.diagnostics.to_text(),
            "a.toml:5:1: error: decimal is a decimal number without quotes\n"
            "  help: write it in quotes, so that it stays as it is typed\n"
            "a.toml:6:1: error: late is a decimal number without quotes\n"
            "  help: write it in quotes, so that it stays as it is typed\n"
            "a.toml:7:1: error: flag must be a text, not true or false\n");
}

TEST(Toml, ComplainsOfUnknownKeysWithTheNearestKnownOne) {
  Document document("distance_mm = 1\ndistanse_mm = 2\n");
  TomlSection root = document.root();
  static_cast<void>(root.number("distance_mm"));
  static_cast<void>(root.number("u_mm"));
  root.finish();
  EXPECT_EQ(
      document.diagnostics.to_text(),
      "a.toml:2:1: error: unknown key \"distanse_mm\"\n  help: did you mean \"distance_mm\"?\n");
}

TEST(Toml, ComplainsOfWhatIsNoToml) {
  Document document("a = 1\nb = = 2\n");
  EXPECT_FALSE(document.value.has_value());
  EXPECT_THAT(document.diagnostics.to_text(), HasSubstr("a.toml:2:"));
  EXPECT_THAT(document.diagnostics.to_text(), HasSubstr("is not TOML"));
}

// Found by the fuzzer: toml++ 3.3 runs into undefined behaviour on letters such as these.
TEST(Toml, ReadsAndNamesLettersOfEveryScript) {
  const std::string letters = "é Ω ﷲ 关节 ﺀ ﻿ 𝛼";
  Document document("a = '" + letters + "' # ü\n'" + letters + "' = \"\"\"" + letters +
                    "\\\n  é\"\"\"\n");
  ASSERT_TRUE(document.value.has_value()) << document.diagnostics.to_text();
  EXPECT_EQ(document.root().text("a"), letters);
  EXPECT_EQ(document.root().text(letters), letters + "é");
  EXPECT_THAT(Document("a = 1\nb = “two”\n").diagnostics.to_text(),
              HasSubstr("a.toml:2:5: error: is not TOML: "));
  for (const char* stray :
       {"é = 1", "a = 1 ﺀ", "a = \"\"\"b \\é\"\"\"", "[é]", "a = 1é", "a = [é]"}) {
    EXPECT_FALSE(Document(stray).value.has_value()) << stray;
  }
}

// Found by the fuzzer: toml++ 3.3 asserts where it should complain.
TEST(Toml, ComplainsOfTablesWithoutAName) {
  EXPECT_EQ(Document("a = 1\n[b]\n[$c]\nd = 1\n[e]\n").diagnostics.to_text(),
            "a.toml:3: error: is not TOML: a name of a table with other characters than letters, "
            "digits, _ and - stands outside quotes\n");
  EXPECT_EQ(Document("[[é]]").diagnostics.to_text().substr(0, 16), "a.toml:1: error:");
}

// Found by reading: the magnitude of the smallest 64-bit number cannot be taken.
TEST(Toml, RefusesNumbersFarTooLarge) {
  Document document("n = -9223372036854775808\n");
  EXPECT_FALSE(document.root().integer("n").has_value());
}

TEST(Toml, ChecksTheSchema) {
  const auto complaint = [](const std::string& text) {
    Document document(text);
    TomlSection root = document.root();
    check_schema(root, "arm", document.diagnostics);
    return document.diagnostics.to_text();
  };
  EXPECT_EQ(complaint("schema = 'armcal.arm/1'"), "");
  EXPECT_EQ(complaint("schema = 'armcal.arm/1.3'"), "");
  EXPECT_THAT(complaint("schema = 'armcal.arm/2'"),
              HasSubstr("a.toml:1:1: error: schema \"armcal.arm/2\" is not"));
  EXPECT_THAT(complaint("a = 1"), HasSubstr("write schema = \"armcal.arm/1\" at its top"));
}

TEST(Toml, RefusesBottomlessNesting) {
  Document document("a = " + std::string(100000, '['));
  EXPECT_FALSE(document.value.has_value());
}

RC_GTEST_PROP(Toml, SurvivesAnyText, (const std::string& text)) {
  Document document(text);
  RC_ASSERT(document.value.has_value() != document.diagnostics.has_errors());
}

}  // namespace
}  // namespace armcal
