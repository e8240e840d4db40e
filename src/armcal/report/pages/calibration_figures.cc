// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/calibration_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "armcal/core/units.h"
#include "armcal/numerics/median.h"
#include "armcal/report/chart/arm_drawing.h"
#include "armcal/report/chart/chart.h"
#include "armcal/report/chart/coverage_strips.h"
#include "armcal/report/chart/heat_map.h"
#include "armcal/report/chart/histogram.h"
#include "armcal/report/chart/interval_chart.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/arm_of.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr int kFitStyle = 0;
constexpr int kCheckStyle = 1;

Eigen::VectorXd as_column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// One row far off would press all others to the ground of a linear axis.
bool is_far_off(const std::vector<ResidualRow>& rows) {
  constexpr double kTimesTheUsual = 10.0;
  std::vector<double> residuals;
  for (const ResidualRow& row : rows) residuals.push_back(row.residual_mm);
  return !rows.empty() &&
         *std::max_element(residuals.begin(), residuals.end()) > kTimesTheUsual * median(residuals);
}

// Residuals (lengths) of fitted and of held-out rows over something that a row may have.
template <typename Abscissa>
void add_residuals(Chart& chart, const std::vector<ResidualRow>& rows, const Language& say,
                   const Abscissa& abscissa) {
  chart.y.label = say("figures.residual_axis");
  if (is_far_off(rows)) {
    chart.y.scale = AxisScale::logarithmic;
  } else {
    chart.y.low = 0.0;
  }
  chart.nothing = say("figures.nothing");
  for (const bool check : {false, true}) {
    ChartSeries series;
    series.name = say(check ? "calibration.set_check" : "calibration.set_fit");
    series.style = check ? kCheckStyle : kFitStyle;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ResidualRow& row = rows[i];
      const std::optional<double> x = row.is_check == check ? abscissa(row, i) : std::nullopt;
      if (!x) continue;
      series.x.push_back(*x);
      series.y.push_back(row.residual_mm);
      series.labels.push_back(row.label);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
}

std::size_t joint_count(const std::vector<ResidualRow>& rows) {
  std::size_t count = 0;
  for (const ResidualRow& row : rows) count = std::max(count, row.q_deg.size());
  return count;
}

Figure over_joint(const std::vector<ResidualRow>& rows, std::size_t joint, const Language& say) {
  Chart chart;
  chart.id = fmt::format("residual-joint-{}", joint + 1);
  chart.title = say("figures.over_joint", joint + 1);
  chart.x.label = say("figures.joint_axis", joint + 1);
  add_residuals(chart, rows, say, [&](const ResidualRow& row, std::size_t) {
    return joint < row.q_deg.size() ? std::optional(row.q_deg[joint]) : std::nullopt;
  });
  return figure_of(chart);
}

// Distance of the tip from the origin of the base.
Figure over_reach(const std::vector<ResidualRow>& rows, const Language& say) {
  Chart chart;
  chart.id = "residual-reach";
  chart.title = say("figures.over_reach");
  chart.text = say("figures.over_reach_text");
  chart.x.label = say("figures.reach_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow& row, std::size_t) {
    return row.tip_mm ? std::optional(row.tip_mm->norm()) : std::nullopt;
  });
  return figure_of(chart);
}

// Hours since the first reading.
std::optional<Figure> over_time(const std::vector<ResidualRow>& rows, const Language& say) {
  std::optional<double> first_s;
  for (const ResidualRow& row : rows) {
    if (row.time_s) first_s = std::min(first_s.value_or(*row.time_s), *row.time_s);
  }
  if (!first_s) return std::nullopt;
  Chart chart;
  chart.id = "residual-time";
  chart.title = say("figures.over_time");
  chart.x.label = say("figures.time_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow& row, std::size_t) {
    constexpr double kSecondsPerHour = 3600.0;
    return row.time_s ? std::optional((*row.time_s - *first_s) / kSecondsPerHour) : std::nullopt;
  });
  return figure_of(chart);
}

Figure over_order(const std::vector<ResidualRow>& rows, const Language& say) {
  Chart chart;
  chart.id = "residual-order";
  chart.title = say("figures.over_order");
  chart.text = say("figures.over_order_text");
  chart.x.label = say("figures.order_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow&, std::size_t i) {
    return std::optional(static_cast<double>(i + 1));
  });
  return figure_of(chart);
}

