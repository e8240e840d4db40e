// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/half_turn_plan_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/io/arm_file.h"
#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

std::string angle(double rad) { return set_angle_text(degrees_from_radians(rad)); }

// The size of an error; none where no size is ever found.
std::string size(double mm) { return std::isfinite(mm) ? fixed(mm, 3) : "-"; }

// "q4 0 -> 90, q6 -90 -> 45": what is set between two readings; all of it before the first one.
std::string changes(const HalfTurnPlan& plan, std::size_t i) {
  if (i == 0) return "all";
  const Eigen::VectorXd& from = plan.readings[i - 1].turn.posture_end_rad;
  const Eigen::VectorXd& to = plan.readings[i].turn.posture_rad;
  std::string text;
  for (Eigen::Index j = 0; j < to.size(); ++j) {
    if (std::abs(from(j) - to(j)) <= 1e-6) continue;
    text += fmt::format("{}q{} {} -> {}", text.empty() ? "" : ", ", j + 1, angle(from(j)),
                        angle(to(j)));
  }
  return text.empty() ? "nothing" : text;
}

std::string grid_text(const HalfTurnWishes& wishes) {
  if (wishes.room.grid_rad <= 0.0) return "any angle";
  return fmt::format("multiples of {} deg", angle(wishes.room.grid_rad));
}

Json json_of_reading(const HalfTurnPlan& plan, std::size_t i) {
  const PlannedReading& reading = plan.readings[i];
  const auto degrees = [](const Eigen::VectorXd& rad) {
    Json list = Json::array();
    for (const double each : rad) list.push_back(degrees_from_radians(each));
    return list;
  };
  return {{"name", reading.name},
          {"joint", reading.turn.joint},
          {"posture_deg", degrees(reading.turn.posture_rad)},
          {"posture_end_deg", degrees(reading.turn.posture_end_rad)},
          {"set_before", changes(plan, i)},
          {"distance_mm", reading.distance_mm},
          {"u_mm", reading.u_mm},
          {"redundancy", reading.redundancy},
          {"smallest_detectable_mm", json_number(reading.detectable_mm)},
          {"smallest_named_mm", json_number(reading.nameable_mm)}};
}

// The rows that table, CSV and Markdown share.
std::vector<std::string> worksheet_titles(const HalfTurnPlan& plan) {
  std::vector<std::string> titles = {"reading", "turn", "from", "to"};
  for (int j = 1; j <= plan.arm.joint_count(); ++j) titles.push_back(fmt::format("q{}", j));
  titles.insert(titles.end(), {"distance", "u", "redundancy", "found", "named", "set before"});
  return titles;
}

std::vector<std::string> worksheet_row(const HalfTurnPlan& plan, std::size_t i) {
  const PlannedReading& reading = plan.readings[i];
  const Eigen::Index turned = reading.turn.joint - 1;
  std::vector<std::string> cells = {reading.name, fmt::format("q{}", reading.turn.joint),
                                    angle(reading.turn.posture_rad(turned)),
                                    angle(reading.turn.posture_end_rad(turned))};
  for (const double each : reading.turn.posture_rad) cells.push_back(angle(each));
  cells.insert(cells.end(),
               {fixed(reading.distance_mm, 3), fixed(reading.u_mm, 4), fixed(reading.redundancy, 3),
                size(reading.detectable_mm), size(reading.nameable_mm), changes(plan, i)});
  return cells;
}

std::string parameters_text(const HalfTurnPlan& plan) {
  TextTable table({{"parameter", Align::left}, {"u"}, {"unit", Align::left}});
  for (const PlannedParameter& parameter : plan.parameters) {
    table.add_row({parameter.name,
                   fixed(parameter.is_angle ? arcseconds_from_radians(parameter.u) : parameter.u,
                         parameter.is_angle ? 2 : 4),
                   parameter.is_angle ? "arcsec" : "mm"});
  }
  return table.text();
}

std::string worksheet_text(const HalfTurnPlan& plan) {
  std::vector<TextTable::Column> columns;
  const auto titles = worksheet_titles(plan);
  for (const std::string& title : titles) {
    const bool is_text = title == "reading" || title == "turn" || title == "set before";
    columns.push_back({title, is_text ? Align::left : Align::right});
  }
  TextTable table(columns);
  for (std::size_t i = 0; i < plan.readings.size(); ++i) table.add_row(worksheet_row(plan, i));
  return table.text();
}

}  // namespace

