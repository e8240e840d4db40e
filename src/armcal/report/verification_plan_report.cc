// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_plan_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

Json json_of_point(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json json_of_touch(const PlannedTouch& row) {
  Json json;
  if (!row.position.empty()) json["position"] = row.position;
  if (row.placement > 0) json["placement"] = row.placement;
  if (row.articulation > 0) json["articulation"] = row.articulation;
  if (row.repeat > 0) json["repeat"] = row.repeat;
  if (row.length_mm > 0.0) json["length_mm"] = row.length_mm;
  if (row.end != 0) json["end"] = std::string(1, row.end);
  if (row.point > 0) json["point"] = row.point;
  json["angles_deg"] = Json::array();
  for (const double q : row.encoder_rad) json["angles_deg"].push_back(degrees_from_radians(q));
  json["tip_mm"] = json_of_point(row.touch.tip_mm);
  return json;
}

Json json_of_test(const PlannedTest& test) {
  Json json = {{"name", test.name},
               {"title", test.title},
               {"standard", test.is_of_iso ? "ISO 10360-12" : "ASME B89.4.22"},
               {"covers", test.covers}};
  json["spheres"] = Json::array();
  for (const PlannedSphere& sphere : test.spheres) {
    json["spheres"].push_back({{"position", sphere.position},
                               {"center_mm", json_of_point(sphere.centre_mm)},
                               {"pole", json_of_point(sphere.pole)}});
  }
  json["seats"] = Json::array();
  for (const PlannedSeat& seat : test.seats) {
    json["seats"].push_back({{"zone", seat.zone},
                             {"at_mm", json_of_point(seat.at_mm)},
                             {"axis", json_of_point(seat.axis)}});
  }
  json["bars"] = Json::array();
  for (const PlannedBar& bar : test.bars) {
    json["bars"].push_back({{"position", bar.position},
                            {"end_A_mm", json_of_point(bar.from_mm)},
                            {"end_B_mm", json_of_point(bar.to_mm)},
                            {"lengths_mm", bar.lengths_mm}});
  }
  json["joint_coverage"] = json_of(test.joint_coverage);
  json["readings"] = Json::array();
  for (const PlannedTouch& row : test.touches) json["readings"].push_back(json_of_touch(row));
  return json;
}

// What the drawing of a plan shows beside its artefacts.
Json json_of_surroundings(const VerificationPlan& plan) {
  const Surroundings& around = plan.wishes.room.surroundings;
  const RigidTransform& base_from_first_joint = plan.arm.base_from_first_joint;
  Json json;
  json["bench_mm"] = json_of(around.bench_mm);
  json["column_radius_mm"] = around.column_radius_mm;
  json["column_top_mm"] = around.column_top_mm;
  json["volume_mm"] = nullptr;
  if (const auto& volume = plan.wishes.room.volume) {
    json["volume_mm"] = {{"low", json_of_point(volume->low_mm)},
                         {"high", json_of_point(volume->high_mm)}};
  }
  json["first_joint"] = {
      {"origin_mm", json_of_point(base_from_first_joint.translation_mm)},
      {"axes", json_of(Eigen::MatrixXd(base_from_first_joint.rotation.transpose()))}};
  return json;
}

std::vector<std::string> coverage_row(const std::string& title, std::size_t points,
                                      const Eigen::VectorXd& coverage) {
  std::vector<std::string> cells = {title, fmt::format("{}", points)};
  for (const double share : coverage) cells.push_back(fixed(100.0 * share, 0));
  return cells;
}

std::string coverage_text(const VerificationPlan& plan) {
  std::vector<TextTable::Column> columns = {{"test", Align::left}, {"points"}};
  for (int j = 1; j <= plan.arm.joint_count(); ++j) columns.push_back({fmt::format("q{}", j)});
  TextTable table(columns);
  std::size_t points = 0;
  for (const PlannedTest& test : plan.tests) {
    points += test.touches.size();
    table.add_row(coverage_row(test.title, test.touches.size(), test.joint_coverage));
  }
  table.add_row(coverage_row("together", points, plan.joint_coverage));
  return table.text();
}

std::vector<std::string> with_point(std::vector<std::string> cells, const Eigen::Vector3d& point,
                                    int decimals) {
  for (const double each : point) cells.push_back(fixed(each, decimals));
  return cells;
}

std::string spheres_and_seats_text(const VerificationPlan& plan) {
  TextTable table({{"test", Align::left},
                   {"position", Align::left},
                   {"x"},
                   {"y"},
                   {"z"},
                   {"free side x"},
                   {"y"},
                   {"z"}});
  for (const PlannedTest& test : plan.tests) {
    for (const PlannedSphere& sphere : test.spheres) {
      table.add_row(with_point(with_point({test.name, sphere.position}, sphere.centre_mm, 1),
                               sphere.pole, 2));
    }
    for (const PlannedSeat& seat : test.seats) {
      table.add_row(with_point(with_point({test.name, seat.zone}, seat.at_mm, 1), seat.axis, 2));
    }
  }
  return table.text();
}

std::string bars_text(const VerificationPlan& plan) {
  TextTable table({{"test", Align::left},
                   {"position", Align::left},
                   {"length"},
                   {"A x"},
                   {"y"},
                   {"z"},
                   {"B x"},
                   {"y"},
                   {"z"}});
  for (const PlannedTest& test : plan.tests) {
    for (const PlannedBar& bar : test.bars) {
      table.add_row(with_point(
          with_point({test.name, bar.position, fixed(bar.lengths_mm.back(), 1)}, bar.from_mm, 1),
          bar.to_mm, 1));
    }
  }
  return table.text();
}

}  // namespace

