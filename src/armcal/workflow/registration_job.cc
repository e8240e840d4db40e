// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/registration_job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace armcal {
namespace {

using PlaceByName = std::map<std::string, std::size_t, std::less<>>;

PlaceByName places_by_name(const PointReadings& readings, Diagnostics& diagnostics) {
  PlaceByName places;
  for (std::size_t i = 0; i < readings.names.size(); ++i) {
    const SourcePosition where{readings.file, readings.lines[i], 0};
    if (readings.names[i].empty()) {
      diagnostics.error(where, "point has no name", "name all points, or delete the column");
      continue;
    }
    const auto [first, is_new] = places.emplace(readings.names[i], i);
    if (is_new) continue;
    diagnostics.error(where, fmt::format("point \"{}\" is already on line {}", readings.names[i],
                                         readings.lines[first->second]));
  }
  return places;
}

void complain_of_missing_names(const std::string& file, const PlaceByName& here,
                               const std::string& other_file, const PlaceByName& there,
                               Diagnostics& diagnostics) {
  std::vector<std::string> missing;
  for (const auto& [name, place] : there) {
    if (!here.contains(name)) missing.push_back(name);
  }
  if (missing.empty()) return;
  diagnostics.error({file, 0, 0},
                    fmt::format("has no point{} {} of {}", missing.size() == 1 ? "" : "s",
                                fmt::join(missing, ", "), other_file),
                    "points are paired by the column point, which both tables have");
}

PointPairs paired_by_name(const PointReadings& first, const PointReadings& second,
                          InputFiles& files) {
  const PlaceByName in_first = places_by_name(first, files.diagnostics());
  const PlaceByName in_second = places_by_name(second, files.diagnostics());
  complain_of_missing_names(first.file, in_first, second.file, in_second, files.diagnostics());
  complain_of_missing_names(second.file, in_second, first.file, in_first, files.diagnostics());
  files.require_good();
  PointPairs pairs;
  pairs.by_name = true;
  pairs.first_mm = first.points_mm;
  for (const std::string& name : first.names) {
    pairs.second_mm.push_back(second.points_mm[in_second.at(name)]);
  }
  return pairs;
}

void complain_of_maps_for_neither(const CsvTable& first, const CsvTable& second,
                                  const TableOptions& options, Diagnostics& diagnostics) {
  for (const std::string& ours : first.unmatched()) {
    const auto& others = second.unmatched();
    if (std::find(others.begin(), others.end(), ours) == others.end()) continue;
    const std::string& theirs = options.map.at(ours);
    diagnostics.error({first.file().path, 0, 0},
                      fmt::format("--map {}={}: no column \"{}\", and none in {}", ours, theirs,
                                  theirs, second.file().path),
                      first.columns_in_words());
  }
}

}  // namespace

PointPairs read_point_pairs(InputFiles& files, const std::string& first_path,
                            const std::string& second_path, const TableOptions& options) {
  TableOptions either = options;
  either.unmatched = UnmatchedMap::skip;
  const auto first_table = files.table(first_path, either);
  const auto second_table = files.table(second_path, either);
  files.require_good();
  complain_of_maps_for_neither(*first_table, *second_table, options, files.diagnostics());
  files.require_good();
  const auto first = point_readings(*first_table, options, files.diagnostics());
  const auto second = point_readings(*second_table, options, files.diagnostics());
  files.require_good();
  if (!first->names.empty() && !second->names.empty()) {
    return paired_by_name(*first, *second, files);
  }
  if (first->points_mm.size() != second->points_mm.size()) {
    files.diagnostics().error({second_path, 0, 0},
                              fmt::format("has {} points, {} has {}", second->points_mm.size(),
                                          first_path, first->points_mm.size()),
                              "points are paired by their order, row 1 with row 1, and so on; or "
                              "by a column point in both");
    files.require_good();
  }
  return {first->points_mm, second->points_mm, false};
}

}  // namespace armcal
