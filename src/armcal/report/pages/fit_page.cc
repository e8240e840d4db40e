// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/fit_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/deviations_figure.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr int kDecimalsOfLengths = 6;     // where no uncertainty says how many
constexpr int kDecimalsOfDirections = 9;  // of directions and rotations
constexpr const char* kAxes = "xyz";

// Standard uncertainties by the names of covariance_of; what is certain is not in it.
std::map<std::string, double> uncertainties_of(const DocumentView& document) {
  if (!document.has("covariance")) return {};  // as many points as unknowns
  const std::vector<std::string> names = document.texts("covariance_of");
  const std::vector<DocumentView> rows = document.list("covariance");
  std::map<std::string, double> u;
  for (std::size_t i = 0; i < std::min(names.size(), rows.size()); ++i) {
    const std::vector<double> row = rows[i].as_numbers();
    if (row.size() != names.size()) rows[i].complain("has another length than covariance_of");
    if (row[i] > 0.0) u[names[i]] = std::sqrt(row[i]);
  }
  return u;
}

class ValueTable {
 public:
  ValueTable(const DocumentView& document, const Language& say)
      : document_(document), u_(uncertainties_of(document)) {
    table_.caption = say("fit.values");
    table_.columns = {{say("fit.quantity"), ColumnKind::text},
                      {say("fit.value")},
                      {"u"},
                      {say("parameters.unit"), ColumnKind::word}};
    table_.note = say("fit.values_note");
  }

  void add(const std::string& title, double value, const std::string& name, int decimals,
           const std::string& unit) {
    const auto u = u_.find(name);
    if (u != u_.end()) decimals = decimals_for_uncertainty(u->second);
    table_.rows.push_back({{title},
                           {fixed(value, decimals)},
                           {u != u_.end() ? fixed(u->second, decimals) : "\u2013"},
                           {unit}});
  }
  // Three numbers under a key, which covariance_of has with this beginning.
  void add_vector(const std::string& title, const char* key, const std::string& prefix,
                  int decimals, const std::string& unit) {
    const std::vector<double> vector = document_.numbers(key);
    if (vector.size() != 3) document_[key].complain("is no vector of three numbers");
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string axis(1, kAxes[i]);
      add(fmt::format("{} {}", title, axis), vector[i], prefix + axis, decimals, unit);
    }
  }
  [[nodiscard]] Table take() { return std::move(table_); }

 private:
  DocumentView document_;
  std::map<std::string, double> u_;
  Table table_;
};

// By what only it has.
const char* element_of(const DocumentView& document) {
  if (document.has("radius_mm")) return document.has("normal") ? "circle" : "sphere";
  return document.has("direction") ? "line" : "plane";
}

Headline length_headline(const std::string& label, double value_mm, const std::string& note) {
  return {label, fixed(value_mm, 4), "mm", note, Tone::neutral};
}

Table element_table(const DocumentView& document, const Language& say) {
  ValueTable table(document, say);
  if (document.has("center_mm")) {
    table.add_vector(say("fit.centre"), "center_mm", "", kDecimalsOfLengths, "mm");
  }
  if (document.has("point_mm")) {
    table.add_vector(say("fit.point"), "point_mm", "", kDecimalsOfLengths, "mm");
  }
  if (document.has("normal")) {
    table.add_vector(say("fit.normal"), "normal", "normal_", kDecimalsOfDirections, "");
  }
  if (document.has("direction")) {
    table.add_vector(say("fit.direction"), "direction", "direction_", kDecimalsOfDirections, "");
  }
  if (document.has("radius_mm")) {
    table.add(say("fit.radius"), document.number("radius_mm"), "radius", kDecimalsOfLengths, "mm");
  }
  return table.take();
}

}  // namespace

Page fit_page(const DocumentView& document, const Language& say) {
  const std::string element = element_of(document);
  Page page;
  page.title = say(fmt::format("fit.title.{}", element));
  Headlines headlines;
  if (document.has("radius_mm")) {
    Headline radius =
        length_headline(say("fit.radius"), document.number("radius_mm"), say("fit.radius_note"));
    const auto uncertainties = uncertainties_of(document);
    if (const auto u = uncertainties.find("radius"); u != uncertainties.end()) {
      radius.value = fixed(document.number("radius_mm"), decimals_for_uncertainty(u->second));
    }
    headlines.items.push_back(std::move(radius));
  }
  headlines.items.push_back(length_headline(say(fmt::format("fit.form.{}", element)),
                                            document.number("form_mm"), say("fit.form_note")));
  headlines.items.push_back(
      length_headline(say("fit.rms"), document.number("rms_mm"), say("fit.rms_note")));
  headlines.items.push_back({say("fit.points"), whole(document.number("count")), "",
                             say("fit.points_note", whole(document.number("degrees_of_freedom"))),
                             Tone::neutral});
  page.sections.push_back(
      {"summary", say("compare.summary"), "", {headlines, element_table(document, say)}});
  const std::vector<double> residuals_mm = document.numbers("residuals_mm");
  const DeviationWords words{
      say("sphere_test.in_order"),
      say(have_signs(residuals_mm) ? "fit.in_order_text" : "fit.in_order_unsigned"),
      say("sphere_test.point_axis"), say("sphere_test.deviation_axis"), "sphere_test.point"};
  page.sections.push_back({"points",
                           say("sphere_test.points_title"),
                           "",
                           {Figures{{deviations_figure(residuals_mm, words, say)}}}});
  return page;
}

Page registration_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("register.title");
  Headlines headlines;
  headlines.items.push_back(
      length_headline(say("fit.rms"), document.number("rms_mm"), say("register.rms_note")));
  headlines.items.push_back(
      length_headline(say("register.largest"), document.number("max_mm"), ""));
  headlines.items.push_back({say("register.pairs"), whole(document.number("count")), "",
                             say("fit.points_note", whole(document.number("degrees_of_freedom"))),
                             Tone::neutral});
  Table rotation;
  rotation.caption = say("register.rotation");
  rotation.columns = {{"x"}, {"y"}, {"z"}};
  for (const DocumentView& row : document.list("rotation")) {
    std::vector<Cell> cells;
    for (const double value : row.as_numbers())
      cells.push_back({fixed(value, kDecimalsOfDirections)});
    rotation.rows.push_back(std::move(cells));
  }
  ValueTable translation(document, say);
  translation.add_vector(say("register.translation"), "translation_mm", "", kDecimalsOfLengths,
                         "mm");
  if (document.has("roll_pitch_yaw_deg")) {
    const std::vector<double> angles = document.numbers("roll_pitch_yaw_deg");
    if (angles.size() != 3) document["roll_pitch_yaw_deg"].complain("is no three angles");
    constexpr std::array kAngles = {"register.roll", "register.pitch", "register.yaw"};
    for (std::size_t i = 0; i < 3; ++i) {
      translation.add(say(kAngles[i]), angles[i], "", kDecimalsOfLengths, "deg");
    }
  }
  translation.add(say("register.scale"), document.number("scale"), "scale", kDecimalsOfDirections,
                  "");
  const bool is_scaled = document.number("scale") != 1.0;
  page.sections.push_back({"summary",
                           say("compare.summary"),
                           say(is_scaled ? "register.lead_scaled" : "register.lead"),
                           {headlines, rotation, translation.take()}});
  const DeviationWords words{say("register.in_order"), "", say("register.pair_axis"),
                             say("register.distance_axis"), "register.pair"};
  page.sections.push_back(
      {"points",
       say("register.points_title"),
       "",
       {Figures{{deviations_figure(document.numbers("residuals_mm"), words, say)}}}});
  return page;
}

}  // namespace armcal
