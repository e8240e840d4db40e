// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/csv_text.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "armcal/io/csv_table.h"

namespace armcal {
namespace {

TEST(CsvText, WritesNumbersAsShortAsTheyAre) {
  EXPECT_EQ(length_field(352.968), "352.968");
  EXPECT_EQ(length_field(-0.0), "0");
  EXPECT_EQ(length_field(-1e-12), "0");
  EXPECT_EQ(length_field(1200.0), "1200");
  EXPECT_EQ(angle_field(-std::numbers::pi / 2.0), "-90");
  EXPECT_EQ(angle_field(1e-9), "0.0000000573");
}

TEST(CsvText, WritesNamesThatATableReadsBack) {
  for (const std::string name : {"A", "seat, left", " blank ", "#1", "Kegel ä"}) {
    Diagnostics diagnostics;
    const std::string csv =
        "point,q1_deg\n" + text_field(name) + ",1\n" + text_field(name) + ",2\n";
    const auto table = CsvTable::parse({"t.csv", csv, "UTF-8", ""}, {}, diagnostics);
    ASSERT_TRUE(table.has_value()) << diagnostics.to_text();
    ASSERT_EQ(table->row_count(), 2u) << csv;
    EXPECT_EQ(table->field(0, 0), name);
  }
}

TEST(CsvText, RefusesNamesThatNoTableCanHold) {
  for (const std::string name : {"a\"b", "a;b", "a\nb", "a\tb"}) {
    EXPECT_THROW(static_cast<void>(text_field(name)), std::invalid_argument) << name;
  }
}

}  // namespace
}  // namespace armcal
