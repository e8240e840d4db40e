// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/tips_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/chart.h"
#include "armcal/report/chart/coverage_strips.h"
#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr std::size_t kTipsShown = 20;
constexpr int kDecimalsOfExactTips = 6;

Eigen::Matrix3Xd vectors_of(const DocumentView& document, const char* key) {
  const std::vector<DocumentView> list = document.list(key);
  Eigen::Matrix3Xd vectors(3, static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
    const DocumentView& each = list[static_cast<std::size_t>(i)];
    const std::vector<double> numbers = each.as_numbers();
    if (numbers.size() != 3) each.complain("is no vector of three numbers");
    vectors.col(i) = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  }
  return vectors;
}

Table table_of_tips(const Eigen::Matrix3Xd& tips, const Eigen::Matrix3Xd& u, const Language& say) {
  Table table;
  table.columns = {{"#"}, {"x, mm"}, {"y, mm"}, {"z, mm"}};
  const bool has_u = u.cols() > 0;
  if (has_u) table.columns.insert(table.columns.end(), {{"u(x), mm"}, {"u(y), mm"}, {"u(z), mm"}});
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    std::vector<Cell> row = {{fmt::format("{}", i + 1)}};
    std::vector<Cell> uncertain;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const int decimals = has_u ? decimals_for_uncertainty(u(axis, i)) : kDecimalsOfExactTips;
      row.push_back({fixed(tips(axis, i), decimals)});
      if (has_u) uncertain.push_back({fixed(u(axis, i), decimals)});
    }
    row.insert(row.end(), uncertain.begin(), uncertain.end());
    table.rows.push_back(std::move(row));
  }
  table.shown = kTipsShown;
  if (has_u) table.note = say("tips.note");
  return table;
}

Figures views_of_tips(const Eigen::Matrix3Xd& tips, const Language& say) {
  ReachedPoints points;
  points.id = "tips";
  points.top_title = say("tips.top");
  points.side_title = say("tips.side");
  points.text = say("tips.text");
  points.nothing = say("figures.nothing");
  points.x = say("figures.x_axis");
  points.y = say("figures.y_axis");
  points.z = say("figures.z_axis");
  points.fit_mm = tips;
  points.check_mm.resize(3, 0);
  Figures figures;
  for (const Chart& chart : views_of(points)) figures.items.push_back(figure_of(chart));
  return figures;
}

}  // namespace

Page tips_page(const DocumentView& document, const Language& say) {
  const Eigen::Matrix3Xd tips = vectors_of(document, "tips_mm");
  Eigen::Matrix3Xd u(3, 0);
  if (document.has("u_mm")) {
    u = vectors_of(document, "u_mm");
    if (u.cols() != tips.cols()) document["u_mm"].complain("has another length than tips_mm");
  }
  Page page;
  page.title = say("tips.title");
  page.subtitle = document.text_if("calibration").value_or(document.text_if("arm").value_or(""));
  Headlines headlines;
  headlines.items.push_back(
      {say("tips.postures"), whole(static_cast<double>(tips.cols())), "", "", Tone::neutral});
  if (tips.cols() > 0) {
    headlines.items.push_back({say("tips.farthest"), fixed(tips.colwise().norm().maxCoeff(), 1),
                               "mm", say("figures.over_reach_text"), Tone::neutral});
  }
  if (u.cols() > 0) {
    headlines.items.push_back({say("tips.largest_u"), fixed(u.colwise().norm().maxCoeff(), 4), "mm",
                               say("tips.largest_u_note"), Tone::neutral});
  }
  page.sections.push_back({"tips",
                           say("tips.section"),
                           say("tips.lead"),
                           {headlines, table_of_tips(tips, u, say), views_of_tips(tips, say)}});
  return page;
}

}  // namespace armcal
