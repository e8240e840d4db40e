// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/table_flags.h"

#include <fmt/format.h>

#include <stdexcept>

namespace armcal::cli {
namespace {

// "a=b,c=d" as {"a=b", "c=d"}.
std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::vector<Argument> TableFlags::for_angles() {
  return {
      {"--map", "our column names by those of the file (or column numbers): q1_deg=A1,q2_deg=A2",
       &map, "OURS=THEIRS"},
      {"--angles",
       "unit of angle columns that name none",
       &angles,
       "UNIT",
       NumberRange::any,
       {"deg", "rad"}}};
}

std::vector<Argument> TableFlags::for_points() {
  return joined(
      {{"--map", "our column names by those of the file (or column numbers): x_mm=X,y_mm=Y", &map,
        "OURS=THEIRS"}},
      for_suspects());
}

std::vector<Argument> TableFlags::for_suspects() {
  return {
      {"--keep-duplicates", "equal rows were measured twice, not copied by mistake",
       &keep_duplicates},
      {"--keep-zero-points", "the point 0 0 0 is a point, not a missing one", &keep_zero_points}};
}

TableOptions TableFlags::options() const {
  TableOptions options;
  for (const std::string& list : map) {
    for (const std::string& pair : parts(list)) {
      const std::size_t equals = pair.find('=');
      if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size()) {
        throw std::invalid_argument(
            fmt::format("--map {}: expected OURS=THEIRS, as in --map q1_deg=A1", pair));
      }
      options.map[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
  }
  if (angles) options.angles = *angles == "rad" ? AngleUnit::rad : AngleUnit::deg;
  options.keep_duplicates = keep_duplicates;
  options.keep_zero_points = keep_zero_points;
  return options;
}

std::vector<Argument> joined(std::vector<Argument> first, const std::vector<Argument>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace armcal::cli
