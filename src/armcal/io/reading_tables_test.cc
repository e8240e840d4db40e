// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/reading_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

CsvTable table_of(const std::string& text, const ColumnMap& map = {}) {
  Diagnostics diagnostics;
  auto table = CsvTable::parse({"readings.csv", text, "UTF-8", ""}, map, diagnostics);
  EXPECT_TRUE(table.has_value()) << diagnostics.to_text();
  return table.value_or(CsvTable{});
}

std::string joint_complaint(const std::string& text, const TableOptions& options = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(joint_readings(table_of(text, options.map), 2, options, diagnostics).has_value());
  return diagnostics.to_text();
}

std::string point_complaint(const std::string& text, const TableOptions& options = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(point_readings(table_of(text, options.map), options, diagnostics).has_value());
  return diagnostics.to_text();
}

TEST(JointReadings, ConvertsToRadians) {
  for (const char* text :
       {"q1_deg,q2_deg\n90,-180\n", "q1,q2\ndeg,deg\n90,-180\n", "Q2 [deg];Q1 [deg]\n-180;90\n"}) {
    Diagnostics diagnostics;
    const auto readings = joint_readings(table_of(text), 2, {}, diagnostics);
    ASSERT_TRUE(readings.has_value()) << diagnostics.to_text();
    EXPECT_DOUBLE_EQ(readings->encoder_rad(0, 0), pi / 2);
    EXPECT_DOUBLE_EQ(readings->encoder_rad(1, 0), -pi);
  }
  Diagnostics diagnostics;
  const auto radians = joint_readings(table_of("q1_rad,q2_rad\n1.5,-3\n2,1\n"), 2, {}, diagnostics);
  EXPECT_EQ(radians->posture(1)[0], 2.0);
  EXPECT_EQ(radians->lines[1], 3);
}

TEST(JointReadings, TakesAHeaderlessTableWhenTheUnitIsTold) {
  TableOptions options;
  options.angles = AngleUnit::rad;
  Diagnostics diagnostics;
  const auto readings = joint_readings(table_of("0.5,1.5\n"), 2, options, diagnostics);
  ASSERT_TRUE(readings.has_value());
  EXPECT_EQ(readings->encoder_rad(1, 0), 1.5);
  EXPECT_THAT(joint_complaint("0.5,1.5\n"), HasSubstr("give --angles deg or --angles rad"));
  EXPECT_THAT(joint_complaint("0.5,1.5,2.5\n", options),
              HasSubstr("has no header and 3 columns, the arm has 2 joints"));
}

TEST(JointReadings, IsStrictWhereAMistakeWouldBeSilent) {
  EXPECT_THAT(
      joint_complaint("q1_rad,q2_rad\n1,2\n3,45.5\n"),
      HasSubstr(
          "readings.csv:3:3: error: joint 2 angle 45.5 looks like degrees but the column is in "
          "radians\n  help: give --angles deg"));
  EXPECT_THAT(joint_complaint("q1_deg,q2_deg\n1,20000\n"),
              HasSubstr("joint 2 angle 20000 deg is more than two turns"));
  EXPECT_THAT(joint_complaint("q1_deg\n1\n"),
              HasSubstr("readings.csv: error: has no column q2_deg\n  help: its columns: q1_deg; "
                        "name the right one "
                        "with --map q2_deg=HEADER"));
  EXPECT_THAT(joint_complaint("q1_deg,q2_deg,q3_deg\n1,2,3\n"),
              HasSubstr("has a column q3 but the arm has 2 joints"));
  EXPECT_THAT(joint_complaint("q1,q2\n1,2\n"), HasSubstr("column q1 has no unit"));
  EXPECT_THAT(joint_complaint("q1_mm,q2_mm\n1,2\n"), HasSubstr("mm is no unit of angle"));
  EXPECT_THAT(joint_complaint("q1_deg,q2_deg\n1,nan\n"),
              HasSubstr("joint 2 angle is missing (\"nan\")"));
}

TEST(JointReadings, WarnsOfWhatLooksLikeRadians) {
  std::string text = "q1_deg,q2_deg\n";
  for (int i = 0; i < 12; ++i) text += "1.2,-3.0" + std::to_string(i) + "\n";
  Diagnostics diagnostics;
  EXPECT_TRUE(joint_readings(table_of(text), 2, {}, diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("warning: all angles lie within +-6.3 degrees: are they radians?"));
}

TEST(JointReadings, WarnsWhenTheUserOverrulesTheHeader) {
  TableOptions options;
  options.angles = AngleUnit::deg;
  Diagnostics diagnostics;
  const auto readings = joint_readings(table_of("q1_rad,q2_deg\n90,90\n"), 2, options, diagnostics);
  EXPECT_DOUBLE_EQ(readings->encoder_rad(0, 0), pi / 2);
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("column q1_rad is read in degrees as you asked, against its name"));
}

