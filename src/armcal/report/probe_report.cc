// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/probe_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/report/calibration_quality.h"
#include "armcal/report/calibration_report.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

std::string tip_table(const StylusQualification& stylus) {
  TextTable table(
      {{"tip", Align::left}, {"old mm"}, {"new mm"}, {"u mm"}, {"change / u"}, {"swing deg"}});
  for (const TipCoordinate& each : stylus.tip) {
    const int decimals = decimals_for_uncertainty(each.u_mm);
    table.add_row({each.parameter, fixed(each.old_mm, decimals), fixed(each.value_mm, decimals),
                   fixed(each.u_mm, decimals), fixed(each.change_in_u(), 1),
                   fixed(degrees_from_radians(each.swing_rad), 0)});
  }
  return table.text();
}

std::string scatter_text(const Calibration& calibration) {
  std::string text = fmt::format("  residuals {} mm rms, largest {} mm",
                                 fixed(calibration.groups.front().fit.rms_mm, 4),
                                 fixed(calibration.groups.front().fit.max_mm, 4));
  text += fmt::format("; sigma0 {}", fixed(calibration.sigma0, 2));
  if (scatters_more_than_stated(calibration.sigma0, calibration.chi_squared_probability))
    text += ": the readings scatter more than stated, so u is widened by it";
  return text + "\n";
}

std::string verdict_text(const StylusQualification& stylus, const std::optional<double>& limit_mm) {
  const std::string U = fixed(stylus.U_mm, 4);
  switch (verdict_of(stylus, limit_mm)) {
    case Verdict::fail:
      return fmt::format("not qualified: U = {} mm (k=2) exceeds the limit of {} mm\n", U,
                         fixed(*limit_mm, 4));
    case Verdict::pass:
      return fmt::format("qualified to U = {} mm (k=2), limit {} mm\n", U, fixed(*limit_mm, 4));
    default:
      return fmt::format("qualified to U = {} mm (k=2)\n", U);
  }
}

}  // namespace

Verdict verdict_of(const StylusQualification& stylus, const std::optional<double>& limit_mm) {
  if (!limit_mm) return Verdict::not_judged;
  return stylus.U_mm <= *limit_mm ? Verdict::pass : Verdict::fail;
}

Json json_result(const StylusQualification& stylus, const std::optional<double>& limit_mm) {
  Json json = json_result(stylus.calibration);
  json["tip"] = Json::array();
  for (const TipCoordinate& each : stylus.tip) {
    json["tip"].push_back({{"name", each.parameter},
                           {"old_mm", each.old_mm},
                           {"value_mm", each.value_mm},
                           {"u_mm", each.u_mm},
                           {"change_in_u", each.change_in_u()},
                           {"swing_deg", degrees_from_radians(each.swing_rad)}});
  }
  json["tip_covariance_mm2"] = json_of(Eigen::MatrixXd(stylus.covariance_mm2));
  json["U_mm"] = stylus.U_mm;
  json["change_mm"] = stylus.change_mm;
  json["change_in_u"] = stylus.change_in_u;
  json["limit_mm"] = json_of(limit_mm);
  json["verdict"] = to_string(verdict_of(stylus, limit_mm));
  return json;
}

std::string text_result(const StylusQualification& stylus, const std::optional<double>& limit_mm) {
  const Calibration& calibration = stylus.calibration;
  std::string text = fmt::format(
      "Stylus of {}: {} readings {}\n", calibration.arm.name, calibration.groups.front().fit.count,
      calibration.groups.front().kind == ReferenceKind::sphere ? "on a sphere" : "in a seat");
  text += tip_table(stylus) + scatter_text(calibration);
  // sqrt of the 95 % quantile of chi-squared with three degrees of freedom
  constexpr double kSameStylus = 2.795;
  text += fmt::format("  moved by {} mm against the old tip, {} times its uncertainty: {}\n",
                      fixed(stylus.change_mm, 4), fixed(stylus.change_in_u, 1),
                      stylus.change_in_u > kSameStylus ? "another stylus, or a bent one"
                                                       : "no change beyond chance");
  return text + verdict_text(stylus, limit_mm);
}

}  // namespace armcal
