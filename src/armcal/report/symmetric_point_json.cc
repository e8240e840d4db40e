// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/io/arm_file.h"
#include "armcal/report/symmetric_point_amounts.h"
#include "armcal/report/symmetric_point_report.h"

namespace armcal {
namespace {

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
  json[key + (is_angle ? "_deg" : "_mm")] =
      value ? json_number(shown_amount(*value, is_angle)) : Json();
}

Json json_of_angles(const Eigen::VectorXd& rad) {
  return json_of(Eigen::VectorXd(rad * degrees_from_radians(1.0)));
}

Json reading_json(const SymmetricPointAnalysis& analysis, std::size_t i) {
  const SymmetricReading& reading = analysis.readings[i];
  const auto place = static_cast<Eigen::Index>(i);
  Json json;
  json["name"] = reading.name;
  json["kind"] = to_string(reading.kind);
  json["joint"] = reading.joint;
  json["unit"] = unit_of_amount(reading.is_angle());
  json["value"] = shown_amount(reading.value, reading.is_angle());
  json["u"] = shown_amount(reading.u, reading.is_angle());
  json["by_arm_file"] =
      json_number(shown_amount(analysis.predicted_by_nominal(place), reading.is_angle()));
  if (analysis.compared) {
    json["by_compared_arm"] =
        json_number(shown_amount(analysis.predicted_by_compared(place), reading.is_angle()));
  }
  json["posture_deg"] = json_of_angles(reading.posture_rad);
  json["posture_end_deg"] =
      reading.kind == SymmetricKind::reversal ? json_of_angles(reading.posture_end_rad) : Json();
  json["solves"] = reading.solves.empty() ? Json() : Json(reading.solves);
  if (!analysis.adjustment.ok()) return json;
  const AdjustedReading& adjusted = analysis.adjustment.readings[i];
  json["predicted"] = shown_amount(adjusted.predicted, adjusted.is_angle);
  put(json, "residual", adjusted.residual, adjusted.is_angle);
  json["redundancy"] = adjusted.redundancy;
  put(json, "smallest_detectable", adjusted.smallest_detectable, adjusted.is_angle);
  json["normalised"] = json_of(adjusted.normalised);
  json["flagged"] = adjusted.flagged;
  json["inseparable_from"] = adjusted.inseparable_from;
  put(json, "estimated_error", adjusted.estimated_error, adjusted.is_angle);
  return json;
}

// @param mends_angle  is the reading that would reconcile the claim an angle?
Json claim_json(const ClaimCheck& claim, bool mends_angle) {
  Json json;
  json["name"] = claim.name;
  json["unit"] = unit_of_amount(claim.is_angle);
  json["claimed"] = shown_amount(claim.claimed, claim.is_angle);
  json["value"] = shown_amount(claim.value, claim.is_angle);
  put(json, "difference", claim.difference, claim.is_angle);
  json["agrees"] = claim.agrees;
  json["sign_differs"] = claim.sign_differs;
  json["contradicted_by"] = claim.contradicted_by ? Json(*claim.contradicted_by) : Json();
  put(json, "reconciled_by", claim.reconciled_by, mends_angle);
  json["equals"] = claim.equals;
  return json;
}

Json adjustment_json(const SymmetricPointAnalysis& analysis) {
  const Adjustment& adjustment = analysis.adjustment;
  const ParameterTable table(analysis.nominal);
  const Eigen::VectorXd nominal = table.nominal();
  Json adjusted = Json::object();
  for (std::size_t i = 0; i < adjustment.unknown_names.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    const bool is_angle = is_angle_parameter(analysis, adjustment.unknown_names[i]);
    const auto index = table.find(adjustment.unknown_names[i]);
    adjusted[adjustment.unknown_names[i]] = {
        {"nominal", index ? Json(shown_amount(nominal(*index), is_angle)) : Json()},
        {"value", shown_amount(adjustment.values(place), is_angle)},
        {"u", shown_amount(adjustment.u(place), is_angle)},
        {"unit", unit_of_amount(is_angle)}};
  }
  return adjusted;
}

}  // namespace

Json json_result(const SymmetricPointAnalysis& analysis) {
  Json json;
  json["arm"] = analysis.nominal.name;
  json["chain"] = Json::object();
  json["chain_u"] = Json::object();
  if (analysis.chain) {
    for (const ChainStep& step : analysis.chain->steps) {
      json["chain"][step.parameter] = shown_amount(step.value, step.is_angle);
      json["chain_u"][step.parameter] = shown_amount(step.u, step.is_angle);
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
  // Of the outlier test of each reading: how often it errs on either side.
  json["significance"] = AdjustmentOptions{}.significance;
  json["power"] = AdjustmentOptions{}.power;
  json["readings"] = Json::array();
  for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
    json["readings"].push_back(reading_json(analysis, i));
  }
  json["claims"] = Json::array();
  for (const ClaimCheck& claim : analysis.claims) {
    const auto culprit = std::find_if(
        analysis.readings.begin(), analysis.readings.end(),
        [&](const SymmetricReading& reading) { return reading.name == claim.contradicted_by; });
    const bool mends_angle = culprit != analysis.readings.end() && culprit->is_angle();
    json["claims"].push_back(claim_json(claim, mends_angle));
  }
  json["signs"] = Json::array();
  for (const SignCombination& combination : analysis.signs) {
    json["signs"].push_back(
        {{"turned", combination.turned}, {"misfit", json_number(combination.misfit)}});
  }
  json["equally_good_signs"] = count_equally_good(analysis.signs);
  json["compared_arm"] = analysis.compared ? Json(analysis.compared->name) : Json();
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
  json["nominal_arm"] = arm_text(analysis.nominal);
  json["adjusted_arm"] =
      analysis.adjustment.ok() ? Json(arm_text(analysis.adjustment.arm)) : Json();
  return json;
}

}  // namespace armcal
