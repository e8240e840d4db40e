// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/calibration_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/io/arm_file.h"
#include "armcal/io/session_file.h"
#include "armcal/report/calibration_quality.h"
#include "armcal/report/calibration_rows.h"
#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

Json statistics_json(const ResidualStatistics& statistics) {
  return {{"count", statistics.count},
          {"rms_mm", statistics.rms_mm},
          {"mean_mm", statistics.mean_mm},
          {"max_mm", statistics.max_mm},
          {"floor_mm", statistics.floor_mm}};
}

Json json_of_parameters(const Calibration& calibration) {
  Json parameters = Json::array();
  for (const CalibratedParameter& each : calibration.parameters) {
    Json entry = {{"name", each.name},
                  {"unit", to_string(each.unit)},
                  {"nominal", each.nominal},
                  {"value", each.value},
                  {"u", each.u},
                  {"status", to_string(each.status)},
                  {"data_share", each.data_share}};
    if (!each.reason.empty()) entry["reason"] = each.reason;
    parameters.push_back(std::move(entry));
  }
  return parameters;
}

Json json_of_groups(const Calibration& calibration) {
  Json groups = Json::array();
  for (const GroupResult& group : calibration.groups) {
    Json entry = {{"name", group.name}, {"kind", to_string(group.kind)}};
    entry.update(statistics_json(group.fit));
    entry["nominal"] = statistics_json(group.nominal);
    if (group.check) entry["check"] = statistics_json(*group.check);
    if (group.check_nominal) entry["check_nominal"] = statistics_json(*group.check_nominal);
    if (group.check_registered)
      entry["check_registered"] = statistics_json(*group.check_registered);
    groups.push_back(std::move(entry));
  }
  return groups;
}

Json json_of_null_space(const Calibration& calibration) {
  Json directions = Json::array();
  for (const UnseenDirection& direction : calibration.unseen) {
    Json combination = Json::object();
    for (const auto& [name, weight] : direction.combination) combination[name] = weight;
    directions.push_back({{"held", direction.held},
                          {"description", direction.description},
                          {"combination", combination}});
  }
  return directions;
}

std::vector<std::string> free_names(const Calibration& calibration) {
  std::vector<std::string> names;
  for (const int index : calibration.free) {
    names.push_back(calibration.parameters[static_cast<std::size_t>(index)].name);
  }
  return names;
}

Json json_of_convergence(const Calibration& calibration) {
  Json solutions = Json::array();
  for (const SolutionTrace& each : calibration.convergence) {
    solutions.push_back(
        {{"stage", each.stage}, {"unknowns", each.unknowns}, {"costs", each.costs}});
  }
  return solutions;
}

Json json_of_session(const SessionEstimate& asked) {
  Json prior = {{"length_mm", json_of(asked.prior_length_mm)},
                {"zero_rad", json_of(asked.prior_zero_rad)},
                {"twist_rad", json_of(asked.prior_twist_rad)},
                {"harmonic_rad", json_of(asked.prior_harmonic_rad)},
                {"parameters", Json::object()}};
  for (const auto& [name, u] : asked.prior_of) prior["parameters"][name] = u;
  return {{"hold", asked.hold},
          {"harmonics", asked.harmonics},
          {"loss", asked.loss},
          {"check_fraction", asked.check_fraction},
          {"check_seed", asked.check_seed},
          {"prior", prior}};
}

// Pairs of parameters that the readings hardly tell apart, the closest first.
Json json_of_correlations(const Calibration& calibration) {
  constexpr double kClose = 0.9;
  const std::vector<std::string> names = free_names(calibration);
  const Eigen::MatrixXd& covariance = calibration.covariance;
  struct Pair {
    std::size_t first, second;
    double correlation;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      const auto a = static_cast<Eigen::Index>(i);
      const auto b = static_cast<Eigen::Index>(j);
      const double r = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
      if (std::abs(r) > kClose) pairs.push_back({i, j, r});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& one, const Pair& other) {
    return std::abs(one.correlation) > std::abs(other.correlation);
  });
  Json json = Json::array();
  for (const Pair& pair : pairs) {
    json.push_back({{"parameters", {names[pair.first], names[pair.second]}},
                    {"correlation", pair.correlation}});
  }
  return json;
}