Json json_result(const VerificationPlan& plan) {
  Json json;
  json["arm_name"] = plan.arm.name;
  json["surroundings"] = json_of_surroundings(plan);
  json["reach_mm"] = plan.reach_mm;
  json["wishes"] = {{"sphere_diameter_mm", plan.wishes.sphere_diameter_mm},
                    {"tip_diameter_mm", plan.wishes.tip_diameter_mm},
                    {"lengths_mm", plan.wishes.lengths_mm},
                    {"bars_mm", plan.wishes.bars_mm}};
  json["tests"] = Json::array();
  for (const PlannedTest& test : plan.tests) json["tests"].push_back(json_of_test(test));
  json["joint_coverage"] = json_of(plan.joint_coverage);
  return json;
}

std::string text_result(const VerificationPlan& plan) {
  const VerificationPlanWishes& wishes = plan.wishes;
  std::string text = fmt::format("Verification of {} ({} joints, reach {:.0f} mm)\n",
                                 plan.arm.name.empty() ? "an arm" : plan.arm.name,
                                 plan.arm.joint_count(), plan.reach_mm);
  text += fmt::format("  sphere of {} mm, tip of {} mm\n", wishes.sphere_diameter_mm,
                      wishes.tip_diameter_mm);
  if (wishes.iso10360_12) {
    text += fmt::format("  lengths of {} mm\n", fmt::join(wishes.lengths_mm, ", "));
  }
  if (wishes.b89_4_22) {
    text += fmt::format("  bars of {} and {} mm\n", wishes.bars_mm[0], wishes.bars_mm[1]);
  }
  text += "\nPoints, and the share of the range of each joint that they exercise (%)\n" +
          coverage_text(plan);
  text += "\nWhat they cover\n";
  for (const PlannedTest& test : plan.tests) {
    text += fmt::format("  {}: {}\n", test.name, test.covers);
  }
  text += "\nSpheres and seats (mm, base frame)\n" + spheres_and_seats_text(plan);
  text += "\nBars from end A to end B (mm, base frame)\n" + bars_text(plan);
  return text;
}

}  // namespace armcal
