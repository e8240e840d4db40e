// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/utc_time.h"

#include <gtest/gtest.h>

#include "armcal/core/random.h"

namespace armcal {
namespace {

TEST(UtcTime, ReadsTheFormsThatPeopleType) {
  EXPECT_EQ(parse_utc_time("1970-01-01"), 0);
  EXPECT_EQ(parse_utc_time("2000-03-01T00:00:00Z"), 951868800);  // after a leap day
  EXPECT_EQ(parse_utc_time("2026-03-02T09:15"), parse_utc_time("2026-03-02 09:15:00Z"));
  EXPECT_EQ(parse_utc_time("2026-03-02T10:15+01:00"), parse_utc_time("2026-03-02T09:15Z"));
  EXPECT_EQ(parse_utc_time("2026-03-01T23:45-09:30"), parse_utc_time("2026-03-02T09:15Z"));
}

TEST(UtcTime, ReadsBackWhatItWrites) {
  RandomStream random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto time = static_cast<UtcSeconds>(random.below(253402300800));  // up to the year 9999
    EXPECT_EQ(parse_utc_time(utc_text(time)), time) << utc_text(time);
  }
  EXPECT_EQ(utc_text(951868801), "2000-03-01T00:00:01Z");
}

TEST(UtcTime, KnowsFractionsOfASecond) {
  EXPECT_EQ(parse_fractional_utc_time("1970-01-01T00:00:01.5Z"), 1.5);
  EXPECT_EQ(parse_fractional_utc_time("1970-01-01 01:00:01,125+01:00"), 1.125);
  EXPECT_EQ(parse_fractional_utc_time("1970-01-02"), 86400.0);
  for (const char* text : {"1970-01-01T00:00:01.Z", "1970-01-01T00:00.5Z",
                           "1970-01-01T00:00:01.5.5", "1970-01-01T00:00:01.x"}) {
    EXPECT_FALSE(parse_fractional_utc_time(text).has_value()) << text;
  }
  EXPECT_EQ(fractional_utc_text(1.5), "1970-01-01T00:00:01.500Z");
  EXPECT_EQ(fractional_utc_text(1.9999), "1970-01-01T00:00:02Z");
}

TEST(UtcTime, RefusesWhatIsNone) {
  for (const char* text : {"", "today", "2026-13-01", "2026-02-30", "2026-3-2", "02.03.2026",
                           "2026-03-02T", "1969-12-31", "2026-03-02T24:00", "2026-03-02T09:60",
                           "2026-03-02T9:15", "2026-03-02T09:15:61", "2026-03-02T09:15 CET",
                           "2026-03-02T09:15+1", "2026-03-02T09:15Z ", "1970-01-01T00:00+01:00"}) {
    EXPECT_FALSE(parse_utc_time(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace armcal
