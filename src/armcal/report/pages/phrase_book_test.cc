// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/phrase_book.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

constexpr const char* kUnder = "verification.phrase";

std::string in_chinese(const std::string& phrase) {
  return in_language(phrase, kUnder, Language::named("zh"));
}

TEST(PhraseBook, FindsPhrasesAgainWithTheirNamesAndNumbers) {
  EXPECT_EQ(in_chinese("probing form error"), "探测形状误差");
  EXPECT_EQ(in_chinese("24 points at position B, 25 are asked for"),
            "位置 B 有 24 个点，要求 25 个");
  EXPECT_EQ(in_chinese("1 point in fit 2, 9 are asked for"), "拟合 2 有 1 个点，要求 9 个");
  EXPECT_EQ(in_chinese("500 mm at P2, repeat 1"), "500 mm，位置 P2，第 1 次");
  EXPECT_EQ(in_chinese("single-point articulation, far zone, seat 3: 2 s"),
            "单点铰接，远区，锥窝 3：2 s");
}

// Of the patterns that match, the one with the most words of its own counts.
TEST(PhraseBook, PrefersTheMostSpecificPattern) {
  EXPECT_EQ(in_chinese("500 mm"), "500 mm");
  EXPECT_EQ(in_chinese("500 mm, repeat 2"), "500 mm，第 2 次");
  EXPECT_EQ(in_chinese("500 mm at x, y, repeat 2"), "500 mm，位置 x, y，第 2 次");
}

TEST(PhraseBook, LeavesWhatUsersWroteAsItIs) {
  for (const std::string text : {"", "my own test", "<script>alert(1)</script>", "position ",
                                 "{0} {1}", "\x01\x02", "mm at", "Position A"}) {
    EXPECT_EQ(in_chinese(text), text);
  }
  EXPECT_EQ(in_chinese("position <b>{0}</b>"), "位置 <b>{0}</b>");
}

// Documents are worded in English: there nothing changes, whatever a name holds.
TEST(PhraseBook, ChangesNothingInEnglish) {
  for (const std::string phrase :
       {"probing size error", "24 points at position B, 25 are asked for",
        "1 point at position at position A, 25 are asked for", "500 mm at P, repeat 2, repeat 1",
        "half range per axis, seat {1}"}) {
    EXPECT_EQ(in_language(phrase, kUnder, Language::named("en")), phrase);
  }
}

}  // namespace
}  // namespace armcal