std::string parameters_text(const Calibration& calibration) {
  TextTable table({{"parameter", Align::left},
                   {"nominal"},
                   {"value"},
                   {"change"},
                   {"u"},
                   {"unit", Align::left},
                   {"status", Align::left}});
  for (const CalibratedParameter& each : calibration.parameters) {
    if (each.status == ParameterStatus::held && each.value == 0.0) continue;
    const auto [factor, unit] = shown_unit(each.name, to_string(each.unit));
    const bool held = each.status == ParameterStatus::held;
    const int decimals = held ? 4 : decimals_for_uncertainty(factor * each.u);
    std::string status(to_string(each.status));
    if (each.status == ParameterStatus::prior)
      status += fmt::format(", data {:.0f} %", 100.0 * each.data_share);
    table.add_row({each.name, fixed(factor * each.nominal, decimals),
                   fixed(factor * each.value, decimals),
                   held ? "" : fixed(factor * (each.value - each.nominal), decimals),
                   held ? "" : fixed(factor * each.u, decimals), unit, status});
  }
  return table.text();
}

std::string groups_text(const Calibration& calibration) {
  TextTable table({{"readings", Align::left},
                   {"kind", Align::left},
                   {"rows", Align::left},
                   {"count"},
                   {"rms mm"},
                   {"mean mm"},
                   {"max mm"}});
  const auto add = [&](const GroupResult& group, const char* rows,
                       const ResidualStatistics& statistics) {
    table.add_row({group.name, std::string(to_string(group.kind)), rows,
                   fmt::format("{}", statistics.count), fixed(statistics.rms_mm, 4),
                   fixed(statistics.mean_mm, 4), fixed(statistics.max_mm, 4)});
  };
  for (const GroupResult& group : calibration.groups) {
    if (group.fit.count > 0) {
      add(group, "nominal arm", group.nominal);
      add(group, "fitted", group.fit);
    }
    if (group.check) add(group, "held out", *group.check);
    if (group.check_registered && group.kind != ReferenceKind::length) {
      add(group, "held out, placed anew", *group.check_registered);
    }
  }
  return table.text();
}

std::string quality_text(const Calibration& calibration) {
  std::string text;
  if (calibration.degrees_of_freedom > 0) {
    text +=
        fmt::format("  chi-squared {:.4g} with {} degrees of freedom, sigma0 {:.3f}",
                    calibration.chi_squared, calibration.degrees_of_freedom, calibration.sigma0);
    if (scatters_more_than_stated(calibration.sigma0, calibration.chi_squared_probability)) {
      text += ": the readings scatter more than stated, so all uncertainties are widened by sigma0";
    }
    text += '\n';
  }
  if (calibration.check_coverage) {
    text += fmt::format("  predicted 95 % regions hold {:.1f} % of {} held-out rows",
                        100.0 * *calibration.check_coverage, calibration.check_count);
    if (is_model_too_small(*calibration.check_coverage))
      text += ": the model is too small for these readings";
    text += '\n';
  }
  return text;
}

std::string unseen_lines(const Calibration& calibration) {
  if (calibration.unseen.empty()) return "";
  std::string text = "\nWhat the readings cannot see (held at nominal)\n";
  for (const UnseenDirection& direction : calibration.unseen) {
    text += fmt::format("  - {}\n", direction.description);
  }
  return text;
}

std::string flagged_text(const Calibration& calibration) {
  if (calibration.flagged.empty()) return "";
  std::string text =
      fmt::format("\nRows that do not belong to the others ({})\n", calibration.flagged.size());
  constexpr std::size_t kShown = 20;
  for (std::size_t i = 0; i < std::min(kShown, calibration.flagged.size()); ++i) {
    const FlaggedRow& row = calibration.flagged[i];
    text += fmt::format("  {}:{}: off by {} mm, {:.1f} times the usual{}\n", row.where.file,
                        row.where.line, fixed(row.residual_mm, 3), row.normalised,
                        row.is_check ? " (held out)" : "");
  }
  if (calibration.flagged.size() > kShown)
    text += fmt::format("  and {} more\n", calibration.flagged.size() - kShown);
  return text;
}

}  // namespace