std::vector<double> all_components(const std::vector<ResidualRow>& rows) {
  std::vector<double> components;
  for (const ResidualRow& row : rows) {
    if (row.is_check) continue;
    components.insert(components.end(), row.components.begin(), row.components.end());
  }
  return components;
}

Figure histogram_figure(const std::vector<double>& components, const Language& say) {
  Chart chart;
  chart.id = "residual-histogram";
  chart.title = say("figures.histogram");
  const HistogramBins bins = histogram_bins(components);
  chart.text = say("figures.histogram_text", components.size());
  if (bins.beyond > 0) chart.text += say("figures.histogram_beyond", bins.beyond);
  chart.x.label = say("figures.standardised_axis");
  chart.y.label = say("figures.count_axis");
  chart.nothing = say("figures.nothing");
  return figure_of(with_histogram(std::move(chart), say("figures.components"),
                                  say("figures.normal_density"), bins));
}

Figure quantile_figure(const std::vector<double>& components, const Language& say) {
  Chart chart;
  chart.id = "residual-quantiles";
  chart.title = say("figures.quantiles");
  chart.text = say("figures.quantiles_text");
  const std::size_t beyond = histogram_bins(components).beyond;
  if (beyond > 0) chart.text += say("figures.quantiles_beyond", beyond);
  chart.x.label = say("figures.normal_axis");
  chart.y.label = say("figures.standardised_axis");
  chart.nothing = say("figures.nothing");
  return figure_of(with_normal_quantiles(
      std::move(chart),
      {say("figures.components"), say("figures.as_stated"), say("figures.quantile_band")},
      components));
}

std::vector<double> values_of(const std::vector<ResidualRow>& rows, std::size_t joint,
                              bool is_check) {
  std::vector<double> values;
  for (const ResidualRow& row : rows) {
    if (row.is_check == is_check && joint < row.q_deg.size()) values.push_back(row.q_deg[joint]);
  }
  return values;
}

Figure joint_coverage(const ArmModel& arm, const std::vector<ResidualRow>& rows,
                      const Language& say) {
  CoverageStrips strips;
  strips.id = "coverage-joints";
  strips.title = say("figures.joint_coverage");
  strips.text = say("figures.joint_coverage_text");
  strips.nothing = say("figures.nothing");
  strips.axis = say("figures.encoder_axis");
  strips.fit = say("calibration.set_fit");
  strips.check = say("calibration.set_check");
  strips.span = say("figures.span");
  for (std::size_t joint = 0; joint < arm.joints.size(); ++joint) {
    strips.joints.push_back({say("figures.joint", joint + 1),
                             degrees_from_radians(arm.joints[joint].min_rad),
                             degrees_from_radians(arm.joints[joint].max_rad),
                             values_of(rows, joint, false), values_of(rows, joint, true)});
  }
  return figure_of(strips);
}

Eigen::Matrix3Xd tips_of(const std::vector<ResidualRow>& rows, bool is_check) {
  Eigen::Matrix3Xd tips(3, static_cast<Eigen::Index>(rows.size()));
  Eigen::Index count = 0;
  for (const ResidualRow& row : rows) {
    if (row.is_check == is_check && row.tip_mm) tips.col(count++) = *row.tip_mm;
  }
  return tips.leftCols(count);
}

Figures volume_coverage(const std::vector<ResidualRow>& rows, const Language& say) {
  ReachedPoints points;
  points.id = "coverage-volume";
  points.top_title = say("figures.volume_top");
  points.side_title = say("figures.volume_side");
  points.text = say("figures.volume_text");
  points.nothing = say("figures.nothing");
  points.x = say("figures.x_axis");
  points.y = say("figures.y_axis");
  points.z = say("figures.z_axis");
  points.fit = say("calibration.set_fit");
  points.check = say("calibration.set_check");
  points.fit_mm = tips_of(rows, false);
  points.check_mm = tips_of(rows, true);
  Figures figures;
  for (const Chart& chart : views_of(points)) figures.items.push_back(figure_of(chart));
  return figures;
}

