// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/dh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace armcal {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTable = R"(schema = "armcal.dh/1"
convention = "modified"
name = "two rows"

[base]
position_mm = [1.0, 2.0, 3.0]
orientation_deg = [0.0, 0.0, 90.0]

[[row]]
theta_deg = 0.0
d_mm = 333.0
a_mm = 0.0
alpha_deg = 0.0

[[row]]
theta_deg = 45.0
d_mm = 0.0
a_mm = 82.5
alpha_deg = -90.0

[tool]
position_mm = [0.0, 0.0, 107.0]
orientation_deg = [0.0, 0.0, 0.0]
)";

TEST(DhFile, WrittenAndReadAgainIsTheSameText) {
  Diagnostics diagnostics;
  const auto table = read_dh({"t.dh.toml", kTable, "UTF-8", ""}, diagnostics);
  ASSERT_TRUE(table.has_value()) << diagnostics.to_text();
  EXPECT_EQ(table->convention, DhConvention::modified);
  EXPECT_EQ(table->rows[1].a_mm, 82.5);
  EXPECT_EQ(table->last_from_tool.translation_mm.z(), 107.0);
  EXPECT_EQ(dh_text(*table), kTable);
}

TEST(DhFile, ReadsTheSpreadsheetForm) {
  Diagnostics diagnostics;
  const auto csv = CsvTable::parse(
      {"t.csv", "theta [deg];d [mm];a [mm];alpha [deg]\n0;127,3;0;90\n10;0;-612;0\n", "UTF-8", ""},
      {}, diagnostics);
  ASSERT_TRUE(csv.has_value());
  const auto table = dh_from_csv(*csv, DhConvention::classic, diagnostics);
  ASSERT_TRUE(table.has_value()) << diagnostics.to_text();
  EXPECT_EQ(table->rows[0].d_mm, 127.3);
  EXPECT_EQ(table->rows[0].alpha_rad, std::numbers::pi / 2);
  EXPECT_EQ(dh_csv_text(*table),
            "theta_deg,d_mm,a_mm,alpha_deg\n0.0,127.3,0.0,90.0\n10.0,0.0,-612.0,0.0\n");
}

// 90 rad is 14 turns and a bit: the poses were nonsense, and nothing said so.
TEST(DhFile, TellsDegreesInRadianColumnsAndRadiansInDegreeColumns) {
  Diagnostics diagnostics;
  const auto table = [&](const std::string& text) {
    const auto csv = CsvTable::parse({"t.csv", text, "UTF-8", ""}, {}, diagnostics);
    return dh_from_csv(csv.value(), DhConvention::classic, diagnostics).has_value();
  };
  EXPECT_FALSE(table("theta_rad,d_mm,a_mm,alpha_rad\n0,1,0,90\n0,0,2,0\n"));
  EXPECT_THAT(
      diagnostics.to_text(),
      HasSubstr("t.csv:2:7: error: alpha 90 looks like degrees but the column is in radians"));
  EXPECT_TRUE(table("theta_deg,d_mm,a_mm,alpha_deg\n0,1,0,1.5708\n0,0,2,0\n"));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("warning: the values of alpha_deg look like radians"));
  EXPECT_FALSE(table("theta_deg,d_mm,a_mm,alpha_deg\n0,1e9,0,90\n0,0,2,0\n"));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("t.csv:2:3: error: d is 1000000000 mm: longer than"));
}

TEST(DhFile, SaysWhatIsWrong) {
  const auto complaint = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_dh({"t.dh.toml", text, "UTF-8", ""}, diagnostics).has_value());
    return diagnostics.to_text();
  };
  EXPECT_THAT(
      complaint("schema='armcal.dh/1'\nconvention='craig'\n[[row]]\n[[row]]\n"),
      HasSubstr(
          "t.dh.toml:2:1: error: convention \"craig\" is neither \"classic\" nor \"modified\""));
  EXPECT_THAT(complaint("schema='armcal.dh/1'\nconvention='classic'\n[[row]]\n"),
              HasSubstr("has 1 row: an arm here has 2 to 10"));
  EXPECT_THAT(complaint("schema='armcal.dh/"
                        "1'\nconvention='classic'\n[[row]]\n[[row]]\n[tool]\nposition_mm=[1]\n"),
              HasSubstr("position_mm has 1 numbers: must have 3"));
  Diagnostics diagnostics;
  const auto csv =
      CsvTable::parse({"t.csv", "theta,d_mm,a_mm\n0,1,2\n0,1,2\n", "UTF-8", ""}, {}, diagnostics);
  EXPECT_FALSE(dh_from_csv(*csv, DhConvention::classic, diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("column theta needs a unit: theta_deg"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("has no column alpha_deg"));
}

}  // namespace
}  // namespace armcal
