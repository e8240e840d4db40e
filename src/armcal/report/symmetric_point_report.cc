// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/symmetric_point_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

constexpr int kDecimals = 4;  // 0.1 um, and 0.36 arcsec

// Angles are shown in degrees, lengths in mm.
double shown(double value, bool is_angle) { return is_angle ? degrees_from_radians(value) : value; }
const char* unit(bool is_angle) { return is_angle ? "deg" : "mm"; }

std::string amount(double value, bool is_angle, int decimals = kDecimals) {
  return fixed(shown(value, is_angle), decimals);
}

bool is_angle_parameter(const SymmetricPointAnalysis& analysis, const std::string& name) {
  const ParameterTable table(analysis.nominal);
  const auto index = table.find(name);
  return index && table[*index].unit == ParameterUnit::rad;
}

std::string joined(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::vector<std::string> head(names.begin(), names.end() - 1);
  return fmt::format("{} and {}", fmt::join(head, ", "), names.back());
}

std::vector<std::string> joints_of(const SymmetricReading& reading) {
  std::string joint = fmt::format("{}", reading.joint);
  if (reading.kind == SymmetricKind::zero_search)
    joint += fmt::format(" ({} swept)", reading.sweep);
  return {std::string(to_string(reading.kind)), joint};
}

// --- JSON
// -----------------------------------------------------------------------------------------

Json reduction_json(const Reduction& reduction) {
  Json json;
  json["reading"] = reduction.reading;
  json["u_type_a"] = reduction.u_type_a;
  const auto end = [](const EndStatistics& at) {
    return Json{
        {"count", at.count}, {"mean_mm", json_of(Eigen::VectorXd(at.mean_mm))}, {"s_mm", at.s_mm}};
  };
  if (reduction.end_a && reduction.end_b) {
    json["end_a"] = end(*reduction.end_a);
    json["end_b"] = end(*reduction.end_b);
    json["half_turn_deg"] = degrees_from_radians(reduction.half_turn_rad);
    json["largest_slip_deg"] = degrees_from_radians(reduction.largest_slip_rad);
  }
  if (reduction.arc) {
    json["arc"] = {{"count", reduction.arc->count},
                   {"center_mm", json_of(Eigen::VectorXd(reduction.arc->center_mm))},
                   {"axis", json_of(Eigen::VectorXd(reduction.arc->normal))},
                   {"rms_mm", reduction.arc->rms_mm},
                   {"form_mm", reduction.arc->form_mm}};
  }
  if (reduction.zero) {
    Json& zero = json["zero_search"];
    zero["setting_deg"] = degrees_from_radians(reduction.zero->setting_rad);
    zero["u_deg"] = degrees_from_radians(reduction.zero->u_rad);
    zero["extremum"] = reduction.zero->is_minimum ? "minimum" : "maximum";
    zero["law"] = reduction.zero->law == ZeroLaw::full_wave ? "full_wave" : "nominal_shape";
    zero["settings"] = Json::array();
    for (std::size_t i = 0; i < reduction.radii.size(); ++i) {
      zero["settings"].push_back(
          {{"angle_deg", degrees_from_radians(reduction.radii[i].setting_rad)},
           {"radius_mm", reduction.radii[i].radius_mm},
           {"u_mm", reduction.radii[i].u_mm},
           {"residual_mm", reduction.zero->residuals_mm[i]}});
    }
  }
  return json;
}

// Keys ending in _mm for lengths and _deg for angles.
void put(Json& json, const std::string& key, const std::optional<double>& value, bool is_angle) {
  json[key + (is_angle ? "_deg" : "_mm")] = value ? json_number(shown(*value, is_angle)) : Json();
}

