// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/quiet_place.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

const DrawnBox kBoxes[] = {{0, 0, 20, 10}, {30, 0, 50, 10}, {60, 0, 80, 10}};

TEST(QuietPlaces, TheFirstOfThoseWithoutDataIsTaken) {
  QuietPlaces places;
  places.add_point(5.0, 5.0);
  EXPECT_EQ(places.choose(kBoxes), 1u);
}

TEST(QuietPlaces, APlaceIsTakenOnce) {
  QuietPlaces places;
  places.add_line(60.0, 5.0, 80.0, 5.0);
  EXPECT_EQ(places.choose(kBoxes), 0u);
  EXPECT_EQ(places.choose(kBoxes), 1u);
  EXPECT_EQ(places.choose(kBoxes), 2u);  // data are better covered than words
}

}  // namespace
}  // namespace armcal
