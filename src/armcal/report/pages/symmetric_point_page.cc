// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/heat_map.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/arm_of.h"
#include "armcal/report/pages/posture_figures.h"
#include "armcal/report/pages/symmetric_point_statements.h"
#include "armcal/report/pages/symmetric_point_tables.h"
#include "armcal/report/pages/symmetric_point_values.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

Stamp symmetric_stamp(const DocumentView& document, const Language& say) {
  if (document.flag("consistent")) {
    const auto readings = document.list("readings");
    if (std::none_of(readings.begin(), readings.end(), is_checked_reading)) {
      return {say("symmetric.unproven"), say("symmetric.unproven_sentence"), Tone::warning};
    }
    std::vector<std::string> sentences = {say("symmetric.consistent_sentence")};
    if (!document.list("claims").empty()) sentences.push_back(say("symmetric.claims_agree"));
    return {say("symmetric.consistent"), run_on(sentences, say), Tone::good};
  }
  return {say("symmetric.contradicted"), say("symmetric.contradicted_sentence"), Tone::bad};
}

Headlines symmetric_headlines(const DocumentView& document, const Language& say) {
  const auto readings = document.list("readings");
  const auto checked = std::count_if(readings.begin(), readings.end(), is_checked_reading);
  const std::size_t failing = failing_groups(document).size();
  const auto claims = document.list("claims");
  const auto wrong = std::count_if(claims.begin(), claims.end(),
                                   [](const DocumentView& claim) { return !claim.flag("agrees"); });
  Headlines headlines;
  headlines.items = {
      {say("symmetric.readings"), whole(static_cast<double>(readings.size())), "",
       say("symmetric.checked_note", checked, whole(document.number("dof"))), Tone::neutral},
      {say("symmetric.parameters"), whole(document.number("rank")), "",
       say("symmetric.condition_note", condition_text(document.number_if("condition_number"))),
       Tone::neutral},
      {say("symmetric.chi2"), fixed(document.number("chi2"), 2), "",
       say("symmetric.chi2_note", whole(document.number("dof")),
           fmt::format("{:.2g}", document.number("chi2_probability"))),
       Tone::neutral},
      {say("symmetric.flagged"), fmt::format("{}", failing), "", say("symmetric.flagged_note"),
       failing > 0 ? Tone::bad : Tone::neutral}};
  if (!claims.empty()) {
    headlines.items.push_back({say("symmetric.claims_wrong"), fmt::format("{}", wrong), "",
                               say("symmetric.claims_note", claims.size()),
                               wrong > 0 ? Tone::bad : Tone::neutral});
  }
  return headlines;
}

bool is_angle(const std::string& parameter) {
  return parameter.rfind("zero", 0) == 0 || parameter.rfind("alpha", 0) == 0 ||
         parameter.rfind("beta", 0) == 0 || parameter.rfind("cos", 0) == 0 ||
         parameter.rfind("sin", 0) == 0;
}

// Errors of recovered parameters where an assumption is wrong by 1 mm or 1 mrad, in mm or mrad.
// Assumptions that shift nothing have no column.
std::optional<Figure> leakage_of(const DocumentView& document, const Language& say) {
  constexpr double kNothing = 1e-3;
  constexpr double kLeastMarked = 0.02;
  const std::vector<std::string> recovered = document.texts("leakage_rows");
  const std::vector<std::string> assumed = document.texts("leakage_columns");
  const auto rows = document.list("leakage");
  if (rows.size() != recovered.size()) {
    document["leakage"].complain("has not as many rows as leakage_rows has names");
  }
  if (recovered.empty()) return std::nullopt;
  Eigen::MatrixXd values(static_cast<Eigen::Index>(recovered.size()),
                         static_cast<Eigen::Index>(assumed.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<double> numbers = rows[r].as_numbers();
    if (numbers.size() != assumed.size()) rows[r].complain("has another length");
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      const double scale =
          (is_angle(assumed[c]) ? 1e-3 : 1.0) * (is_angle(recovered[r]) ? 1e3 : 1.0);
      values(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = scale * numbers[c];
    }
  }
  HeatMap map;
  map.id = "leakage-map";
  map.title = say("symmetric.leakage");
  map.text = say(document.text("leakage_of") == "chain" ? "symmetric.leakage_of_chain"
                                                        : "symmetric.leakage_of_adjustment");
  map.text += say("symmetric.leakage_marked", 100.0 * kLeastMarked);
  map.least_marked = kLeastMarked;
  map.nothing = say("symmetric.no_leakage");
  map.key_label = say("symmetric.leakage_key");
  map.rows = recovered;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    if (values.col(c).cwiseAbs().maxCoeff() < kNothing) continue;
    kept.push_back(c);
    map.columns.push_back(assumed[static_cast<std::size_t>(c)]);
  }
  map.values = values(Eigen::all, kept);
  return figure_of(map);
}

Figures postures_of(const DocumentView& document, const Language& say) {
  std::vector<PostureReading> readings;
  for (const DocumentView& reading : document.list("readings")) {
    const std::string value =
        fmt::format("{} {}", fixed(reading.number("value"), decimals_of_reading(reading)),
                    reading.text("unit"));
    readings.push_back({reading, value});
  }
  return posture_figures(
      arm_of(document, document.has("adjusted_arm") ? "adjusted_arm" : "nominal_arm"), readings,
      say);
}

Section result_section(const DocumentView& document, const Language& say) {
  Section section{"summary", say("calibration.summary"), "", {symmetric_headlines(document, say)}};
  const std::vector<std::string> findings = symmetric_findings(document, say);
  if (!findings.empty()) {
    section.blocks.emplace_back(Notice{document.flag("consistent") ? Tone::neutral : Tone::warning,
                                       say("symmetric.findings"), findings});
  }
  return section;
}

}  // namespace

Page symmetric_point_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("symmetric.title");
  page.subtitle = document.text("arm");
  page.stamp = symmetric_stamp(document, say);
  page.sections.push_back(result_section(document, say));
  page.sections.push_back({"parameters",
                           say("symmetric.chain_and_adjustment"),
                           say("symmetric.chain_lead"),
                           {symmetric_parameters(document, say)}});
  if (auto claims = symmetric_claims(document, say)) {
    page.sections.push_back(
        {"claims", say("symmetric.claims"), say("symmetric.claims_lead"), {std::move(*claims)}});
  }
  page.sections.push_back(
      {"readings", say("symmetric.readings"), "", {symmetric_readings(document, say)}});
  if (!document.list("reductions").empty()) {
    page.sections.back().blocks.emplace_back(symmetric_reductions(document, say));
  }
  if (document.has("nominal_arm")) {
    page.sections.push_back({"postures",
                             say("symmetric.postures"),
                             say("symmetric.postures_lead"),
                             {postures_of(document, say)}});
  }
  if (auto leakage = leakage_of(document, say)) {
    page.sections.push_back({"leakage",
                             say("symmetric.leakage_title"),
                             say("symmetric.leakage_lead"),
                             {Figures{{std::move(*leakage)}}}});
  }
  return page;
}

}  // namespace armcal