Json reading_json(const SymmetricPointAnalysis& analysis, std::size_t i) {
  const SymmetricReading& reading = analysis.readings[i];
  const auto place = static_cast<Eigen::Index>(i);
  Json json;
  json["name"] = reading.name;
  json["kind"] = to_string(reading.kind);
  json["joint"] = reading.joint;
  json["unit"] = unit(reading.is_angle());
  json["value"] = shown(reading.value, reading.is_angle());
  json["u"] = shown(reading.u, reading.is_angle());
  json["by_arm_file"] =
      json_number(shown(analysis.predicted_by_nominal(place), reading.is_angle()));
  if (analysis.compared) {
    json["by_compared_arm"] =
        json_number(shown(analysis.predicted_by_compared(place), reading.is_angle()));
  }
  if (!analysis.adjustment.ok()) return json;
  const AdjustedReading& adjusted = analysis.adjustment.readings[i];
  json["predicted"] = shown(adjusted.predicted, adjusted.is_angle);
  put(json, "residual", adjusted.residual, adjusted.is_angle);
  json["redundancy"] = adjusted.redundancy;
  put(json, "smallest_detectable", adjusted.smallest_detectable, adjusted.is_angle);
  json["normalised"] = json_of(adjusted.normalised);
  json["flagged"] = adjusted.flagged;
  json["inseparable_from"] = adjusted.inseparable_from;
  put(json, "estimated_error", adjusted.estimated_error, adjusted.is_angle);
  return json;
}

Json claim_json(const ClaimCheck& claim) {
  Json json;
  json["name"] = claim.name;
  json["unit"] = unit(claim.is_angle);
  json["claimed"] = shown(claim.claimed, claim.is_angle);
  json["value"] = shown(claim.value, claim.is_angle);
  put(json, "difference", claim.difference, claim.is_angle);
  json["agrees"] = claim.agrees;
  json["sign_differs"] = claim.sign_differs;
  json["contradicted_by"] = claim.contradicted_by ? Json(*claim.contradicted_by) : Json();
  json["reconciled_by_mm"] = json_of(claim.reconciled_by);
  json["equals"] = claim.equals;
  return json;
}

Json adjustment_json(const SymmetricPointAnalysis& analysis) {
  const Adjustment& adjustment = analysis.adjustment;
  Json adjusted = Json::object();
  for (std::size_t i = 0; i < adjustment.unknown_names.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    const bool is_angle = is_angle_parameter(analysis, adjustment.unknown_names[i]);
    adjusted[adjustment.unknown_names[i]] = {{"value", shown(adjustment.values(place), is_angle)},
                                             {"u", shown(adjustment.u(place), is_angle)},
                                             {"unit", unit(is_angle)}};
  }
  return adjusted;
}

// --- text
// -----------------------------------------------------------------------------------------

std::string check_text(const AdjustedReading& reading) {
  if (!reading.normalised) return "not checked";
  return reading.flagged ? "FAILS" : "holds";
}

std::string contradicted_claims_finding(const SymmetricPointAnalysis& analysis,
                                        const std::string& reading_name) {
  std::vector<std::string> claims;
  double reconciling = 0.0;
  for (const ClaimCheck& claim : analysis.claims) {
    if (claim.contradicted_by != reading_name) continue;
    claims.push_back(fmt::format("{} = {}", claim.name, amount(claim.claimed, claim.is_angle, 3)));
    reconciling = *claim.reconciled_by;
  }
  for (const SymmetricReading& reading : analysis.readings) {
    if (reading.name != reading_name) continue;
    return fmt::format("{} = {} contradicts {}; {} agrees with {}.", reading.name,
                       amount(reading.value, reading.is_angle(), 3), joined(claims),
                       amount(reconciling, reading.is_angle(), 3),
                       claims.size() == 1   ? "it"
                       : claims.size() == 2 ? "both"
                                            : "all of them");
  }
  return {};
}

void add_claim_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  std::set<std::string> told;
  for (const ClaimCheck& claim : analysis.claims) {
    if (claim.agrees) continue;
    if (claim.contradicted_by) {
      if (told.insert(*claim.contradicted_by).second) {
        found.push_back(contradicted_claims_finding(analysis, *claim.contradicted_by));
      }
      continue;
    }
    std::string sentence = fmt::format(
        "{} = {} contradicts the readings, which give {}; no single reading reconciles it.",
        claim.name, amount(claim.claimed, claim.is_angle, 3),
        amount(claim.value, claim.is_angle, 3));
    if (!claim.equals.empty()) {
      sentence += fmt::format(" It is the same length as {}.", joined(claim.equals));
    }
    found.push_back(sentence);
  }
}

