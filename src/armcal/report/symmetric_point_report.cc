// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/symmetric_point_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "armcal/arm/parameter_table.h"
#include "armcal/report/number_format.h"
#include "armcal/report/symmetric_point_amounts.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

std::vector<std::string> joints_of(const SymmetricReading& reading) {
  std::string joint = fmt::format("{}", reading.joint);
  if (reading.kind == SymmetricKind::zero_search)
    joint += fmt::format(" ({} swept)", reading.sweep);
  return {std::string(to_string(reading.kind)), joint};
}

std::string check_text(const AdjustedReading& reading) {
  if (!reading.normalised) return "not checked";
  return reading.flagged ? "FAILS" : "holds";
}

}  // namespace

std::string readings_text(const SymmetricPointAnalysis& analysis) {
  std::vector<TextTable::Column> columns = {
      {"reading", Align::left}, {"kind", Align::left}, {"joint"}, {"value"}, {"u"}, {"arm file"}};
  if (analysis.compared) columns.push_back({"compared"});
  if (analysis.adjustment.ok()) {
    columns.insert(
        columns.end(),
        {{"adjusted"}, {"residual"}, {"redundancy"}, {"detectable"}, {"check", Align::left}});
  }
  TextTable table(columns);
  for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
    const SymmetricReading& reading = analysis.readings[i];
    const bool is_angle = reading.is_angle();
    const auto place = static_cast<Eigen::Index>(i);
    std::vector<std::string> cells = {reading.name};
    for (std::string& cell : joints_of(reading)) cells.push_back(std::move(cell));
    cells.push_back(amount(reading.value, is_angle));
    cells.push_back(amount(reading.u, is_angle));
    cells.push_back(amount(analysis.predicted_by_nominal(place), is_angle));
    if (analysis.compared) cells.push_back(amount(analysis.predicted_by_compared(place), is_angle));
    if (analysis.adjustment.ok()) {
      const AdjustedReading& adjusted = analysis.adjustment.readings[i];
      cells.push_back(amount(adjusted.predicted, is_angle));
      cells.push_back(amount(adjusted.residual, is_angle));
      cells.push_back(fixed(adjusted.redundancy, 3));
      cells.push_back(adjusted.smallest_detectable ? amount(*adjusted.smallest_detectable, is_angle)
                                                   : "-");
      cells.push_back(check_text(adjusted));
    }
    table.add_row(std::move(cells));
  }
  return table.text();
}

// How raw points became values: how many, how they repeat, and what the encoders say of the half
// turn.
std::string reductions_text(const SymmetricPointAnalysis& analysis) {
  TextTable table({{"reading", Align::left},
                   {"points"},
                   {"spread mm"},
                   {"half turn deg"},
                   {"others moved deg"}});
  for (const Reduction& reduction : analysis.reductions) {
    if (reduction.end_a && reduction.end_b) {
      table.add_row({reduction.reading,
                     fmt::format("{} + {}", reduction.end_a->count, reduction.end_b->count),
                     fixed(std::max(reduction.end_a->s_mm, reduction.end_b->s_mm), 4),
                     amount(reduction.half_turn_rad, true, 3),
                     amount(reduction.largest_slip_rad, true, 4)});
    } else if (reduction.arc) {
      table.add_row({reduction.reading, fmt::format("{}", reduction.arc->count),
                     fixed(reduction.arc->rms_mm, 4), "", ""});
    } else {
      table.add_row(
          {reduction.reading, fmt::format("{} settings", reduction.radii.size()), "", "", ""});
    }
  }
  return table.text();
}

std::string parameters_text(const SymmetricPointAnalysis& analysis) {
  std::map<std::string, const ChainStep*> chain;
  if (analysis.chain) {
    for (const ChainStep& step : analysis.chain->steps) chain[step.parameter] = &step;
  }
  TextTable table({{"parameter", Align::left},
                   {"nominal"},
                   {"chain"},
                   {"u"},
                   {"adjusted"},
                   {"u"},
                   {"unit", Align::left}});
  const ParameterTable parameters(analysis.nominal);
  std::vector<std::size_t> order(analysis.adjustment.unknown_names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return analysis.adjustment.unknowns[one] < analysis.adjustment.unknowns[other];
  });
  for (const std::size_t i : order) {
    const std::string& name = analysis.adjustment.unknown_names[i];
    const Parameter& parameter = parameters[analysis.adjustment.unknowns[i]];
    const bool is_angle = parameter.unit == ParameterUnit::rad;
    const auto place = static_cast<Eigen::Index>(i);
    const auto step = chain.find(name);
    const bool in_chain = step != chain.end();
    table.add_row({name, amount(parameter.nominal, is_angle),
                   in_chain ? amount(step->second->value, is_angle) : "-",
                   in_chain ? amount(step->second->u, is_angle) : "-",
                   amount(analysis.adjustment.values(place), is_angle),
                   amount(analysis.adjustment.u(place), is_angle), unit_of_amount(is_angle)});
  }
  return table.text();
}

