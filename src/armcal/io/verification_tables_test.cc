// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/verification_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ReadTable {
  std::optional<VerificationRows> rows;
  std::string text;
};

StatedArtefact bar() {
  StatedArtefact artefact;
  artefact.name = "bar";
  artefact.is_sphere = false;
  artefact.lengths = {{"short", 500.0012, 0.0006}, {"long", 1000.0031, 0.0011}};
  return artefact;
}

ReadTable read_table(StatedTestKind kind, const std::string& csv, int joint_count = 0,
                     const StatedArtefact& artefact = bar()) {
  Diagnostics diagnostics;
  const auto table = CsvTable::parse({"rows.csv", csv, "UTF-8", ""}, {}, diagnostics);
  EXPECT_TRUE(table) << diagnostics.to_text();
  StatedTest test;
  test.kind = kind;
  test.name = "mine";
  auto rows = verification_rows(*table, test, &artefact, joint_count, diagnostics);
  EXPECT_EQ(rows.has_value(), !diagnostics.has_errors());
  return {std::move(rows), diagnostics.to_text()};
}

TEST(VerificationTables, TakeCoordinatesWithTheirPlaces) {
  const auto [rows, text] =
      read_table(StatedTestKind::probing, "position,x_mm,y_mm,z_mm\nnear,1,2,3\nfar,4,5,6\n");
  ASSERT_TRUE(rows) << text;
  EXPECT_THAT(rows->place, ElementsAre("near", "far"));
  EXPECT_EQ(rows->points_mm[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_THAT(rows->lines, ElementsAre(2, 3));
  EXPECT_FALSE(rows->has_angles());
}

TEST(VerificationTables, FindLengthsByNominalValueOrName) {
  const auto nominal =
      read_table(StatedTestKind::length_uni,
                 "placement,length_mm,measured_mm\n1,500,500.02\n2,1000,1000.01\n");
  ASSERT_TRUE(nominal.rows) << nominal.text;
  EXPECT_THAT(nominal.rows->length, ElementsAre(0U, 1U));
  EXPECT_THAT(nominal.rows->measured_mm, ElementsAre(500.02, 1000.01));
  const auto named = read_table(StatedTestKind::length_uni,
                                "placement,length,measured_mm\n1,long,1000.02\n2,short,500.01\n");
  ASSERT_TRUE(named.rows) << named.text;
  EXPECT_THAT(named.rows->length, ElementsAre(1U, 0U));
}

TEST(VerificationTables, PairEndsInAnySpelling) {
  const auto [rows, text] = read_table(StatedTestKind::length_bi,
                                       "length_mm,end,x_mm,y_mm,z_mm\n500,A,1,2,3\n500,b,4,5,6\n");
  ASSERT_TRUE(rows) << text;
  EXPECT_THAT(rows->end, ElementsAre('A', 'B'));
}

TEST(VerificationTables, TakeTheirRowsOfASharedTable) {
  const std::string shared = "test,x_mm,y_mm,z_mm\nmine,1,2,3\nother,4,5,6\nprobing,7,8,9\n";
  const auto [rows, text] = read_table(StatedTestKind::probing, shared);
  ASSERT_TRUE(rows) << text;
  EXPECT_THAT(rows->lines, ElementsAre(2, 4));
  EXPECT_THAT(read_table(StatedTestKind::half_range, "test,x_mm,y_mm,z_mm\nother,1,2,3\n").text,
              HasSubstr("rows.csv: error: has no rows of the test \"mine\"\n  help: its column "
                        "test holds: other"));
}

// A worksheet has the columns of every test; those that a test does not use are empty in its rows.
TEST(VerificationTables, TakeEmptyColumnsForThoseOfOtherTests) {
  const std::string head = "test,position,placement,repeat,length_mm,end,x_mm,y_mm,z_mm\n";
  const auto sphere = read_table(StatedTestKind::probing, head + "probing,near,,,,,1,2,3\n");
  ASSERT_TRUE(sphere.rows) << sphere.text;
  EXPECT_THAT(sphere.rows->place, ElementsAre("near"));
  EXPECT_TRUE(sphere.rows->repeat.empty());
  const auto lengths =
      read_table(StatedTestKind::volumetric_length, head +
                                                        "volumetric_length,,7,,500,A,1,2,3\n"
                                                        "probing,near,,,,,1,2,4\n"
                                                        "volumetric_length,,7,,500,B,4,5,6\n");
  ASSERT_TRUE(lengths.rows) << lengths.text;
  EXPECT_THAT(lengths.rows->place, ElementsAre("7", "7"));
  EXPECT_THAT(lengths.rows->end, ElementsAre('A', 'B'));
}

TEST(VerificationTables, NameWhatIsMissing) {
  EXPECT_THAT(read_table(StatedTestKind::articulated_location, "x_mm,y_mm,z_mm\n1,2,3\n").text,
              HasSubstr("has no column articulation"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "measured_mm\n500.1\n").text,
              HasSubstr("has no column length_mm"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length_mm,x_mm,y_mm,z_mm\n500,1,2,3\n").text,
              HasSubstr("has no column end"));
  EXPECT_THAT(read_table(StatedTestKind::probing, "x_mm,y_mm\n1,2\n").text,
              HasSubstr("has no column z_mm"));
  EXPECT_THAT(read_table(StatedTestKind::probing, "q1_deg,q2_deg\n1,2\n").text,
              HasSubstr("name the arm that turns them into tips"));
  EXPECT_THAT(read_table(StatedTestKind::probing, "x_mm,y_mm,z_mm\n1,2,3\n", 6).text,
              HasSubstr("holds coordinates, but the file names an arm"));
  EXPECT_THAT(
      read_table(StatedTestKind::probing, "position,x_mm,y_mm,z_mm\nA,1,2,3\n,4,5,6\n").text,
      HasSubstr("rows.csv:3:1: error: position is empty"));
}

TEST(VerificationTables, RefuseWrongLengthsEndsAndUnits) {
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length_mm,measured_mm\n750,750.1\n").text,
              HasSubstr("rows.csv:2:1: error: \"bar\" has no length near 750 mm"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length,measured_mm\nlng,750.1\n").text,
              HasSubstr("\"bar\" has no length \"lng\"\n  help: did you mean \"long\"?"));
  EXPECT_THAT(
      read_table(StatedTestKind::length_uni, "length_mm,end,x_mm,y_mm,z_mm\n500,C,1,2,3\n").text,
      HasSubstr("rows.csv:2:5: error: end \"C\" is neither A nor B"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length_in,measured_mm\n19.7,500\n").text,
              HasSubstr("column length_in is not in mm"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length_mm,measured_in\n500,19.7\n").text,
              HasSubstr("column measured_in is not in mm"));
  EXPECT_THAT(read_table(StatedTestKind::length_uni, "length_mm,measured_mm\n500,-500\n").text,
              HasSubstr("a measured length must be larger than 0"));
}

TEST(VerificationTables, ReadCertificatesOfLengths) {
  const auto lengths = [](const std::string& csv, std::string& text) {
    Diagnostics diagnostics;
    const auto table = CsvTable::parse({"bar.csv", csv, "UTF-8", ""}, {}, diagnostics);
    EXPECT_TRUE(table);
    auto result = certified_lengths(*table, diagnostics);
    text = diagnostics.to_text();
    return result;
  };
  std::string text;
  const auto read = lengths("name,length_mm,U_um\nshort,500.0012,0.6\nlong,1000.0031,1.1\n", text);
  ASSERT_TRUE(read) << text;
  EXPECT_EQ((*read)[1].name, "long");
  EXPECT_NEAR((*read)[1].U_mm, 0.0011, 1e-15);
  EXPECT_FALSE(lengths("name,length_mm\nshort,500\n", text));
  EXPECT_THAT(text, HasSubstr("has no column U_um"));
  EXPECT_FALSE(lengths("name,length_mm,U_um\na,500,1\na,-600,1\n", text));
  EXPECT_THAT(text, HasSubstr("bar.csv:3:1: error: the length \"a\" is there twice"));
  EXPECT_THAT(text, HasSubstr("a length must be larger than 0"));
}

}  // namespace
}  // namespace armcal