void add_check_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  std::set<std::string> told;
  std::vector<std::string> unchecked;
  for (const AdjustedReading& reading : analysis.adjustment.readings) {
    if (!reading.normalised) unchecked.push_back(reading.name);
    if (!reading.flagged || told.contains(reading.name)) continue;
    std::vector<std::string> group = {reading.name};
    group.insert(group.end(), reading.inseparable_from.begin(), reading.inseparable_from.end());
    told.insert(group.begin(), group.end());
    std::vector<std::string> errors;
    for (const AdjustedReading& one : analysis.adjustment.readings) {
      if (std::find(group.begin(), group.end(), one.name) == group.end()) continue;
      errors.push_back(fmt::format("{} by {} {}", one.name,
                                   amount(*one.estimated_error, one.is_angle, 3),
                                   unit(one.is_angle)));
    }
    if (group.size() == 1) {
      found.push_back(
          fmt::format("{} does not agree with the other readings: it seems to be off by {} {} "
                      "(normalised residual {}, "
                      "limit {}).",
                      reading.name, amount(*reading.estimated_error, reading.is_angle, 3),
                      unit(reading.is_angle), fixed(*reading.normalised, 1),
                      fixed(analysis.adjustment.critical_value, 2)));
    } else {
      found.push_back(fmt::format(
          "The one check that {} give each other fails (normalised residual {}, limit {}): one of "
          "them is "
          "wrong, and these readings cannot tell which. To be right again they would change {}.",
          joined(group), fixed(std::abs(*reading.normalised), 1),
          fixed(analysis.adjustment.critical_value, 2), joined(errors)));
    }
  }
  if (!unchecked.empty()) {
    std::vector<std::string> solved;
    for (const SymmetricReading& reading : analysis.readings) {
      const bool is_unchecked =
          std::find(unchecked.begin(), unchecked.end(), reading.name) != unchecked.end();
      if (is_unchecked && !reading.solves.empty()) solved.push_back(reading.solves);
    }
    found.push_back(
        fmt::format("{} {} checked by nothing: an error of theirs goes whole into the result{}.",
                    joined(unchecked), unchecked.size() == 1 ? "is" : "are",
                    solved.empty() ? "" : " (" + joined(solved) + ")"));
  }
}

void add_sign_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  if (analysis.signs.size() < 2) return;
  const std::size_t equally_good = count_equally_good(analysis.signs);
  std::string sentence = fmt::format("Of {} combinations of signs ", analysis.signs.size());
  const auto turned = [](const SignCombination& combination) {
    return combination.turned.empty() ? std::string("all as in the arm file")
                                      : "turned: " + joined(combination.turned);
  };
  sentence +=
      equally_good == 1
          ? fmt::format("one fits best ({})", turned(analysis.signs[0]))
          : fmt::format("{} fit equally well, being mirror images of each other (", equally_good);
  if (equally_good > 1) {
    for (std::size_t i = 0; i < equally_good; ++i) {
      sentence += (i == 0 ? "" : "; ") + turned(analysis.signs[i]);
    }
    sentence += ")";
  }
  if (equally_good < analysis.signs.size() && analysis.signs[0].misfit > 0.0) {
    sentence +=
        fmt::format("; the next misses by {} times as much",
                    fixed(analysis.signs[equally_good].misfit / analysis.signs[0].misfit, 0));
  }
  found.push_back(sentence + ".");
}

// One sentence each, or one for all where everything was asked for and most of it must be held.
void add_held_findings(const std::vector<HeldParameter>& held, std::vector<std::string>& found) {
  constexpr std::size_t kToldOneByOne = 6;
  if (held.size() <= kToldOneByOne) {
    for (const HeldParameter& one : held) {
      found.push_back(fmt::format("{}: {} held.", one.reason, one.name));
    }
    return;
  }
  std::vector<std::string> names;
  for (const HeldParameter& one : held) names.push_back(one.name);
  found.push_back(
      fmt::format("{} parameters are held at their nominal values, since these readings do not "
                  "determine them as well (--json says why for each): {}.",
                  names.size(), joined(names)));
}

}  // namespace

