// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/sphere_test_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/report/fit_report.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

Json test_entry(const char* name, const std::optional<double>& value,
                const std::optional<double>& limit, Verdict verdict) {
  Json entry;
  entry["name"] = name;
  entry["symbol"] = nullptr;  // not a test of a standard: it has no symbol there
  entry["value_mm"] = json_of(value);
  entry["mpe_mm"] = json_of(limit);
  entry["U_mm"] = nullptr;  // nor a budget: limits are compared with the values as they are
  entry["verdict"] = to_string(verdict);
  return entry;
}

std::string text_or_dash(const std::optional<double>& value) {
  return value ? fixed(*value, 4) : "-";
}

std::string verdict_text(Verdict verdict) {
  return verdict == Verdict::not_judged ? "-" : std::string(to_string(verdict));
}

}  // namespace

Json json_result(const SphereTest& test, const SphereTestOptions& options) {
  Json json;
  json["certified_diameter_mm"] = options.certified_diameter_mm;
  json["tip_diameter_mm"] = options.tip_diameter_mm;
  json["diameter_mm"] = test.diameter_mm;
  json["diameter_error_mm"] = test.diameter_error_mm;
  json["relative_error"] = test.relative_error;
  json["form_error_mm"] = json_of(test.form_error_mm);
  json["uncompensated_diameter_mm"] = test.uncompensated_diameter_mm;
  json["uncompensated_error_mm"] = test.uncompensated_error_mm;
  json["u_diameter_mm"] = json_of(test.u_diameter_mm);
  json["sphere"] = json_result(test.fit);
  json["directions"] = json_of(Eigen::MatrixXd(test.outward.transpose()));
  json["joint_spans_deg"] = Json::array();
  for (const double span : test.joint_spans_rad) {
    json["joint_spans_deg"].push_back(degrees_from_radians(span));
  }
  json["blind_spots"] = Json::array();
  for (const BlindSpot& spot : test.blind_spots) {
    json["blind_spots"].push_back({{"parameter", spot.parameter}, {"shown_mm_per_mm", spot.shown}});
  }
  json["tests"] = Json::array();
  json["tests"].push_back(test_entry("diameter error", test.diameter_error_mm,
                                     options.largest_diameter_error_mm, test.diameter_verdict));
  json["tests"].push_back(test_entry("form error", test.form_error_mm,
                                     options.largest_form_error_mm, test.form_verdict));
  json["verdict"] = to_string(test.verdict());
  return json;
}

std::string text_result(const SphereTest& test, const SphereTestOptions& options) {
  std::string text = fmt::format("Sphere test: {} points on a sphere of {} mm\n", test.fit.count,
                                 fixed(options.certified_diameter_mm, 4));
  TextTable table({{"", Align::left}, {"value mm"}, {"limit mm"}, {"verdict"}});
  table.add_row({"diameter", fixed(test.diameter_mm, 4), "", ""});
  table.add_row({"diameter error", fixed(test.diameter_error_mm, 4),
                 text_or_dash(options.largest_diameter_error_mm),
                 verdict_text(test.diameter_verdict)});
  table.add_row({"form error", text_or_dash(test.form_error_mm),
                 text_or_dash(options.largest_form_error_mm), verdict_text(test.form_verdict)});
  text += table.text();
  text +=
      fmt::format("  relative error of the diameter {} %\n", fixed(100.0 * test.relative_error, 4));
  if (options.tip_diameter_mm > 0.0) {
    text += fmt::format("  tip diameter {} mm taken off; without that {} mm, error {} mm\n",
                        fixed(options.tip_diameter_mm, 4), fixed(test.uncompensated_diameter_mm, 4),
                        fixed(test.uncompensated_error_mm, 4));
  }
  if (test.u_diameter_mm) {
    text +=
        fmt::format("  standard uncertainty of the diameter from the scatter of the points {} mm\n",
                    fixed(*test.u_diameter_mm, 4));
  }
  if (test.joint_spans_rad.size() > 0) {
    text += "  joints moved by";
    for (const double span : test.joint_spans_rad) {
      text += fmt::format(" {}", fixed(degrees_from_radians(span), 1));
    }
    text += " deg\n";
  }
  return text;
}

std::string blind_spot_warning(const SphereTest& test) {
  if (test.blind_spots.empty()) return {};
  constexpr std::size_t kNamed = 6;
  std::string names;
  for (std::size_t i = 0; i < test.blind_spots.size() && i < kNamed; ++i) {
    names += (i == 0 ? "" : ", ") + test.blind_spots[i].parameter;
  }
  if (test.blind_spots.size() > kNamed) {
    names += fmt::format(" and {} more", test.blind_spots.size() - kNamed);
  }
  return fmt::format(
      "the arm moved too little for this test to reveal a wrong arm: an error of 1 mm in {} would "
      "show by less than 0.1 mm",
      names);
}

}  // namespace armcal
