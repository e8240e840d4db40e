// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/paper_sphere_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/report/comparison_cells.h"

namespace armcal {
namespace {

std::string tenth_percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

TextTable table_of(std::span<const NeglectedEffect> effects) {
  TextTable table({{"neglected", Align::left},
                   {"size", Align::left},
                   {"arms"},
                   {"one articulation: median mm"},
                   {"95 % below"},
                   {"as large"},
                   {"five: median mm"},
                   {"95 % below"},
                   {"as large"},
                   {"form mm"}});
  for (const NeglectedEffect& effect : effects) {
    const DiameterErrors& one = effect.one_articulation;
    const DiameterErrors& five = effect.five_articulations;
    table.add_row({effect.name, effect.brief, std::to_string(effect.arms),
                   error_cell(one.median_mm), error_cell(one.largest95_mm),
                   tenth_percent(one.share_as_large), error_cell(five.median_mm),
                   error_cell(five.largest95_mm), tenth_percent(five.share_as_large),
                   error_cell(five.median_form_mm)});
  }
  return table;
}

std::string what_was_drawn() {
  return fmt::format(
      "The procedure of Wang et al. 2016 and its sphere of {} mm, one neglected effect at a time",
      kPaperSphere_mm);
}

std::string how_to_read_effects() {
  return fmt::format(
      "Errors of the fitted diameter: magnitudes over drawn arms; as large: arms that err by at "
      "least {} mm, as the paper does;\nform: largest minus smallest radius (five articulations, "
      "median).\n",
      -kPaperSphereError_mm);
}

Json errors_json(const DiameterErrors& errors) {
  return {{"median_mm", errors.median_mm},
          {"largest95_mm", errors.largest95_mm},
          {"share_as_large", errors.share_as_large},
          {"median_form_mm", errors.median_form_mm},
          {"explains_the_paper", errors.explains_the_paper()}};
}

}  // namespace

Json json_result(std::span<const NeglectedEffect> effects) {
  Json json;
  json["diameter_mm"] = kPaperSphere_mm;
  json["diameter_error_mm"] = kPaperSphereError_mm;
  json["effects"] = Json::array();
  for (const NeglectedEffect& effect : effects) {
    json["effects"].push_back({{"name", effect.name},
                               {"brief", effect.brief},
                               {"arms", effect.arms},
                               {"one_articulation", errors_json(effect.one_articulation)},
                               {"five_articulations", errors_json(effect.five_articulations)}});
  }
  return json;
}

std::string text_result(std::span<const NeglectedEffect> effects) {
  return what_was_drawn() + "\n\n" + table_of(effects).text() + "\n" + how_to_read_effects();
}

std::string markdown_result(std::span<const NeglectedEffect> effects) {
  return what_was_drawn() + ".\n\n" + table_of(effects).markdown() + "\n" + how_to_read_effects();
}

}  // namespace armcal
