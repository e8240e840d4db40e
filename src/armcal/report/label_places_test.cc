// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/label_places.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

struct Extent {
  double left, top, right, bottom;
};

Extent extent_of(const PlacedLabel& label) {
  const double bottom = label.y + 0.2 * kLabelHeight;
  return {label.x, bottom - kLabelHeight,
          label.x + kLabelCharacter * static_cast<double>(label.text.size()), bottom};
}

TEST(LabelPlaces, LabelsOfOnePointCoverNeitherEachOtherNorThePoint) {
  LabelPlaces places(400.0, 400.0);
  places.reserve(200.0, 200.0, 4.0);
  std::vector<Extent> extents = {{196.0, 196.0, 204.0, 204.0}};
  for (int i = 0; i < 12; ++i) {
    const Extent placed = extent_of(places.place("label", 200.0, 200.0));
    for (const Extent& other : extents) {
      EXPECT_TRUE(placed.right <= other.left || other.right <= placed.left ||
                  placed.bottom <= other.top || other.bottom <= placed.top)
          << i;
    }
    extents.push_back(placed);
  }
}

TEST(LabelPlaces, LabelsStayInTheDrawing) {
  LabelPlaces places(400.0, 400.0);
  for (const double x : {0.0, 400.0}) {
    for (const double y : {0.0, 400.0}) {
      const Extent placed = extent_of(places.place("corner", x, y));
      EXPECT_GE(placed.left, 0.0);
      EXPECT_GE(placed.top, 0.0);
      EXPECT_LE(placed.right, 400.0);
      EXPECT_LE(placed.bottom, 400.0);
    }
  }
}

}  // namespace
}  // namespace armcal
