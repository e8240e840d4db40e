// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/csv_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TextFile csv_file(std::string text) { return {"readings.csv", std::move(text), "UTF-8", ""}; }

CsvTable parsed(const std::string& text, const ColumnMap& map = {}) {
  Diagnostics diagnostics;
  auto table = CsvTable::parse(csv_file(text), map, diagnostics);
  EXPECT_TRUE(table.has_value()) << text << "\n" << diagnostics.to_text();
  return table.value_or(CsvTable{});
}

std::string complaint_about_table(const std::string& text, const ColumnMap& map = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CsvTable::parse(csv_file(text), map, diagnostics).has_value());
  return diagnostics.to_text();
}

std::vector<double> column(const CsvTable& table, std::string_view name) {
  Diagnostics diagnostics;
  auto numbers = table.numbers(table.find(name).value(), name, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.to_text();
  return numbers;
}

TEST(CsvTable, ReadsTheSameNumbersInEveryDialect) {
  for (const char* text : {
           "x_mm,y_mm\n1.5,2\n-3,4.25\n",
           "x_mm;y_mm\r\n1.5;2\r\n-3;4.25\r\n",
           "x_mm\ty_mm\n1.5\t2\n-3\t4.25\n",
           "x_mm y_mm\n1.5 2\n-3   4.25\n",
           "x_mm;y_mm\n1,5;2\n-3;4,25",
           "x_mm y_mm\n1,5 2,0\n-3,0 4,25\n",
           "x_mm\ty_mm\n1,5\t2\n-3\t4,25\n",
           "# a comment\n\nX [mm], Y [mm]\n1.5, 2\n# another\n-3, 4.25\n\n",
           "\"x_mm\",\"y_mm\"\n\"1.5\",\"2\"\n-3,4.25\n",
           "x,y\nmm,mm\n1.5,2\n-3,4.25\n",
           "x;y\n[mm];[mm]\n1,5;2\n-3;4,25\n",
           "x_mm;y_mm;\n1.5;2;\n-3;4.25;\n",
           "x_mm,y_mm\r1.5,2\r-3,4.25\r",
       }) {
    const CsvTable table = parsed(text);
    EXPECT_THAT(column(table, "x"), ElementsAre(1.5, -3.0)) << text;
    EXPECT_THAT(column(table, "y"), ElementsAre(2.0, 4.25)) << text;
    EXPECT_EQ(table.columns()[0].unit, "mm") << text;
  }
}

TEST(CsvTable, TakesNamesAndUnitsApart) {
  const CsvTable table = parsed(
      "q1_deg,Q2 [rad],temperature (\xC2\xB0"
      "C),u_mm,setup,point_name\n1,2,3,4,a,b\n");
  const auto& columns = table.columns();
  EXPECT_EQ(columns[0].name, "q1");
  EXPECT_EQ(columns[0].unit, "deg");
  EXPECT_EQ(columns[1].name, "q2");
  EXPECT_EQ(columns[1].unit, "rad");
  EXPECT_EQ(columns[2].name, "temperature");
  EXPECT_EQ(columns[3].name, "u");
  EXPECT_EQ(columns[4].name, "setup");
  EXPECT_EQ(columns[5].name, "point_name");
  EXPECT_EQ(columns[5].unit, "");
}

TEST(CsvTable, MapsForeignNamesAndNumbers) {
  const CsvTable renamed =
      parsed("shoulder;elbow\n0,5;1,5\n", {{"q1_rad", "shoulder"}, {"q2_rad", "Elbow"}});
  EXPECT_THAT(column(renamed, "q1"), ElementsAre(0.5));
  EXPECT_EQ(renamed.columns()[1].unit, "rad");
  const CsvTable numbered = parsed("0.5,1.5\n2,3\n", {{"x_mm", "2"}});
  EXPECT_FALSE(numbered.has_header());
  EXPECT_THAT(column(numbered, "x"), ElementsAre(1.5, 3.0));
}

TEST(CsvTable, NamesLineAndColumnOfABadNumber) {
  Diagnostics diagnostics;
  const auto table = CsvTable::parse(csv_file("q1_deg,q4_deg\n# note\n1,2\n3,12.3.4\n5,\n7,NaN\n"),
                                     {}, diagnostics);
  const auto values = table->numbers(1, "joint 4 angle", diagnostics);
  EXPECT_EQ(values[0], 2.0);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(diagnostics.to_text(),
            "readings.csv:4:3: error: joint 4 angle \"12.3.4\" is not a number\n"
            "readings.csv:5:3: error: joint 4 angle is missing\n"
            "  help: delete the row, or write the value that was read\n"
            "readings.csv:6:3: error: joint 4 angle is missing (\"NaN\")\n"
            "  help: delete the row, or write the value that was read\n");
}

TEST(CsvTable, SaysWhatIsWrongWithTheTable) {
  EXPECT_THAT(complaint_about_table("# nothing\n\n"),
              HasSubstr("readings.csv: error: has no rows"));
  EXPECT_THAT(complaint_about_table("x_mm,y_mm\n"), HasSubstr("has a header but no rows below it"));
  EXPECT_THAT(complaint_about_table("x_mm,y_mm\n1,2\n3\n4,5\n"),
              HasSubstr("readings.csv:3: error: has 1 field, the first row has 2"));
  EXPECT_THAT(complaint_about_table("x_mm,y_mm\n1,2\n3"),
              HasSubstr("help: is the file cut off at its end?"));
  EXPECT_THAT(complaint_about_table("x_mm,y_mm\n\"1,2\n"),
              HasSubstr("readings.csv:2:1: error: quotation mark is never closed"));
  EXPECT_THAT(complaint_about_table("x_mm,X [mm]\n1,2\n"),
              HasSubstr("column x_mm (number 1) and column X [mm] (number 2) are both \"x\""));
  EXPECT_THAT(complaint_about_table("x_mm,y\nm,m\n1,2\n"),
              HasSubstr("the row of units says m but the header says x_mm"));
  EXPECT_THAT(complaint_about_table("shoulder,elbow\n1,2\n", {{"q1_deg", "sholder"}}),
              HasSubstr("did you mean \"shoulder\"?"));
  EXPECT_THAT(complaint_about_table("1,2\n3,4\n", {{"q1_deg", "7"}}),
              HasSubstr("give a column number from 1 to 2"));
}

TEST(CsvTable, TellsAllProblemsAtOnce) {
  const std::string text = complaint_about_table("x_mm,y_mm\n1\n2\n3,4\n5\n");
  EXPECT_THAT(text, HasSubstr("readings.csv:2:"));
  EXPECT_THAT(text, HasSubstr("readings.csv:3:"));
  EXPECT_THAT(text, HasSubstr("readings.csv:5:"));
}

TEST(CsvTable, GivesUpOnNonsenseEarly) {
  std::string text = "a,b\n";
  for (int i = 0; i < 100000; ++i) text += "1\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(CsvTable::parse(csv_file(text), {}, diagnostics).has_value());
  EXPECT_LE(diagnostics.error_count(), 1000u);
}

RC_GTEST_PROP(CsvTable, SurvivesAnyText, (const std::string& text)) {
  Diagnostics diagnostics;
  const auto table = CsvTable::parse(csv_file(text), {}, diagnostics);
  RC_ASSERT(table.has_value() != diagnostics.has_errors());
  if (table) {
    for (std::size_t c = 0; c < table->columns().size(); ++c) {
      RC_ASSERT(table->numbers(c, "field", diagnostics).size() == table->row_count());
    }
  }
}

RC_GTEST_PROP(CsvTable, ReadsBackAnyNumbers, (const std::vector<std::pair<float, float>>& rows)) {
  RC_PRE(!rows.empty());
  std::string text = "x_mm;y_mm\n";
  for (const auto& [x, y] : rows) {
    RC_PRE(std::isfinite(x) && std::isfinite(y));
    text += std::to_string(x) + ";" + std::to_string(y) + "\n";
  }
  const CsvTable table = parsed(text);
  const auto xs = column(table, "x");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RC_ASSERT(xs[i] == std::stod(std::to_string(rows[i].first)));
  }
}

