// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/room_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/io/number_text.h"

namespace armcal::cli {

std::vector<Argument> RoomFlags::arguments(const std::string& volume_help) {
  return {{"--volume", volume_help, &volume, "X1,X2,Y1,Y2,Z1,Z2"},
          {"--column-radius", "the arm's own column about the first axis, mm", &column_radius_mm,
           "MM", NumberRange::not_negative},
          {"--column-top", "height to which it reaches, from the origin of joint 1, mm",
           &column_top_mm, "MM"},
          {"--bench", "height of the bench, from the origin of joint 1, mm (default: none)",
           &bench_mm, "MM"}};
}

Surroundings RoomFlags::surroundings() const {
  return {column_radius_mm.value_or(0.0), column_top_mm.value_or(0.0), bench_mm};
}

std::optional<MeasuringVolume> RoomFlags::measuring_volume() const {
  if (!volume) return std::nullopt;
  const std::vector<double> v = numbers_of("--volume", *volume);
  if (v.size() != 6 || v[0] >= v[1] || v[2] >= v[3] || v[4] >= v[5]) {
    throw std::invalid_argument(fmt::format(
        "--volume {}: expected X1,X2,Y1,Y2,Z1,Z2 in mm, each first one smaller", *volume));
  }
  return MeasuringVolume{{v[0], v[2], v[4]}, {v[1], v[3], v[5]}};
}

std::vector<double> numbers_of(const char* flag, const std::string& text) {
  std::vector<double> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const auto value = parse_number(part);
    if (!value || !std::isfinite(*value)) {
      throw std::invalid_argument(fmt::format("{} {}: \"{}\" is not a number", flag, text, part));
    }
    values.push_back(*value);
    begin = end + 1;
  }
  return values;
}

}  // namespace armcal::cli
