// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/checked_number.h"

#include <fmt/format.h>

#include "armcal/io/plausibility.h"
#include "armcal/io/toml_value.h"

namespace armcal {

double positive_or(double otherwise, TomlSection& section, const char* key,
                   Diagnostics& diagnostics) {
  const auto value = section.number(key);
  if (value && !(*value > 0.0)) {
    diagnostics.error(section.where(key),
                      fmt::format("{} is {}: must be larger than 0", key, *value));
  }
  return value.value_or(otherwise);
}

double not_negative_or_zero(TomlSection& section, const char* key, Diagnostics& diagnostics) {
  const auto value = section.number(key);
  if (value && *value < 0.0) {
    diagnostics.error(section.where(key),
                      fmt::format("{} is {}: must not be negative", key, *value));
  }
  return value.value_or(0.0);
}

double required_length(TomlSection& section, const char* key, Diagnostics& diagnostics) {
  const auto value = section.required_number(key);
  if (!value) return 0.0;
  if (!(*value > 0.0)) {
    diagnostics.error(section.where(key),
                      fmt::format("{} is {}: must be larger than 0", key, *value));
  }
  return checked_length(*value, key, section.where(key), diagnostics);
}

}  // namespace armcal