// Each of these was taken in silence, or told with half of the names.
TEST(CsvTable, TellsWhatTheMapContradicts) {
  EXPECT_THAT(complaint_about_table("A,B\n1,2\n", {{"x_mm", "A"}, {"y_mm", "A"}}),
              HasSubstr("--map takes column A twice: as x_mm and as y_mm"));
  EXPECT_THAT(complaint_about_table("q1_deg,q1_rad\n1,2\n"),
              HasSubstr("column q1_deg (number 1) and column q1_rad (number 2) are both \"q1\""));
  Diagnostics diagnostics;
  ASSERT_TRUE(CsvTable::parse({"p.csv", "q1_deg,q2_deg\n1,2\n", "UTF-8", ""},
                              {{"q1_rad", "q1_deg"}}, diagnostics));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("warning: column q1_deg is read in rad as --map asks, against its name"));
}

TEST(CsvTable, AMapForSeveralFilesSkipsWhatThisOneDoesNotHave) {
  Diagnostics diagnostics;
  const auto table =
      CsvTable::parse({"p.csv", "X,y_mm\n1,2\n", "UTF-8", ""}, {{"x_mm", "X"}, {"y_mm", "Y"}},
                      diagnostics, {}, UnmatchedMap::skip);
  ASSERT_TRUE(table.has_value()) << diagnostics.to_text();
  EXPECT_EQ(table->find("x"), 0u);
  EXPECT_EQ(table->unmatched(), std::vector<std::string>{"y_mm"});
}

}  // namespace
}  // namespace armcal