Json json_result(const Calibration& calibration) {
  Json json;
  json["arm_name"] = calibration.arm.name;
  json["parameters"] = json_of_parameters(calibration);
  json["rank"] = calibration.rank;
  json["unknowns"] = calibration.unknowns;
  json["condition_number"] = json_number(calibration.condition_number);
  json["null_space"] = json_of_null_space(calibration);
  json["groups"] = json_of_groups(calibration);
  json["chi2"] = calibration.chi_squared;
  json["dof"] = calibration.degrees_of_freedom;
  json["sigma0"] = calibration.sigma0;
  json["chi2_probability"] = calibration.chi_squared_probability;
  json["iterations"] = calibration.iterations;
  json["termination"] = to_string(calibration.termination);
  json["convergence"] = json_of_convergence(calibration);
  json["check_coverage"] = json_of(calibration.check_coverage);
  json["nuisances"] = Json::array();
  for (const NuisanceValue& each : calibration.nuisances) {
    json["nuisances"].push_back({{"name", each.name},
                                 {"unit", to_string(each.unit)},
                                 {"value", each.value},
                                 {"u", each.u}});
  }
  json["covariance_of"] = free_names(calibration);
  json["covariance"] = json_of(calibration.covariance);
  json["correlations"] = json_of_correlations(calibration);
  json["flagged"] = Json::array();
  for (const FlaggedRow& row : calibration.flagged) {
    json["flagged"].push_back({{"group", row.group},
                               {"file", row.where.file},
                               {"line", row.where.line},
                               {"residual_mm", row.residual_mm},
                               {"normalised", row.normalised},
                               {"check", row.is_check}});
  }
  json["arm"] = arm_text(calibration.arm);
  json["nominal_arm"] = arm_text(calibration.nominal);
  return json;
}

Json json_result(const Calibration& calibration, std::span<const ObservationGroup> groups,
                 const SessionEstimate& asked) {
  Json json = json_result(calibration);
  json["session"] = json_of_session(asked);
  json["rows"] = json_of_rows(calibration, groups);
  return json;
}

std::string text_result(const Calibration& calibration) {
  std::string text = fmt::format("Calibration of {} ({} joints)\n\n", calibration.arm.name,
                                 calibration.arm.joint_count());
  text += fmt::format(
      "Residuals: {} of {} unknowns estimated in {} iterations, condition number {:.3g}\n",
      calibration.rank, calibration.unknowns, calibration.iterations, calibration.condition_number);
  text += groups_text(calibration) + quality_text(calibration);
  text += "\nParameters (held ones that are 0 are left out)\n" + parameters_text(calibration);
  text += unseen_lines(calibration) + flagged_text(calibration);
  return text;
}

Json json_of_identifiability(const Calibration& look) {
  Json json;
  json["arm_name"] = look.nominal.name;
  json["parameters"] = json_of_parameters(look);
  json["rank"] = look.rank;
  json["unknowns"] = look.unknowns;
  json["condition_number"] = json_number(look.condition_number);
  json["null_space"] = json_of_null_space(look);
  return json;
}

std::string text_of_identifiability(const Calibration& look) {
  std::string text = fmt::format("What the readings determine of {} ({} joints)\n\n",
                                 look.nominal.name, look.nominal.joint_count());
  text += fmt::format("{} of {} unknowns, condition number {:.3g}\n", look.rank, look.unknowns,
                      look.condition_number);
  TextTable table({{"parameter", Align::left},
                   {"nominal"},
                   {"u"},
                   {"unit", Align::left},
                   {"status", Align::left}});
  for (const CalibratedParameter& each : look.parameters) {
    if (each.status == ParameterStatus::held) continue;
    const auto [factor, unit] = shown_unit(each.name, to_string(each.unit));
    const int decimals = decimals_for_uncertainty(factor * each.u);
    std::string status(to_string(each.status));
    if (each.status == ParameterStatus::prior)
      status += fmt::format(", data {:.0f} %", 100.0 * each.data_share);
    table.add_row({each.name, fixed(factor * each.nominal, decimals),
                   fixed(factor * each.u, decimals), unit, status});
  }
  return text + table.text() + unseen_lines(look);
}

}  // namespace armcal
