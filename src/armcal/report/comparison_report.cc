// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/comparison_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

// "0.0031 s", "12 s": two digits say all that a time measured once can say.
std::string seconds_text(double seconds) {
  const int decimals = seconds >= 9.95 ? 0 : decimals_for_uncertainty(seconds);
  return fmt::format("{:.{}f} s", seconds, std::min(decimals, 4));
}

// A millimetre out of place needs no nanometres beside it.
std::string error_text(double error_mm) { return fixed(error_mm, error_mm < 1.0 ? 4 : 2); }

// "23", "2.3e+16".
std::string condition_text(double number) {
  return number < 1e4 ? fmt::format("{:.0f}", number) : fmt::format("{:.0e}", number);
}

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
          error_text(score.point_rms_mm),
          error_text(score.point_mean_mm),
          error_text(score.point_max_mm),
          error_text(score.length_rms_mm),
          fixed(score.noise_ratio, score.noise_ratio < 10.0 ? 2 : 0),
          score.intervals > 0 ? fmt::format("{}/{}", score.inside, score.intervals) : "",
          row.condition_number ? condition_text(*row.condition_number) : "",
          row.readings > 0 ? seconds_text(row.seconds) : "",
          remark_of(row, repeats)};
}

const std::vector<std::string>& titles() {
  static const std::vector<std::string> titles = {"method",    "readings",  "rms mm",  "mean mm",
                                                  "max mm",    "length mm", "x noise", "in 95 %",
                                                  "condition", "time",      "remark"};
  return titles;
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
  std::vector<TextTable::Column> columns;
  for (const std::string& title : titles()) {
    const bool is_text = title == "method" || title == "remark";
    columns.push_back({title, is_text ? Align::left : Align::right});
  }
  TextTable table(columns);
  for (const ComparisonRow& row : comparison.rows) table.add_row(cells_of(row, comparison.repeats));
  return what_was_done(comparison) + "\n\n" + table.text() + "\n" + how_to_read(comparison);
}

std::string markdown_result(const Comparison& comparison) {
  std::string text = what_was_done(comparison) + ".\n\n";
  text += fmt::format("| {} |\n|---|", fmt::join(titles(), " | "));
  for (std::size_t i = 2; i < titles().size(); ++i) text += "---:|";
  text += "---|\n";
  for (const ComparisonRow& row : comparison.rows)
    text += fmt::format("| {} |\n", fmt::join(cells_of(row, comparison.repeats), " | "));
  return text + "\n" + how_to_read(comparison);
}

}  // namespace armcal
