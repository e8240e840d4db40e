// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/check_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"
#include "armcal/report/trend_chart.h"

namespace armcal {
namespace {

Json json_of_tests(const InterimCheck& check) {
  Json tests = Json::array();
  for (const CheckValue& value : check.values) {
    tests.push_back({{"name", value.name},
                     {"symbol", nullptr},  // no test of a standard: it has no symbol there
                     {"value_mm", value.value_mm},
                     {"mpe_mm", json_of(value.limit_mm)},
                     {"U_mm", nullptr},  // limits are compared with the values as they are
                     {"verdict", to_string(value.verdict)},
                     {"definition", value.definition}});
  }
  return tests;
}

Json json_of_places(const InterimCheck& check) {
  Json places = Json::array();
  for (const CheckedPlace& place : check.places) {
    places.push_back({{"name", place.name},
                      {"count", place.count},
                      {"center_mm", json_of(Eigen::VectorXd(place.center_mm))}});
  }
  return places;
}

Json json_of_drift(const CheckTrend& trend) {
  if (!trend.drift) return {};
  return {{"mm_per_day", trend.drift->mm_per_day},
          {"u_mm_per_day", trend.drift->u_mm_per_day},
          {"now_mm", trend.drift->now_mm},
          {"significant", trend.drift->is_significant},
          {"days_to_limit", json_of(trend.days_to_limit())}};
}

Json json_of_trend(const CheckTrend& trend) {
  Json json;
  json["name"] = trend.name;
  json["is_signed"] = trend.is_signed;
  json["limit_mm"] = json_of(trend.limit_mm);
  json["baseline"] = trend.baseline;
  json["centre_mm"] = trend.limits ? Json(trend.limits->center) : Json();
  json["sigma_mm"] = trend.limits ? Json(trend.limits->sigma) : Json();
  json["drift"] = json_of_drift(trend);
  json["violations"] = Json::array();
  for (const RuleViolation& each : trend.violations) {
    json["violations"].push_back({{"check", trend.points[each.at].check},
                                  {"rule", static_cast<int>(each.rule)},
                                  {"side", each.side == Side::above ? "above" : "below"},
                                  {"description", explain(each)}});
  }
  json["checks"] = Json::array();
  for (const TrendPoint& point : trend.points) {
    json["checks"].push_back(
        {{"check", point.check}, {"time", utc_text(point.time_s)}, {"value_mm", point.value_mm}});
  }
  return json;
}

std::string places_in_words(const InterimCheck& check) {
  std::vector<std::string> parts;
  for (const CheckedPlace& place : check.places) {
    parts.push_back(fmt::format("{} points {} {}{}{}", place.count,
                                check.kind == CheckKind::seat ? "in" : "on", to_string(check.kind),
                                place.name.empty() ? "" : " ", place.name));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string text_of_check(const InterimCheck& check) {
  TextTable table({{"", Align::left}, {"mm"}, {"limit"}, {"verdict"}, {"", Align::left}});
  for (const CheckValue& value : check.values) {
    const bool judged = value.verdict != Verdict::not_judged;
    table.add_row({value.title, fixed(value.value_mm, 4),
                   value.limit_mm ? fixed(*value.limit_mm, 4) : "-",
                   judged ? std::string(to_string(value.verdict)) : "-", value.definition});
  }
  return fmt::format("Interim check: {}\n{}", places_in_words(check), table.text());
}

}  // namespace

Json json_result(const CheckSummary& summary) {
  Json json;
  json["arm_name"] = summary.arm;
  json["artefact"] = summary.artefact;
  if (summary.check) {
    json["time"] = utc_text(summary.time);
    json["kind"] = to_string(summary.check->kind);
    json["diameter_mm"] = json_of(summary.options.diameter_mm);
    json["tip_diameter_mm"] = summary.options.tip_diameter_mm;
    json["length_mm"] = json_of(summary.options.length_mm);
    json["temperature_C"] = json_of(summary.temperature_C);
    json["note"] = summary.note;
    json["places"] = json_of_places(*summary.check);
    json["tests"] = json_of_tests(*summary.check);
    json["verdict"] = to_string(summary.check->verdict());
  }
  json["history"] = summary.history ? Json(*summary.history) : Json();
  json["saved_as"] = summary.saved ? Json(*summary.saved) : Json();
  json["trends"] = Json::array();
  for (const CheckTrend& trend : summary.trends) json["trends"].push_back(json_of_trend(trend));
  return json;
}

std::string text_result(const CheckSummary& summary) {
  std::string text;
  if (summary.check) text += text_of_check(*summary.check);
  if (summary.saved)
    text += fmt::format("  saved as check {} of {}\n", *summary.saved, *summary.history);
  for (const CheckTrend& trend : summary.trends) {
    if (!text.empty()) text += '\n';
    text += fmt::format("Trend of the {}: {} checks{}{}{}{}\n", title_of(trend.name),
                        trend.points.size(), summary.arm.empty() ? "" : " of ", summary.arm,
                        summary.artefact.empty() ? "" : " with ", summary.artefact);
    text += trend_chart(trend);
  }
  return text;
}

std::vector<std::string> warnings_of(const CheckTrend& trend) {
  std::vector<std::string> warnings;
  for (const RuleViolation& each : trend.violations_now()) {
    warnings.push_back(fmt::format("{}: {}", title_of(trend.name), explain(each)));
  }
  if (const auto days = trend.days_to_limit()) {
    warnings.push_back(fmt::format("{}: drifts by {} and is at its limit in {} days",
                                   title_of(trend.name), drift_text(*trend.drift),
                                   fixed(*days, 0)));
  } else if (trend.drift && trend.drift->is_significant && trend.limits) {
    warnings.push_back(
        fmt::format("{}: drifts by {}", title_of(trend.name), drift_text(*trend.drift)));
  }
  return warnings;
}

}  // namespace armcal