Json json_result(const SymmetricPointAnalysis& analysis) {
  Json json;
  json["arm"] = analysis.nominal.name;
  json["chain"] = Json::object();
  json["chain_u"] = Json::object();
  if (analysis.chain) {
    for (const ChainStep& step : analysis.chain->steps) {
      json["chain"][step.parameter] = shown(step.value, step.is_angle);
      json["chain_u"][step.parameter] = shown(step.u, step.is_angle);
    }
    json["chain_problem"] = analysis.chain->complete ? Json() : Json(analysis.chain->problem);
  }
  const Adjustment& adjustment = analysis.adjustment;
  json["adjusted"] = adjustment_json(analysis);
  json["covariance_of"] = adjustment.unknown_names;
  json["covariance"] = json_of(adjustment.covariance);
  json["status"] = adjustment.ok() ? "converged" : std::string(explain(adjustment.status));
  json["rank"] = adjustment.unknowns.size();
  json["condition_number"] = json_number(adjustment.condition_number);
  json["undetermined"] = Json::array();
  for (const HeldParameter& held : adjustment.undetermined) {
    Json like = Json::object();
    for (const auto& [name, weight] : held.like) like[name] = weight;
    json["undetermined"].push_back(
        {{"name", held.name}, {"description", held.reason}, {"combination", like}});
  }
  json["chi2"] = adjustment.chi_squared;
  json["dof"] = adjustment.degrees_of_freedom;
  json["chi2_probability"] = adjustment.chi_squared_probability;
  json["critical_value"] = adjustment.critical_value;
  json["readings"] = Json::array();
  for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
    json["readings"].push_back(reading_json(analysis, i));
  }
  json["claims"] = Json::array();
  for (const ClaimCheck& claim : analysis.claims) json["claims"].push_back(claim_json(claim));
  json["signs"] = Json::array();
  for (const SignCombination& combination : analysis.signs) {
    json["signs"].push_back(
        {{"turned", combination.turned}, {"misfit", json_number(combination.misfit)}});
  }
  json["leakage_of"] = analysis.leakage_of_chain ? "chain" : "adjustment";
  json["leakage_rows"] = analysis.leakage.recovered;
  json["leakage_columns"] = analysis.leakage.assumed;
  json["leakage"] = json_of(analysis.leakage.table);
  json["reductions"] = Json::array();
  for (const Reduction& reduction : analysis.reductions) {
    json["reductions"].push_back(reduction_json(reduction));
  }
  json["findings"] = findings(analysis);
  json["consistent"] = analysis.is_consistent();
  return json;
}

std::vector<std::string> findings(const SymmetricPointAnalysis& analysis) {
  std::vector<std::string> found;
  if (analysis.compared) {
    double worst = 0.0;
    std::string at;
    for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
      const SymmetricReading& reading = analysis.readings[i];
      const double miss =
          std::abs(analysis.predicted_by_compared(static_cast<Eigen::Index>(i)) - reading.value);
      if (!reading.is_angle() && miss > worst) {
        worst = miss;
        at = reading.name;
      }
    }
    found.push_back(fmt::format("The arm \"{}\" misses the readings by up to {} mm ({}).",
                                analysis.compared->name, fixed(worst, 3), at));
  }
  add_sign_findings(analysis, found);
  if (analysis.chain && !analysis.chain->complete) {
    found.push_back(fmt::format("The chain of equations breaks off: {}.", analysis.chain->problem));
  }
  if (!analysis.adjustment.ok()) return found;
  add_claim_findings(analysis, found);
  add_check_findings(analysis, found);
  add_held_findings(analysis.adjustment.undetermined, found);
  return found;
}

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
                   amount(analysis.adjustment.u(place), is_angle), unit(is_angle)});
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
