// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/text_table.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(TextTable, AlignsColumns) {
  TextTable table({{"name", Align::left}, {"value"}});
  table.add_row({"a5", "78.312"});
  table.add_row({"zero6", "0.1"});
  EXPECT_EQ(table.text(),
            "  name    value\n"
            "  a5     78.312\n"
            "  zero6     0.1\n");
}

TEST(TextTable, CountsWideCharactersDouble) {
  EXPECT_EQ(display_width("abc"), 3u);
  EXPECT_EQ(display_width("\xC2\xB5m"), 2u);
  EXPECT_EQ(display_width("\xE5\x85\xB3\xE8\x8A\x82"), 4u);
  TextTable table({{"n", Align::left}, {"v"}});
  table.add_row({"\xE5\x85\xB3", "1"});
  EXPECT_EQ(table.text(0), "n   v\n\xE5\x85\xB3  1\n");
}

TEST(TextTable, IsATableOfAMarkdownPageToo) {
  TextTable table({{"method", Align::left}, {"rms mm"}});
  table.add_row({"one cone", "0.1"});
  table.add_row({"none", ""});
  EXPECT_EQ(table.markdown(), "| method | rms mm |\n|---|---:|\n| one cone | 0.1 |\n| none | |\n");
}

}  // namespace
}  // namespace armcal
