// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/spelling.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(EditDistance, CountsSlips) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("alpha", "alpha"), 0u);
  EXPECT_EQ(edit_distance("alhpa", "alpha"), 1u);  // swapped neighbours are one slip
  EXPECT_EQ(edit_distance("alpa", "alpha"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(DidYouMean, NamesTheNearest) {
  const std::vector<std::string> known = {"distance_mm", "radius_mm", "u_mm"};
  EXPECT_EQ(did_you_mean("distanse_mm", known), "did you mean \"distance_mm\"?");
  EXPECT_EQ(did_you_mean("radius", known), "known: distance_mm, radius_mm, u_mm");
  EXPECT_EQ(did_you_mean(std::string(100000, 'x'), known), "known: distance_mm, radius_mm, u_mm");
}

TEST(ShellWord, IsQuotedWhereItMustBe) {
  EXPECT_EQ(shell_word("out/r-1.html"), "out/r-1.html");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("my folder"), "'my folder'");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
}

TEST(Glob, MatchesAsAShellDoes) {
  EXPECT_TRUE(matches_glob("alpha3", "alpha*"));
  EXPECT_TRUE(matches_glob("alpha3", "*"));
  EXPECT_TRUE(matches_glob("b3", "?3"));
  EXPECT_TRUE(matches_glob("point.cone.x", "point.*.x"));
  EXPECT_FALSE(matches_glob("alpha3", "alpha"));
  EXPECT_FALSE(matches_glob("beta3", "alpha*"));
  EXPECT_FALSE(matches_glob("", "?"));
  EXPECT_TRUE(matches_glob("", "*"));
  EXPECT_TRUE(matches_glob("aXbXc", "*X*c"));
}

}  // namespace
}  // namespace armcal