// Of free parameters, from their covariance.
Figure correlations(const DocumentView& document, const Language& say) {
  HeatMap map;
  map.id = "correlations";
  map.title = say("figures.correlations");
  map.text = say("figures.correlations_text");
  map.nothing = say("figures.no_parameters");
  map.key_label = say("figures.correlation_key");
  map.largest = 1.0;
  map.rows = map.columns = document.texts("covariance_of");
  const auto size = static_cast<Eigen::Index>(map.rows.size());
  const std::vector<DocumentView> covariance = document.list("covariance");
  if (covariance.size() != map.rows.size()) {
    document["covariance"].complain("has not as many rows as covariance_of has names");
  }
  Eigen::MatrixXd values(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const DocumentView& row = covariance[static_cast<std::size_t>(i)];
    const std::vector<double> numbers = row.as_numbers();
    if (static_cast<Eigen::Index>(numbers.size()) != size) row.complain("has another length");
    values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(numbers.data(), size);
  }
  const Eigen::VectorXd u = values.diagonal().cwiseSqrt();
  map.values = values.array() / (u * u.transpose()).array();
  return figure_of(map);
}

// Pairs that the readings tell apart badly, as words: a map has no text.
std::optional<Table> close_pairs(const DocumentView& document, const Language& say) {
  constexpr std::size_t kPairsShown = 10;
  if (!document.has("correlations")) return std::nullopt;
  Table table;
  table.caption = say("numerics.close_pairs");
  table.columns = {{say("parameters.name"), ColumnKind::text},
                   {say("parameters.name"), ColumnKind::text},
                   {say("figures.correlation_key")}};
  for (const DocumentView& pair : document.list("correlations")) {
    const std::vector<std::string> names = pair.texts("parameters");
    if (names.size() != 2) pair["parameters"].complain("is no pair");
    table.rows.push_back({{names[0]}, {names[1]}, {fixed(pair.number("correlation"), 3)}});
  }
  table.shown = kPairsShown;
  return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

// Where the readings found the places that they share: points of the base frame by their names.
std::vector<SceneArtefact> found_points(const DocumentView& document, double reach_mm) {
  constexpr std::string_view kPrefix = "point.";
  constexpr double kFarthest = 10.0;  // times the reach: what is beyond was not touched
  std::map<std::string, Eigen::Vector3d> places;
  std::map<std::string, int> axes;
  if (!document.has("nuisances")) return {};
  for (const DocumentView& nuisance : document.list("nuisances")) {
    const std::string name = nuisance.text("name");
    const std::size_t dot = name.rfind('.');
    if (!name.starts_with(kPrefix) || dot + 2 != name.size() || dot < kPrefix.size()) continue;
    const std::size_t axis = std::string_view("xyz").find(name.back());
    if (axis == std::string_view::npos) continue;
    const std::string point = name.substr(kPrefix.size(), dot - kPrefix.size());
    places[point](static_cast<Eigen::Index>(axis)) = nuisance.number("value");
    ++axes[point];
  }
  std::vector<SceneArtefact> points;
  for (const auto& [name, place] : places) {
    if (axes[name] != 3 || !(place.norm() < kFarthest * reach_mm)) continue;
    points.push_back({.shape = ArtefactShape::point, .name = name, .at_mm = place});
  }
  return points;
}

std::optional<Figure> convergence(const DocumentView& document, const Language& say) {
  if (!document.has("convergence")) return std::nullopt;
  Chart chart;
  chart.id = "convergence";
  chart.title = say("figures.convergence");
  chart.text = say("figures.convergence_text");
  chart.nothing = say("figures.nothing");
  chart.x.label = say("figures.step_axis");
  chart.x.low = 0.0;
  chart.y.label = say("figures.cost_axis");
  chart.y.scale = AxisScale::logarithmic;
  double step = 0.0;
  for (const DocumentView& solution : document.list("convergence")) {
    ChartSeries series;
    series.name =
        say(solution.text("stage") == "geometry" ? "figures.stage_geometry" : "figures.stage_all",
            chart.series.size() + 1);
    series.mark = Mark::line;
    series.style = static_cast<int>(chart.series.size());
    for (const double cost : solution.numbers("costs")) {
      series.x.push_back(step++);
      series.y.push_back(cost);
    }
    chart.series.push_back(std::move(series));
  }
  return figure_of(chart);
}

}  // namespace