std::string claims_text(const SymmetricPointAnalysis& analysis) {
  TextTable table({{"claim", Align::left},
                   {"claimed"},
                   {"readings give"},
                   {"difference"},
                   {"", Align::left},
                   {"contradicted by", Align::left},
                   {"reconciled by"}});
  for (const ClaimCheck& claim : analysis.claims) {
    const std::string verdict =
        claim.agrees ? (claim.sign_differs ? "agrees but for its sign" : "agrees") : "CONTRADICTED";
    table.add_row({claim.name, amount(claim.claimed, claim.is_angle, 3),
                   amount(claim.value, claim.is_angle, 3),
                   amount(claim.difference, claim.is_angle, 3), verdict,
                   claim.contradicted_by.value_or(claim.agrees ? "" : "-"),
                   claim.reconciled_by ? fixed(*claim.reconciled_by, 3) : ""});
  }
  return table.text();
}

std::string leakage_text(const SymmetricPointAnalysis& analysis, std::size_t most_columns) {
  const Leakage& leakage = analysis.leakage;
  // What each assumption does when it is wrong by a plausible amount.
  constexpr double kPlausible_mm = 0.1;
  constexpr double kPlausible_rad = 5e-4;
  constexpr double kMatters_mm = 0.01;
  std::vector<std::pair<double, Eigen::Index>> columns;
  const ParameterTable parameters(analysis.nominal);
  for (Eigen::Index c = 0; c < leakage.table.cols(); ++c) {
    const Parameter& assumed =
        parameters[parameters.find(leakage.assumed[static_cast<std::size_t>(c)]).value()];
    // Between axes that are not parallel beta says nothing that zero and alpha do not say.
    if (assumed.kind == ParameterKind::beta && assumed.nominal == 0.0) continue;
    const bool is_angle = assumed.unit == ParameterUnit::rad;
    const double effect =
        leakage.table.col(c).cwiseAbs().maxCoeff() * (is_angle ? kPlausible_rad : kPlausible_mm);
    if (effect > kMatters_mm) columns.emplace_back(-effect, c);
  }
  std::stable_sort(columns.begin(), columns.end());
  const std::size_t left_out = columns.size() > most_columns ? columns.size() - most_columns : 0;
  columns.resize(columns.size() - left_out);

  std::vector<TextTable::Column> titles = {{"assumed", Align::left}, {"per", Align::left}};
  for (const std::string& name : leakage.recovered) {
    titles.push_back(
        {fmt::format("{} {}", name, is_angle_parameter(analysis, name) ? "mrad" : "mm")});
  }
  TextTable table(titles);
  for (const auto& [effect, c] : columns) {
    const std::string& name = leakage.assumed[static_cast<std::size_t>(c)];
    const bool is_angle = is_angle_parameter(analysis, name);
    std::vector<std::string> cells = {name, is_angle ? "1 mrad" : "1 mm"};
    for (Eigen::Index r = 0; r < leakage.table.rows(); ++r) {
      const bool row_angle =
          is_angle_parameter(analysis, leakage.recovered[static_cast<std::size_t>(r)]);
      const double scale = (is_angle ? 1e-3 : 1.0) * (row_angle ? 1e3 : 1.0);
      cells.push_back(fixed(leakage.table(r, c) * scale, 3));
    }
    table.add_row(std::move(cells));
  }
  std::string text = table.text();
  if (left_out > 0)
    text += fmt::format("  and {} more that matter (--json has the whole table)\n", left_out);
  return text;
}

std::string text_result(const SymmetricPointAnalysis& analysis) {
  std::string text =
      fmt::format("Symmetric-point readings of {} ({} joints)\n\nReadings (mm, angles deg)\n",
                  analysis.nominal.name.empty() ? "an arm" : analysis.nominal.name,
                  analysis.nominal.joint_count());
  text += readings_text(analysis);
  if (!analysis.reductions.empty()) text += "\nRaw points\n" + reductions_text(analysis);
  if (!analysis.adjustment.ok()) {
    text += fmt::format(
        "\nNo adjustment: {}{}\n", explain(analysis.adjustment.status),
        analysis.adjustment.detail.empty() ? "" : " (" + analysis.adjustment.detail + ")");
    return text;
  }
  text += fmt::format("\nParameters (rank {}, condition number {})\n",
                      analysis.adjustment.unknowns.size(),
                      fixed(analysis.adjustment.condition_number, 1));
  text += parameters_text(analysis);
  if (analysis.adjustment.degrees_of_freedom > 0) {
    text += fmt::format("  chi-squared {} with {} degree{} of freedom, probability {:.2g}\n",
                        fixed(analysis.adjustment.chi_squared, 2),
                        analysis.adjustment.degrees_of_freedom,
                        analysis.adjustment.degrees_of_freedom == 1 ? "" : "s",
                        analysis.adjustment.chi_squared_probability);
  }
  if (!analysis.claims.empty()) text += "\nClaims\n" + claims_text(analysis);
  if (analysis.leakage.table.size() > 0) {
    text += fmt::format("\nLeakage of the {}: error of the result where an assumption is wrong\n",
                        analysis.leakage_of_chain ? "chain" : "adjustment");
    text += leakage_text(analysis, 10);
  }
  const auto found = findings(analysis);
  if (!found.empty()) text += "\nFindings\n";
  for (const std::string& sentence : found) text += "  - " + sentence + "\n";
  return text;
}

}  // namespace armcal
