// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/row_conditions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/core/utc_time.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

struct ReadConditions {
  ObservationGroup group;
  std::string complaint;
};

ReadConditions conditions_of(const std::string& csv) {
  ReadConditions read;
  Diagnostics diagnostics;
  const auto table = CsvTable::parse({"log.csv", csv, "UTF-8", ""}, {}, diagnostics);
  EXPECT_TRUE(table.has_value()) << diagnostics.to_text();
  if (table) read_conditions(*table, read.group, diagnostics);
  read.complaint = diagnostics.to_text();
  return read;
}

TEST(RowConditions, AreNoneWithoutTheirColumns) {
  const ReadConditions read = conditions_of("q1_deg,x_mm\n1,2\n3,4\n");
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.group.time_s.size(), 0);
  EXPECT_EQ(read.group.temperature_c.size(), 0);
}

TEST(RowConditions, ReadDatesOfAnyZoneWithFractions) {
  const ReadConditions read = conditions_of(
      "q1_deg,time,temperature_c\n1,2026-03-02T10:15:30.25+01:00,20.5\n2,2026-03-02 09:16,-3\n");
  EXPECT_EQ(read.complaint, "");
  ASSERT_EQ(read.group.time_s.size(), 2);
  EXPECT_TRUE(read.group.time_is_utc);
  EXPECT_EQ(fractional_utc_text(read.group.time_s(0)), "2026-03-02T09:15:30.250Z");
  EXPECT_EQ(fractional_utc_text(read.group.time_s(1)), "2026-03-02T09:16:00Z");
  EXPECT_EQ(read.group.temperature_c, Eigen::Vector2d(20.5, -3.0));
}

TEST(RowConditions, ReadPlainSeconds) {
  const ReadConditions read =
      conditions_of("q1_deg;Time [s];Temperature [°C]\n1;0,5;20,25\n2;1e3;21\n");
  EXPECT_EQ(read.complaint, "");
  EXPECT_FALSE(read.group.time_is_utc);
  EXPECT_EQ(read.group.time_s, Eigen::Vector2d(0.5, 1000.0));
  EXPECT_EQ(read.group.temperature_c, Eigen::Vector2d(20.25, 21.0));
}

TEST(RowConditions, TakeEmptyFieldsForRowsThatDoNotSay) {
  const ReadConditions read = conditions_of("q1_deg,time,temperature_c\n1,,20\n2,2026-03-02,n/a\n");
  EXPECT_EQ(read.complaint, "");
  EXPECT_TRUE(std::isnan(read.group.time_s(0)));
  EXPECT_EQ(read.group.time_s(1), static_cast<double>(*parse_utc_time("2026-03-02")));
  EXPECT_EQ(read.group.temperature_c(0), 20.0);
  EXPECT_TRUE(std::isnan(read.group.temperature_c(1)));
}

TEST(RowConditions, NameFieldsThatAreNoTime) {
  for (const char* bad : {"yesterday", "2026-02-30", "09:15:30", "2026-03-02T09:15:30.Z",
                          "2026-03-02T09:15.5", "2026-03-02T24:00:00"}) {
    const ReadConditions read =
        conditions_of(std::string("q1_deg,time\n1,2026-03-02\n2,") + bad + "\n3,2026-03-03\n");
    EXPECT_THAT(read.complaint,
                HasSubstr(std::string("log.csv:3:3: error: \"") + bad + "\" is no time"));
    EXPECT_THAT(read.complaint, HasSubstr("write dates as 2026-03-02T09:15:30Z"));
  }
}

TEST(RowConditions, RefuseDatesAndSecondsInOneColumn) {
  EXPECT_THAT(conditions_of("q1_deg,time\n1,2026-03-02\n2,17\n").complaint,
              HasSubstr("log.csv:3:3: error: dates and plain seconds stand in one column"));
}

TEST(RowConditions, RefuseTemperaturesInOtherUnits) {
  EXPECT_THAT(conditions_of("q1_deg,temperature_k\n1,293\n").complaint,
              HasSubstr("the temperature is in \"k\""));
  EXPECT_THAT(conditions_of("q1_deg,temperature_c\n1,293.15\n").complaint,
              HasSubstr("log.csv:2:3: error: a temperature of 293.15 deg C cannot be"));
  EXPECT_THAT(conditions_of("q1_deg,temperature_c\n1,warm\n").complaint,
              HasSubstr("temperature \"warm\" is not a number"));
}

}  // namespace
}  // namespace armcal
