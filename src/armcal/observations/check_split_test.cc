// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/check_split.h"

#include <gtest/gtest.h>

#include <set>

namespace armcal {
namespace {

ObservationGroup group_of(ReferenceKind kind, int rows, int places) {
  ObservationGroup group;
  group.kind = kind;
  for (int row = 0; row < rows; ++row) {
    group.lines.push_back(row + 2);
    group.is_check.push_back(false);
    group.place.push_back("P" + std::to_string(row % places));
    if (kind == ReferenceKind::length) group.place_to.push_back("Q");
  }
  return group;
}

std::ptrdiff_t held_out(const ObservationGroup& group) {
  return std::count(group.is_check.begin(), group.is_check.end(), true);
}

TEST(HoldingOut, TakesTheShareOfRowsThatWasAskedFor) {
  std::vector<ObservationGroup> groups = {group_of(ReferenceKind::reference_points, 200, 1)};
  hold_out(groups, 0.3, 1);
  EXPECT_EQ(held_out(groups[0]), 60);
}

TEST(HoldingOut, TakesWholePointsWhereThereAreEnough) {
  std::vector<ObservationGroup> groups = {group_of(ReferenceKind::fixed_point, 60, 6)};
  hold_out(groups, 0.34, 1);
  EXPECT_EQ(held_out(groups[0]), 20);
  std::set<std::string> out;
  std::set<std::string> in;
  for (std::size_t row = 0; row < 60; ++row) {
    (groups[0].is_check[row] ? out : in).insert(groups[0].place[row]);
  }
  EXPECT_EQ(out.size(), 2u);
  for (const std::string& place : out) EXPECT_FALSE(in.contains(place));
}

TEST(HoldingOut, TakesRowsOfFewPointsAndNoLengths) {
  std::vector<ObservationGroup> groups = {group_of(ReferenceKind::fixed_point, 60, 2),
                                          group_of(ReferenceKind::length, 4, 1)};
  hold_out(groups, 0.5, 1);
  EXPECT_EQ(held_out(groups[0]), 30);
  EXPECT_EQ(held_out(groups[1]), 0);
}

TEST(HoldingOut, LeavesEveryLengthItsEnds) {
  std::vector<ObservationGroup> groups = {group_of(ReferenceKind::fixed_point, 60, 6),
                                          group_of(ReferenceKind::length, 1, 1)};
  hold_out(groups, 0.5, 1);
  EXPECT_EQ(held_out(groups[0]), 30);
  std::set<std::string> in;
  for (std::size_t row = 0; row < 60; ++row) {
    if (!groups[0].is_check[row]) in.insert(groups[0].place[row]);
  }
  EXPECT_EQ(in.size(), 6u);
}

TEST(HoldingOut, IsTheSameForTheSameSeedOnly) {
  std::vector<ObservationGroup> one = {group_of(ReferenceKind::reference_points, 100, 1)};
  auto same = one;
  auto other = one;
  hold_out(one, 0.5, 7);
  hold_out(same, 0.5, 7);
  hold_out(other, 0.5, 8);
  EXPECT_EQ(one[0].is_check, same[0].is_check);
  EXPECT_NE(one[0].is_check, other[0].is_check);
}

}  // namespace
}  // namespace armcal