Section arm_section(const DocumentView& document, const std::vector<ResidualRow>& rows,
                    const Language& say) {
  ArmDrawing drawing;
  drawing.id = "arm-in-space";
  drawing.scene.arm = arm_of(document, "arm");
  if (document.has("nominal_arm")) drawing.scene.nominal = arm_of(document, "nominal_arm");
  double largest = -1.0;
  for (const ResidualRow& row : rows) {
    if (row.q_deg.empty()) continue;
    if (row.residual_mm > largest) {
      largest = row.residual_mm;
      drawing.shown = drawing.scene.postures.size();
    }
    drawing.scene.postures.push_back({row.label, as_column(row.q_deg) * radians_from_degrees(1.0),
                                      row.residual_vector_mm, row.is_check});
  }
  drawing.scene.artefacts = found_points(document, reach_mm(drawing.scene.arm));
  drawing.scene.enlargement = nice_enlargement(drawing.scene);
  drawing.title = say("arm.drawing");
  drawing.text = say("arm.drawing_text");
  drawing.nothing = say("figures.nothing");
  drawing.fit = say("calibration.set_fit");
  drawing.check = say("calibration.set_check");
  drawing.arrows = say("arm.arrows", fmt::format("{:g}", drawing.scene.enlargement));
  Section section{"arm", say("arm.title"), say("arm.lead"), {}};
  section.blocks.emplace_back(Figures{{figure_of(drawing)}});
  return section;
}

Section coverage_section(const DocumentView& document, const std::vector<ResidualRow>& rows,
                         const Language& say) {
  Section section{"coverage", say("coverage.title"), say("coverage.lead"), {}};
  Figures joints;
  joints.items.push_back(joint_coverage(arm_of(document, "arm"), rows, say));
  section.blocks.emplace_back(std::move(joints));
  section.blocks.emplace_back(volume_coverage(rows, say));
  return section;
}

Figures parameter_changes(const DocumentView& document, const Language& say) {
  IntervalChart chart;
  chart.id = "changes";
  chart.title = say("figures.changes");
  chart.text = say("figures.changes_text");
  chart.nothing = say("figures.no_parameters");
  chart.estimated = say("figures.estimated");
  chart.held = say("figures.held");
  std::map<std::string, IntervalGroup> groups;
  for (const DocumentView& parameter : document.list("parameters")) {
    if (parameter.text("status") == "held") continue;
    const ShownUnit shown = shown_unit(parameter.text("name"), parameter.text("unit"));
    const double u = shown.factor * parameter.number("u");
    const double change = shown.factor * (parameter.number("value") - parameter.number("nominal"));
    IntervalGroup& group = groups[shown.unit];
    group.label = say("figures.change_axis", shown.unit);
    group.rows.push_back({parameter.text("name"), change, 2.0 * u,
                          fixed(change, decimals_for_uncertainty(u)), false});
  }
  for (auto& [unit, group] : groups) chart.groups.push_back(std::move(group));
  return {{figure_of(chart)}};
}

Section numerics_section(const DocumentView& document, const Language& say) {
  Section section{"numerics", say("numerics.title"), say("numerics.lead"), {}};
  const std::string reason = document.text("termination");
  const std::string reason_key = fmt::format("numerics.reason.{}", reason);
  section.blocks.emplace_back(Facts{
      {{say("numerics.termination"), say.has(reason_key) ? say(reason_key) : reason},
       {say("numerics.iterations"), whole(document.number("iterations"))},
       {say("numerics.chi_squared"), fmt::format("{:.6g}", document.number("chi2"))},
       {say("numerics.degrees_of_freedom"), whole(document.number("dof"))},
       {say("numerics.probability"), fmt::format("{:.2g}", document.number("chi2_probability"))}}});
  if (auto pairs = close_pairs(document, say)) section.blocks.emplace_back(std::move(*pairs));
  Figures figures;
  figures.items.push_back(correlations(document, say));
  if (auto figure = convergence(document, say)) figures.items.push_back(std::move(*figure));
  section.blocks.emplace_back(std::move(figures));
  return section;
}

Figures residual_figures(const std::vector<ResidualRow>& rows, const Language& say) {
  Figures figures;
  for (std::size_t joint = 0; joint < joint_count(rows); ++joint) {
    figures.items.push_back(over_joint(rows, joint, say));
  }
  figures.items.push_back(over_reach(rows, say));
  auto time = over_time(rows, say);
  figures.items.push_back(time ? std::move(*time) : over_order(rows, say));
  const std::vector<double> components = all_components(rows);
  figures.items.push_back(histogram_figure(components, say));
  figures.items.push_back(quantile_figure(components, say));
  return figures;
}

}  // namespace armcal
