// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/session_comparison_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/report/comparison_cells.h"

namespace armcal {
namespace {

std::string ratio_or_nothing(const std::optional<double>& ratio) {
  return ratio ? ratio_cell(*ratio) : "";
}

std::vector<std::string> cells_of(const SessionComparisonRow& row) {
  if (!row.held_out) return {row.title, "", "", "", "", "", "", "", "", row.problem};
  const ResidualStatistics& judged = row.held_out->residuals;
  const bool estimates = row.parameters > 0;
  return {row.title,
          estimates ? std::to_string(row.parameters) : "",
          condition_cell(row.condition_number),
          error_cell(row.fitted->residuals.rms_mm),
          error_cell(judged.rms_mm),
          error_cell(judged.mean_mm),
          error_cell(judged.max_mm),
          ratio_or_nothing(row.held_out->over_stated),
          estimates ? seconds_cell(row.seconds) : "",
          row.remark};
}

TextTable table_of(const SessionComparison& comparison) {
  TextTable table({{"method", Align::left},
                   {"parameters"},
                   {"condition"},
                   {"fitted rms mm"},
                   {"held out: rms mm"},
                   {"mean mm"},
                   {"max mm"},
                   {"x stated"},
                   {"time"},
                   {"remark", Align::left}});
  for (const SessionComparisonRow& row : comparison.rows) table.add_row(cells_of(row));
  return table;
}

std::string what_was_done(const SessionComparison& comparison) {
  return fmt::format("{}: {} rows fitted, {} held out{}", comparison.arm_name, comparison.fitted,
                     comparison.held_out,
                     comparison.split_here ? " (here: the session holds nothing out)" : "");
}

const char* const kHowToRead =
    "Residuals on rows of both sets, with frames, seats, spheres and planes placed on these very "
    "rows; x stated: held-out rms in\nunits of the uncertainty that the session states.\n";

Json figures_json(const std::optional<RowFigures>& figures) {
  if (!figures) return {};
  return {{"count", figures->residuals.count},
          {"rms_mm", figures->residuals.rms_mm},
          {"mean_mm", figures->residuals.mean_mm},
          {"max_mm", figures->residuals.max_mm},
          {"over_stated", json_of(figures->over_stated)}};
}

Json row_json(const SessionComparisonRow& row) {
  Json json = {{"name", row.name},
               {"title", row.title},
               {"parameters", row.parameters},
               {"condition_number", json_of(row.condition_number)},
               {"fitted", figures_json(row.fitted)},
               {"held_out", figures_json(row.held_out)},
               {"seconds", row.seconds}};
  if (!row.remark.empty()) json["remark"] = row.remark;
  if (!row.problem.empty()) json["problem"] = row.problem;
  return json;
}

}  // namespace

Json json_result(const SessionComparison& comparison) {
  Json json;
  json["arm_name"] = comparison.arm_name;
  json["fitted"] = comparison.fitted;
  json["held_out"] = comparison.held_out;
  json["methods"] = Json::array();
  for (const SessionComparisonRow& row : comparison.rows) json["methods"].push_back(row_json(row));
  return json;
}

std::string text_result(const SessionComparison& comparison) {
  return what_was_done(comparison) + "\n\n" + table_of(comparison).text() + "\n" + kHowToRead;
}

std::string markdown_result(const SessionComparison& comparison) {
  return what_was_done(comparison) + ".\n\n" + table_of(comparison).markdown() + "\n" + kHowToRead;
}

}  // namespace armcal
