// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_values.h"

#include "armcal/report/number_format.h"

namespace armcal {

std::optional<double> symmetric_amount(const DocumentView& entry, const std::string& key) {
  for (const char* unit : {"_mm", "_deg"}) {
    if (const auto value = entry.number_if(key + unit)) return value;
  }
  return std::nullopt;
}

std::string amount_text(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : "\u2013";
}

int decimals_of_reading(const DocumentView& reading) {
  return decimals_for_uncertainty(reading.number("u"));
}

bool is_checked_reading(const DocumentView& reading) { return reading.has("normalised"); }

bool is_flagged_reading(const DocumentView& reading) {
  return reading.has("flagged") && reading.flag("flagged");
}

}  // namespace armcal
