// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/calibration_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "armcal/io/session_file.h"
#include "armcal/report/calibration_report.h"
#include "armcal/testing/page_laws.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/synthetic_readings.h"

namespace armcal {
namespace {

using testing::document_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::words_of;

// Cones, a length between them and reference points, some of them held out.
const Json& full_document() {
  static const Json document = [] {
    RandomStream random(61, 0);
    const ArmModel nominal = testing::random_arm(
        6, random, {.arbitrary_twists = false, .beta = false, .harmonics = 1, .mount = false});
    testing::SyntheticReadings readings(testing::perturbed(nominal, random, 0.5, 0.002), 62, 0.01);
    std::vector<ObservationGroup> groups = {readings.fixed_points({"P", "Q"}, 12),
                                            readings.length("P", "Q"),
                                            readings.reference_points(40, "A")};
    for (std::size_t row = 0; row < 40; row += 4) groups[2].is_check[row] = true;
    return document_of("calibrate", json_result(calibrate(nominal, groups, {}), groups, {}));
  }();
  return document;
}

// The same with a few rows and parameters.
Json small_document() {
  Json document = full_document();
  for (auto& [name, column] : document["rows"].items()) {
    column = Json::array({column[0], column[24], column[25], column[26]});
  }
  Json& parameters = document["parameters"];
  parameters.erase(parameters.begin() + 3, parameters.end());
  return document;
}

std::vector<Figure> figures_of(const Page& page) {
  std::vector<Figure> all;
  for (const Section& section : page.sections) {
    for (const Block& block : section.blocks) {
      if (const auto* figures = std::get_if<Figures>(&block)) {
        all.insert(all.end(), figures->items.begin(), figures->items.end());
      }
    }
  }
  return all;
}

std::string refusal_of(const Json& document) {
  try {
    (void)page_in("en", document);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

// Units in which people read parameters, said once more.
double shown(const Json& parameter, const char* key) {
  const std::string name = parameter["name"];
  const double value = parameter[key].get<double>();
  if (parameter["unit"] == "mm") return value;
  const bool harmonic = name.starts_with("cos") || name.starts_with("sin");
  return harmonic ? 1e6 * value : value * 180.0 / std::numbers::pi;
}

std::size_t decimals_in(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}

const Table& parameters_of(const Page& page) {
  for (const Section& section : page.sections) {
    if (section.id == "parameters") return std::get<Table>(section.blocks.at(0));
  }
  throw std::logic_error("no parameters");
}

void expect_row_rounds(const std::vector<Cell>& row, const Json& parameter) {
  const std::string& u = row[4].text;
  // Two significant digits; where they would be hundreds, all before the point.
  const double two_digits = std::stod(fmt::format("{:.1e}", shown(parameter, "u")));
  ASSERT_LT(two_digits, 100.0);
  EXPECT_EQ(std::stod(u), two_digits) << parameter;
  for (const auto& [cell, key] : {std::pair(1, "nominal"), std::pair(2, "value")}) {
    const std::string& text = row[static_cast<std::size_t>(cell)].text;
    EXPECT_EQ(decimals_in(text), decimals_in(u));
    const double half_digit = 0.5 * std::pow(10.0, -static_cast<double>(decimals_in(u)));
    // A hair more: the number may lie between two texts.
    EXPECT_NEAR(std::stod(text), shown(parameter, key), half_digit * (1.0 + 1e-6)) << parameter;
  }
}

TEST(CalibrationPage, ShowsEveryParameterRoundedToTwoDigitsOfItsUncertainty) {
  const Json& document = full_document();
  const Page page = page_in("en", document);
  const Table& table = parameters_of(page);
  std::size_t row = 0;
  std::size_t estimated = 0;
  for (const Json& parameter : document["parameters"]) {
    const bool held = parameter["status"] == "held";
    if (held && parameter["value"] == 0.0) continue;
    ASSERT_LT(row, table.rows.size());
    EXPECT_EQ(table.rows[row][0].text, parameter["name"]);
    if (held) {
      EXPECT_EQ(table.rows[row][4].text, "");
    } else {
      expect_row_rounds(table.rows[row], parameter);
      ++estimated;
    }
    ++row;
  }
  EXPECT_EQ(row, table.rows.size());
  EXPECT_GT(estimated, 15U);
  EXPECT_LT(row, document["parameters"].size());  // zeros that are held have been left out
}

TEST(CalibrationPage, DrawsEveryFigureInBothLanguages) {
  for (const char* language : {"en", "zh"}) {
    const std::vector<Figure> figures = figures_of(page_in(language, full_document()));
    std::set<std::string> ids;
    for (const Figure& figure : figures) {
      EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
      EXPECT_NE(figure.title, "") << figure.id;
      EXPECT_THAT(figure.svg, HasSubstr("<svg")) << figure.id;
      const Language& say = Language::named(language);
      for (const char* nothing : {"figures.nothing", "figures.no_parameters"}) {
        EXPECT_THAT(figure.svg, Not(HasSubstr(say(nothing)))) << figure.id;
      }
      EXPECT_THAT(figure.svg, Not(HasSubstr("nan"))) << figure.id;
    }
    EXPECT_GE(figures.size(), 14U);
  }
}

TEST(CalibrationPage, SaysWhatThePooledRowsSay) {
  const Json& document = full_document();
  double squares = 0.0;
  double count = 0.0;
  for (const Json& group : document["groups"]) {
    const double n = group["count"].get<double>();
    squares += n * std::pow(group["rms_mm"].get<double>(), 2);
    count += n;
  }
  const Page page = page_in("en", document);
  const Headlines& headlines = std::get<Headlines>(page.sections[0].blocks[0]);
  EXPECT_EQ(headlines.items.at(1).value, fmt::format("{:.4f}", std::sqrt(squares / count)));
  EXPECT_EQ(page.subtitle, document["arm_name"]);
  EXPECT_EQ(page.stamp.tone, Tone::good);
}

TEST(CalibrationPage, HasTheWorstRowsFirst) {
  const Page page = page_in("en", full_document());
  for (const Block& block : section_of(page, "residuals").blocks) {
    const auto* table = std::get_if<Table>(&block);
    if (table == nullptr) continue;
    ASSERT_EQ(table->rows.size(), 10U);
    for (std::size_t i = 1; i < table->rows.size(); ++i) {
      EXPECT_GE(std::abs(std::stod(table->rows[i - 1][3].text)),
                std::abs(std::stod(table->rows[i][3].text)));
    }
  }
}

TEST(CalibrationPage, HasItsReservations) {
  Json document = small_document();
  document["check_coverage"] = 0.5;
  Page page = page_in("en", document);
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(page.stamp.sentence, HasSubstr("50.0"));

  document["check_coverage"] = 0.95;
  EXPECT_EQ(page_in("en", document).stamp.tone, Tone::good);
  document["sigma0"] = 2.5;
  document["chi2_probability"] = 1e-20;
  page = page_in("en", document);
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  EXPECT_THAT(page.stamp.sentence, HasSubstr("2.500"));

  document["sigma0"] = 0.5;  // better than stated is no reservation
  EXPECT_EQ(page_in("en", document).stamp.tone, Tone::good);
}

// As saved before the document had rows.
TEST(CalibrationPage, StandsWithoutRows) {
  Json document = full_document();
  document.erase("rows");
  for (const char* language : {"en", "zh"}) {
    const Page page = page_in(language, document);
    EXPECT_THAT(words_of(page), HasSubstr(Language::named(language)("calibration.no_rows")));
    EXPECT_EQ(parameters_of(page).rows.size(),
              parameters_of(page_in(language, full_document())).rows.size());
  }
}

TEST(CalibrationPage, RefusesColumnsOfDifferentLengths) {
  const Json document = small_document();
  for (const auto& [name, column] : document["rows"].items()) {
    // Columns that the page does not show may be missing or short.
    if (name == "nominal_residual_mm" || name == "temperature_c") continue;
    Json changed = document;
    changed["rows"][name].erase(0);
    if (name == "group") {
      EXPECT_THAT(refusal_of(changed), HasSubstr("has 4 entries, the column group 3"));
    } else {
      EXPECT_THAT(refusal_of(changed),
                  HasSubstr("key rows." + name + ": has 3 entries, the column group 4"));
    }
    changed["rows"].erase(name);
    EXPECT_THAT(refusal_of(changed), HasSubstr("key rows." + name + ": is missing"));
    changed["rows"][name] = Json::array({Json::object(), Json::object(), Json::object(), 1});
    EXPECT_THAT(refusal_of(changed), HasSubstr("key rows." + name + "[0]: is"));
  }
}

TEST(CalibrationPage, RefusesVectorsAndTimesThatAreNone) {
  Json document = small_document();
  document["rows"]["tip_mm"][2] = {1, 2};
  EXPECT_THAT(refusal_of(document), HasSubstr("key rows.tip_mm[2]: is no vector of three numbers"));
  document = small_document();
  document["rows"]["time"][1] = "noon";
  EXPECT_THAT(refusal_of(document), HasSubstr("key rows.time[1]: is no time"));
}

TEST(CalibrationPage, RefusesAStatusThatThereIsNot) {
  Json document = small_document();
  document["parameters"][1]["status"] = "guessed";
  EXPECT_THAT(refusal_of(document),
              HasSubstr("key parameters[1].status: is none of held, free, prior"));
}

TEST(CalibrationPage, RefusesAnArmThatIsNone) {
  Json document = small_document();
  document["arm"] = "name = 1";
  EXPECT_THAT(refusal_of(document), HasSubstr("key arm: is no arm: "));
}

TEST(CalibrationPage, NamesWhatThePriorsTellMoreThanTheReadings) {
  Json document = small_document();
  EXPECT_THAT(words_of(page_in("en", document)), Not(HasSubstr("Known from their priors")));
  document["null_space"] = Json::array();
  document["parameters"][1]["status"] = "prior";
  document["parameters"][1]["data_share"] = 0.12;
  document["parameters"][2]["status"] = "prior";
  document["parameters"][2]["data_share"] = 0.93;
  const std::string name = document["parameters"][1]["name"];
  const std::string words = words_of(page_in("en", document));
  EXPECT_THAT(words, HasSubstr("more than from these readings\n" + name + "\n"));
  EXPECT_THAT(words, Not(HasSubstr("These were held at their nominal values")));
}

TEST(CalibrationPage, KeepsTheLawsOfPages) { testing::expect_page_laws(small_document()); }

TEST(IdentifiabilityPage, KeepsTheLawsOfPages) {
  Json document = document_of("identifiability", Json::object());
  const Json& full = full_document();
  for (const char* key :
       {"arm_name", "parameters", "rank", "unknowns", "condition_number", "null_space"}) {
    document[key] = full[key];
  }
  const Page page = page_in("en", document);
  EXPECT_EQ(page.sections.size(), 3U);
  // Before a calibration nothing has a value or a change.
  EXPECT_THAT(words_of(page), HasSubstr("can be determined"));
  EXPECT_THAT(words_of(page), HasSubstr("Parameter | Nominal | u | Unit | Status | Data share"));
  testing::expect_page_laws(document);
}

}  // namespace
}  // namespace armcal
