// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/comparison_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/report/comparison_cells.h"
#include "armcal/report/number_format.h"

namespace armcal {
namespace {

std::string remark_of(const ComparisonRow& row, int repeats) {
  if (row.problem.empty()) return row.remark;
  if (row.arms == 0) return row.problem;
  return fmt::format("{} of {} arms failed: {}", repeats - row.arms, repeats, row.problem);
}

std::vector<std::string> cells_of(const ComparisonRow& row, int repeats) {
  if (row.arms == 0) {
    const std::string readings = row.readings > 0 ? std::to_string(row.readings) : "";
    return {row.title, readings, "", "", "", "", "", "", "", "", remark_of(row, repeats)};
  }
  const Score& score = row.score;
  return {row.title,
          std::to_string(row.readings),
          error_cell(score.point_rms_mm),
          error_cell(score.point_mean_mm),
          error_cell(score.point_max_mm),
          error_cell(score.length_rms_mm),
          ratio_cell(score.noise_ratio),
          score.intervals > 0 ? fmt::format("{}/{}", score.inside, score.intervals) : "",
          condition_cell(row.condition_number),
          row.readings > 0 ? seconds_cell(row.seconds) : "",
          remark_of(row, repeats)};
}

TextTable table_of(const Comparison& comparison) {
  TextTable table({{"method", Align::left},
                   {"readings"},
                   {"rms mm"},
                   {"mean mm"},
                   {"max mm"},
                   {"length mm"},
                   {"x noise"},
                   {"in 95 %"},
                   {"condition"},
                   {"time"},
                   {"remark", Align::left}});
  for (const ComparisonRow& row : comparison.rows) table.add_row(cells_of(row, comparison.repeats));
  return table;
}

std::string what_was_done(const Comparison& comparison) {
  const Scenario& scenario = comparison.scenario;
  const std::string arms =
      comparison.repeats == 1
          ? fmt::format("one arm (seed {})", comparison.seed)
          : fmt::format("medians over {} arms (seeds {} to {})", comparison.repeats,
                        comparison.seed,
                        comparison.seed + static_cast<std::uint64_t>(comparison.repeats) - 1);
  return fmt::format("{}: {}; {}", scenario.name, scenario.title, arms);
}

std::string how_to_read(const Comparison& comparison) {
  return fmt::format(
      "rms, mean, max: points of unseen postures without noise; length: rms error of distances "
      "between them; x noise: with the\nnoise of encoders and reference, over that noise alone "
      "({:.4f} mm); in 95 %: parameters whose interval holds the truth.\n",
      comparison.noise_floor_mm);
}

Json json_of_row(const ComparisonRow& row, int repeats) {
  Json json = {{"name", row.name},   {"title", row.title},       {"reference", row.reference},
               {"needs", row.needs}, {"readings", row.readings}, {"arms", row.arms}};
  if (row.arms > 0) {
    const Score& score = row.score;
    json["point_rms_mm"] = score.point_rms_mm;
    json["point_mean_mm"] = score.point_mean_mm;
    json["point_max_mm"] = score.point_max_mm;
    json["length_rms_mm"] = score.length_rms_mm;
    json["noise_ratio"] = score.noise_ratio;
    json["intervals"] = score.intervals;
    json["inside"] = score.inside;
    json["condition_number"] = json_of(row.condition_number);
    json["seconds"] = row.seconds;
    json["remark"] = row.remark;
  }
  if (row.arms < repeats) json["problem"] = row.problem;
  return json;
}

}  // namespace

Json json_result(const Comparison& comparison) {
  Json json;
  json["scenario"] = comparison.scenario.name;
  json["title"] = comparison.scenario.title;
  json["repeats"] = comparison.repeats;
  json["budget"] = comparison.scenario.readings;
  json["u_reference_mm"] = comparison.scenario.u_reference_mm;
  json["noise_floor_mm"] = comparison.noise_floor_mm;
  json["methods"] = Json::array();
  for (const ComparisonRow& row : comparison.rows)
    json["methods"].push_back(json_of_row(row, comparison.repeats));
  return json;
}

std::string text_result(const Comparison& comparison) {
  return what_was_done(comparison) + "\n\n" + table_of(comparison).text() + "\n" +
         how_to_read(comparison);
}

std::string markdown_result(const Comparison& comparison) {
  return what_was_done(comparison) + ".\n\n" + table_of(comparison).markdown() + "\n" +
         how_to_read(comparison);
}

}  // namespace armcal