Json json_result(const HalfTurnPlan& plan) {
  Json json;
  json["arm"] = arm_text(plan.arm);
  json["rank"] = plan.rank();
  json["condition_number"] = plan.condition_number;
  json["length_error_mm"] = plan.length_error_mm;
  json["least_redundancy"] = plan.least_redundancy();
  json["smallest_named_mm"] = json_number(plan.largest_unnamed_mm());
  json["joints_set"] = plan.joints_set;
  json["candidates"] = plan.candidates;
  json["wishes"] = {{"readings", plan.wishes.readings},
                    {"grid_deg", degrees_from_radians(plan.wishes.room.grid_rad)},
                    {"u_mm", plan.wishes.u_mm},
                    {"u_encoder_arcsec", arcseconds_from_radians(plan.wishes.u_encoder_rad)},
                    {"repeats", plan.wishes.repeats},
                    {"least_redundancy", plan.wishes.least_redundancy}};
  json["parameters"] = Json::array();
  for (const PlannedParameter& parameter : plan.parameters) {
    json["parameters"].push_back({{"name", parameter.name},
                                  {"unit", parameter.is_angle ? "rad" : "mm"},
                                  {"u", parameter.u}});
  }
  json["covariance"] = json_of(plan.covariance);
  json["readings"] = Json::array();
  for (std::size_t i = 0; i < plan.readings.size(); ++i) {
    json["readings"].push_back(json_of_reading(plan, i));
  }
  return json;
}

std::string text_result(const HalfTurnPlan& plan) {
  const HalfTurnWishes& wishes = plan.wishes;
  std::string text =
      fmt::format("Complete symmetric-point calibration of {} ({} joints): {} half turns\n",
                  plan.arm.name.empty() ? "an arm" : plan.arm.name, plan.arm.joint_count(),
                  plan.readings.size());
  text += fmt::format("  chosen from {} half turns, {}\n", plan.candidates, grid_text(wishes));
  text += fmt::format(
      "  standard uncertainty of a distance {} mm; of an encoder {} arcsec, read {} "
      "time{} at each end\n",
      fixed(wishes.u_mm, 4), fixed(arcseconds_from_radians(wishes.u_encoder_rad), 1),
      wishes.repeats, wishes.repeats == 1 ? "" : "s");
  text += "\nExpected result\n";
  text +=
      fmt::format("  rank {}, condition number {}\n", plan.rank(), fixed(plan.condition_number, 1));
  text += fmt::format("  rms error of a length between two random tip positions {} mm\n",
                      fixed(plan.length_error_mm, 4));
  text += fmt::format("  smallest redundancy number {}\n", fixed(plan.least_redundancy(), 3));
  text += std::isfinite(plan.largest_unnamed_mm())
              ? fmt::format("  an error of {} mm in any one reading is found and named\n",
                            size(plan.largest_unnamed_mm()))
              : "  an error in some readings cannot be told from one in others\n";
  text += fmt::format("  {} joints are set between the readings\n", plan.joints_set);
  text += "\nParameters: predicted standard uncertainties\n" + parameters_text(plan);
  text +=
      "\nWorksheet (mm, deg): lock the posture q1.., read the tip, turn one joint, read again\n" +
      worksheet_text(plan);
  text +=
      "  found, named: smallest error of this reading that is found (80 %), and named as well "
      "(99.9 %)\n";
  return text;
}

std::string worksheet_csv(const HalfTurnPlan& plan) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) {
      const bool quoted = cell.find(',') != std::string::npos;
      text += fmt::format("{}{}{}{}", text.empty() ? "" : ",", quoted ? "\"" : "", cell,
                          quoted ? "\"" : "");
    }
    return text + "\n";
  };
  std::string text = line(worksheet_titles(plan));
  for (std::size_t i = 0; i < plan.readings.size(); ++i) text += line(worksheet_row(plan, i));
  return text;
}

std::string worksheet_markdown(const HalfTurnPlan& plan) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  const auto titles = worksheet_titles(plan);
  std::string text = line(titles) + line(std::vector<std::string>(titles.size(), "---"));
  for (std::size_t i = 0; i < plan.readings.size(); ++i) text += line(worksheet_row(plan, i));
  return text;
}

}  // namespace armcal