TEST(PointReadings, TakesLengthsInTheUnitsOfTheTrade) {
  Diagnostics diagnostics;
  const auto points = point_readings(table_of("x_mm,y_m,z_in\n1,2,3\n"), {}, diagnostics);
  ASSERT_TRUE(points.has_value());
  EXPECT_TRUE(points->points_mm[0].isApprox(Eigen::Vector3d(1, 2000, 76.2)));
  EXPECT_FALSE(points->planar);
  const auto planar = point_readings(table_of("x_mm,y_mm\n1,2\n"), {}, diagnostics);
  EXPECT_TRUE(planar->planar);
  EXPECT_EQ(planar->points_mm[0].z(), 0.0);
}

TEST(PointReadings, TakesTwoOrThreeNamelessColumnsAsMillimetres) {
  Diagnostics diagnostics;
  const auto points = point_readings(table_of("1 2 3\n4 5 6\n"), {}, diagnostics);
  ASSERT_TRUE(points.has_value());
  EXPECT_EQ(points->points_mm[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("has no header: its 3 columns are taken as x_mm,y_mm,z_mm"));
}

TEST(PointReadings, IsStrictWhereAMistakeWouldBeSilent) {
  EXPECT_THAT(point_complaint("x_mm,y_mm,z_mm\n1,2,3\n4,5,6\n1,2,3\n"),
              HasSubstr("readings.csv:4: error: repeats the point of line 2\n  help: delete it, or "
                        "give --keep-duplicates"));
  EXPECT_THAT(point_complaint("x_mm,y_mm,z_mm\n1,2,3\n0,0,0\n"),
              HasSubstr("readings.csv:3: error: the point 0 0 0 looks like a missing one"));
  EXPECT_THAT(point_complaint("x,y,z\n1,2,3\n"),
              HasSubstr("column x has no unit\n  help: name it x_mm, or give --map x_mm=x"));
  EXPECT_THAT(point_complaint("x_mm,z_mm\n1,2\n"), HasSubstr("has no column y_mm"));
  EXPECT_THAT(point_complaint("x_deg,y_mm\n1,2\n"), HasSubstr("deg is no unit of length"));
  TableOptions keep;
  keep.keep_duplicates = keep.keep_zero_points = true;
  Diagnostics diagnostics;
  EXPECT_TRUE(
      point_readings(table_of("x_mm,y_mm,z_mm\n0,0,0\n0,0,0\n"), keep, diagnostics).has_value());
}

TEST(SymmetricPoints, ReadsEndsSettingsAndAngles) {
  SymmetricReading reading;
  reading.kind = SymmetricKind::reversal;
  reading.joint = 2;
  Diagnostics diagnostics;
  const auto raw =
      symmetric_points(table_of("end,x_mm,y_mm,z_mm,q1_deg,q2_deg\nA,1,2,3,10,0\nB,4,5,6,10,180\n"),
                       reading, 2, {}, diagnostics);
  ASSERT_TRUE(raw.has_value()) << diagnostics.to_text();
  EXPECT_EQ(raw->end, (std::vector<char>{'A', 'B'}));
  EXPECT_EQ(raw->encoder_rad.cols(), 2);
  EXPECT_DOUBLE_EQ(raw->encoder_rad(1, 1), pi);

  reading.kind = SymmetricKind::zero_search;
  const auto search =
      symmetric_points(table_of("q2_deg,x_mm,y_mm,z_mm\n90,1,2,3\n"), reading, 2, {}, diagnostics);
  ASSERT_TRUE(search.has_value()) << diagnostics.to_text();
  EXPECT_DOUBLE_EQ(search->setting_rad[0], pi / 2);
}

TEST(SymmetricPoints, SaysWhatIsMissing) {
  SymmetricReading reading;
  reading.kind = SymmetricKind::reversal;
  reading.joint = 2;
  Diagnostics diagnostics;
  EXPECT_FALSE(symmetric_points(table_of("x_mm,y_mm,z_mm\n1,2,3\n"), reading, 2, {}, diagnostics)
                   .has_value());
  EXPECT_FALSE(
      symmetric_points(table_of("end,x_mm,y_mm,z_mm\nC,1,2,3\n"), reading, 2, {}, diagnostics)
          .has_value());
  reading.kind = SymmetricKind::zero_search;
  EXPECT_FALSE(symmetric_points(table_of("x_mm,y_mm,z_mm\n1,2,3\n"), reading, 2, {}, diagnostics)
                   .has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("has no column end"));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("readings.csv:2:1: error: end \"C\" is neither A nor B"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("has no column q2_deg"));
}

TEST(JointReadings, ReadsRealFilesWithTheirWarts) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  // Semicolons, decimal commas, foreign names, other columns.
  Diagnostics diagnostics;
  TableOptions options;
  options.map = {{"q1_rad", "shoulder_pan_joint"}, {"q2_rad", "shoulder_lift_joint"},
                 {"q3_rad", "elbow_joint"},        {"q4_rad", "wrist_1_joint"},
                 {"q5_rad", "wrist_2_joint"},      {"q6_rad", "wrist_3_joint"},
                 {"x_mm", "measurement_x"},        {"y_mm", "measurement_y"},
                 {"z_mm", "measurement_z"}};
  auto file = read_text_file(
      (testing::reference_data() / "real/ipa_ur10_tmac/series_b_joint_configurations.csv").string(),
      kLargestTable_bytes, diagnostics);
  ASSERT_TRUE(file.has_value());
  const auto table = CsvTable::parse(std::move(*file), options.map, diagnostics);
  ASSERT_TRUE(table.has_value()) << diagnostics.to_text();
  EXPECT_EQ(table->row_count(), 1495u);
  const auto joints = joint_readings(*table, 6, options, diagnostics);
  ASSERT_TRUE(joints.has_value()) << diagnostics.to_text();
  EXPECT_DOUBLE_EQ(joints->encoder_rad(0, 1), -0.908775);
  // Two points of this file stand there twice, to the last digit: that must not pass unseen.
  EXPECT_FALSE(point_readings(*table, options, diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr(".csv:534: error: repeats the point of line 533"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr(".csv:1065: error: repeats the point of line 1064"));
  options.keep_duplicates = true;
  const auto points = point_readings(*table, options, diagnostics);
  ASSERT_TRUE(points.has_value());
  EXPECT_DOUBLE_EQ(points->points_mm[0].x(), 383.76294);
}

// Rows copied by mistake were averaged as if they had been measured.
TEST(ReadingTables, EqualRowsOfAnglesAndOfRawPointsAreRefusedUnlessKept) {
  const char* angles = "q1_deg,q2_deg,clock\n1,2,10:00\n1,2,10:01\n1,2,10:01\n";
  const char* ends = "end,x_mm,y_mm,z_mm\nA,1,2,3\nB,1,2,3\nA,1,2,3\n";
  SymmetricReading reversal;
  for (const bool keep : {false, true}) {
    TableOptions options;
    options.keep_duplicates = keep;
    Diagnostics diagnostics;
    EXPECT_EQ(joint_readings(table_of(angles), 2, options, diagnostics).has_value(), keep);
    EXPECT_EQ(symmetric_points(table_of(ends), reversal, 2, options, diagnostics).has_value(),
              keep);
    if (keep) continue;
    EXPECT_EQ(diagnostics.error_count(), 2u);
    EXPECT_THAT(diagnostics.to_text(), HasSubstr(":4: error: is the same as line 3"));
    EXPECT_THAT(diagnostics.to_text(), HasSubstr(":4: error: is the same as line 2"));
  }
}

// One table for all half turns of a plan: forty files are nobody's idea of a worksheet.
TEST(ReadingTables, SeveralReadingsShareATable) {
  const CsvTable shared =
      table_of("reading,end,x_mm,y_mm,z_mm\nh1,A,1,2,3\nh2,A,4,5,6\nh1,B,7,8,9\n");
  Diagnostics diagnostics;
  const auto first = rows_of_reading(shared, "h1", diagnostics);
  ASSERT_TRUE(first.has_value());
  SymmetricReading reversal;
  const auto raw = symmetric_points(*first, reversal, 2, {}, diagnostics);
  ASSERT_TRUE(raw.has_value()) << diagnostics.to_text();
  ASSERT_EQ(raw->points_mm.size(), 2u);
  EXPECT_EQ(raw->points_mm[1].z(), 9.0);
  EXPECT_EQ(raw->lines, (std::vector<int>{2, 4}));  // as in the file
  EXPECT_FALSE(rows_of_reading(shared, "h3", diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("has no rows of reading \"h3\""));
  const CsvTable own = table_of("end,x_mm,y_mm,z_mm\nA,1,2,3\nB,7,8,9\n");
  EXPECT_EQ(rows_of_reading(own, "h3", diagnostics)->row_count(), 2u);
}

}  // namespace
}  // namespace armcal
