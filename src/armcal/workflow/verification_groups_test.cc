// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/verification_in_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::point_row;
using testing::sphere_rows;
using VerificationGroupsTest = testing::VerificationInFolder;

TEST_F(VerificationGroupsTest, RefusesASphereThatMoves) {
  folder_.write("art.csv", "position,articulation,x_mm,y_mm,z_mm\n" +
                               sphere_rows("A,1", {300, 0, 0}, 15.5, 5) +
                               sphere_rows("B,2", {400, 0, 0}, 15.5, 5));
  EXPECT_THAT(iso_complaint(R"([[test]]
kind = "articulated_location"
artefact = "ball"
file = "art.csv"
)"),
              HasSubstr("art.csv:7: error: position B after position A: the sphere must stand "
                        "still"));
}

// Distances of ends: single points, or the centres of spheres.
TEST_F(VerificationGroupsTest, TakesLengthsFromTheirEnds) {
  std::string rows = "placement,length_mm,end,x_mm,y_mm,z_mm\n";
  rows += point_row("seats,600,A", {100, 200, 300}) + point_row("seats,600,B", {700.02, 200, 300});
  rows += sphere_rows("balls,800,A", {50, -400, 80}, 15.5, 6);
  rows += sphere_rows("balls,800,B", {50, 399.99, 80}, 15.5, 6);
  folder_.write("ends.csv", rows);
  const Verification verification = asme(R"([[test]]
kind = "volumetric_length"
artefact = "bar"
file = "ends.csv"
)",
                                         true);
  const auto& parts = verification.statistics.front().judged().result.parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].value_mm, 0.02, testing::kExact_mm);
  EXPECT_NEAR(parts[1].value_mm, -0.01, testing::kExact_mm);
  EXPECT_THAT(parts[1].where, HasSubstr("ends.csv:4"));
}

// Opposite faces are touched by opposite sides of the probe.
TEST_F(VerificationGroupsTest, TakesTheProbeOffBidirectionalLengths) {
  const std::string test = R"([[test]]
kind = "length_bi"
artefact = "bar"
file = "ends.csv"
probe_diameter_mm = 6
)";
  folder_.write("ends.csv", "length_mm,end,x_mm,y_mm,z_mm\n" + point_row("600,A", {100, 0, 1}) +
                                point_row("600,B", {706.03, 0, 1}));
  const Verification verification = iso(test, true);
  EXPECT_NEAR(verification.statistics.front().judged().result.value_mm.value(), 0.03,
              testing::kExact_mm);
  folder_.write("ends.csv", "length_mm,end,x_mm,y_mm,z_mm\n" +
                                sphere_rows("600,A", {100, 0, 1}, 15.5, 5) +
                                point_row("600,B", {706.03, 0, 1}));
  EXPECT_THAT(iso_complaint(test, true),
              HasSubstr("a bidirectional length has one point at each end"));
}

TEST_F(VerificationGroupsTest, RefusesEndsThatAreNone) {
  const std::string head = "position,length_mm,repeat,end,x_mm,y_mm,z_mm\n";
  folder_.write("lengths.csv", head + point_row("P1,600,2,A", {100, 0, 1}));
  EXPECT_THAT(iso_complaint(testing::kLengthTest, true),
              HasSubstr("lengths.csv:2: error: end B of 600.0000 mm at position P1, repeat 2: is "
                        "missing"));
  folder_.write("lengths.csv", head + point_row("P1,600,2,A", {100, 0, 1}) +
                                   point_row("P1,600,2,A", {100, 0, 1.01}) +
                                   point_row("P1,600,2,B", {700, 0, 1}));
  EXPECT_THAT(iso_complaint(testing::kLengthTest, true), HasSubstr("has 2 points"));
}

}  // namespace
}  // namespace armcal
