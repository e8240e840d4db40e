// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armcal {
namespace {

using testing::HasSubstr;

TEST(Diagnostics, NamesFileLineColumnAndRemedy) {
  Diagnostics diagnostics;
  diagnostics.error({"readings.csv", 118, 5}, "joint 4 angle \"12.3.4\" is not a number",
                    "mend it");
  EXPECT_EQ(
      diagnostics.to_text(),
      "readings.csv:118:5: error: joint 4 angle \"12.3.4\" is not a number\n  help: mend it\n");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Diagnostics, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(to_string({Severity::error, {"a.toml", 7, 0}, "no such key", ""}),
            "a.toml:7: error: no such key");
  EXPECT_EQ(to_string({Severity::error, {"a.toml", 0, 3}, "empty", ""}), "a.toml: error: empty");
  EXPECT_EQ(to_string({Severity::warning, {}, "slow", ""}), "warning: slow");
}

TEST(Diagnostics, WarningsAreNotErrors) {
  Diagnostics diagnostics;
  diagnostics.warning({"a.csv", 1, 1}, "no unit row");
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(diagnostics.warnings().size(), 1u);
  EXPECT_EQ(diagnostics.warnings()[0].message, "no unit row");
}

TEST(Diagnostics, KeepsTheFirstOfMany) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 120; ++line) diagnostics.error({"bad.csv", line, 1}, "bad");
  EXPECT_EQ(diagnostics.entries().size(), Diagnostics::kShownPerFile);
  EXPECT_EQ(diagnostics.error_count(), 120u);
  EXPECT_FALSE(diagnostics.is_hopeless("bad.csv"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("bad.csv: error: 100 more errors not shown"));
}

TEST(Diagnostics, GivesUpOnAHopelessFileOnly) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 1000; ++line) diagnostics.error({"bad.csv", line, 1}, "bad");
  EXPECT_TRUE(diagnostics.is_hopeless("bad.csv"));
  EXPECT_FALSE(diagnostics.is_hopeless("other.csv"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("more than 999 errors: gave up reading"));
}

TEST(Diagnostics, AppendKeepsCountsOfWhatIsNotShown) {
  Diagnostics first;
  Diagnostics second;
  first.warning({"a.csv", 1, 1}, "w");
  for (int line = 1; line <= 30; ++line) second.error({"b.csv", line, 1}, "bad");
  first.append(second);
  EXPECT_EQ(first.error_count(), 30u);
  EXPECT_THAT(first.to_text(), HasSubstr("b.csv: error: 10 more errors not shown"));
}

TEST(InputError, SaysEverythingAtOnce) {
  Diagnostics diagnostics;
  diagnostics.error({"a.csv", 1, 1}, "one");
  diagnostics.error({"b.csv", 2, 1}, "two");
  const InputError error(diagnostics);
  EXPECT_STREQ(error.what(), "a.csv:1:1: error: one\nb.csv:2:1: error: two\n");
}

}  // namespace
}  // namespace armcal
