// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/visible_text.h"

#include <gtest/gtest.h>

#include <string>

namespace armcal {
namespace {

TEST(VisibleText, ShowsControlCharacters) {
  EXPECT_EQ(visible_text(std::string("a\0b", 3)), "a\u2400b");
  EXPECT_EQ(visible_text("bell \a, delete \x7f"), "bell \u2407, delete \u2421");
  EXPECT_EQ(visible_text("two\nlines\tand a tab"), "two\nlines\tand a tab");
}

// A name with U+202E turned the rest of the sentence that it stood in.
TEST(VisibleText, ShowsWhatTurnsTheDirectionOfText) {
  EXPECT_EQ(visible_text("\u202egnp.exe"), "[U+202E]gnp.exe");
  EXPECT_EQ(visible_text("\u202a\u2066\u2069"), "[U+202A][U+2066][U+2069]");
  EXPECT_EQ(visible_text("\u2013 \u2029 \u206a"), "\u2013 \u2029 \u206a");
}

TEST(VisibleText, LeavesLettersOfAnyLanguage) {
  for (const char* text : {"", "\u05e9\u05dc\u05d5\u05dd", "\u5173\u8282\u81c2", "m\u00fcller"}) {
    EXPECT_EQ(visible_text(text), text);
  }
  EXPECT_EQ(visible_text("\xe2"), "\xe2");  // cut in the middle
  EXPECT_EQ(visible_text("\xe2\x80"), "\xe2\x80");
}

}  // namespace
}  // namespace armcal
