// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_worksheet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "armcal/core/units.h"
#include "armcal/io/csv_text.h"
#include "armcal/report/number_format.h"

namespace armcal {
namespace {

// What tells the rows of a test apart: a title, and the cell of a row; empty where the test does
// not use it.
struct KeyColumn {
  const char* title;
  std::string (*cell)(const PlannedTouch& row);
};

std::string count_cell(int count) { return count > 0 ? fmt::format("{}", count) : ""; }

const std::vector<KeyColumn>& key_columns() {
  static const std::vector<KeyColumn> columns = {
      {"position",
       [](const PlannedTouch& row) {
         return row.position.empty() ? std::string() : text_field(row.position);
       }},
      {"placement", [](const PlannedTouch& row) { return count_cell(row.placement); }},
      {"articulation", [](const PlannedTouch& row) { return count_cell(row.articulation); }},
      {"repeat", [](const PlannedTouch& row) { return count_cell(row.repeat); }},
      {"length_mm",
       [](const PlannedTouch& row) {
         return row.length_mm > 0.0 ? length_field(row.length_mm) : std::string();
       }},
      {"end",
       [](const PlannedTouch& row) {
         return row.end != 0 ? std::string(1, row.end) : std::string();
       }},
      {"point", [](const PlannedTouch& row) { return count_cell(row.point); }}};
  return columns;
}

std::vector<KeyColumn> used_by(const PlannedTest& test) {
  std::vector<KeyColumn> used;
  for (const KeyColumn& column : key_columns()) {
    if (!column.cell(test.touches.front()).empty()) used.push_back(column);
  }
  return used;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_table(const VerificationPlan& plan, const PlannedTest& test) {
  const auto keys = used_by(test);
  std::vector<std::string> titles;
  for (const KeyColumn& key : keys) titles.emplace_back(key.title);
  for (int j = 1; j <= plan.arm.joint_count(); ++j) titles.push_back(fmt::format("q{}", j));
  titles.insert(titles.end(), {"x", "y", "z"});
  std::string text = markdown_row(titles);
  text += markdown_row(std::vector<std::string>(titles.size(), "---"));
  for (const PlannedTouch& row : test.touches) {
    std::vector<std::string> cells;
    for (const KeyColumn& key : keys) cells.push_back(key.cell(row));
    for (const double q : row.encoder_rad) cells.push_back(fixed(degrees_from_radians(q), 0));
    for (const double each : row.touch.tip_mm) cells.push_back(fixed(each, 1));
    text += markdown_row(cells);
  }
  return text;
}

}  // namespace

std::string worksheet_csv(const VerificationPlan& plan) {
  const int joints = plan.arm.joint_count();
  std::string text = "test";
  for (const KeyColumn& key : key_columns()) text += fmt::format(",{}", key.title);
  text += fmt::format(",{}", angle_header(joints));
  for (int j = 1; j <= joints; ++j) text += fmt::format(",planned_q{}_deg", j);
  text += ",planned_x_mm,planned_y_mm,planned_z_mm\n";
  const std::string to_be_filled_in(static_cast<std::size_t>(joints), ',');
  for (const PlannedTest& test : plan.tests) {
    for (const PlannedTouch& row : test.touches) {
      text += test.name;
      for (const KeyColumn& key : key_columns()) text += fmt::format(",{}", key.cell(row));
      text += fmt::format("{},{},{}\n", to_be_filled_in, angle_fields(row.encoder_rad),
                          point_fields(row.touch.tip_mm));
    }
  }
  return text;
}

std::string worksheet_markdown(const VerificationPlan& plan) {
  std::string text = fmt::format("# Verification of {}\n\nAngles in deg, the expected tip in mm.\n",
                                 plan.arm.name.empty() ? "an arm" : plan.arm.name);
  for (const PlannedTest& test : plan.tests) {
    text += fmt::format("\n## {}\n\n{}\n\n{}", test.title, test.covers, markdown_table(plan, test));
  }
  return text;
}

}  // namespace armcal
