// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string>

#include "armcal/io/reading_tables.h"
#include "armcal/io/text_encoding.h"

// Any bytes at all become readings of some kind or complaints.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armcal::DecodedText decoded =
      armcal::decode_text(std::string(reinterpret_cast<const char*>(data), size));
  armcal::Diagnostics diagnostics;
  const auto table = armcal::CsvTable::parse(
      {"fuzz", std::move(decoded.text), decoded.encoding, ""}, {}, diagnostics);
  if (table.has_value() == diagnostics.has_errors()) std::abort();
  if (!table) return 0;
  armcal::Diagnostics of_points;
  if (armcal::point_readings(*table, {}, of_points).has_value() == of_points.has_errors())
    std::abort();
  armcal::Diagnostics of_angles;
  armcal::TableOptions options;
  options.angles = armcal::AngleUnit::deg;
  if (armcal::joint_readings(*table, 3, options, of_angles).has_value() == of_angles.has_errors())
    std::abort();
  return 0;
}
