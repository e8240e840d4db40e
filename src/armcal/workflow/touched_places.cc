// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/touched_places.h"

#include <fmt/format.h>

#include <algorithm>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// An arm that hardly moves repeats well, whatever is wrong with it.
void warn_of_still_joints(const JointReadings& readings, Diagnostics& diagnostics) {
  constexpr double kStill_deg = 20.0;
  std::vector<int> still;
  for (Eigen::Index joint = 0; joint < readings.encoder_rad.rows(); ++joint) {
    const auto angles = readings.encoder_rad.row(joint);
    const double span_rad = angles.maxCoeff() - angles.minCoeff();
    if (degrees_from_radians(span_rad) < kStill_deg) still.push_back(static_cast<int>(joint) + 1);
  }
  if (still.empty()) return;
  diagnostics.warning(
      {readings.file, 0, 0},
      fmt::format("joint{} {} moved by less than {} deg: an error there would not show",
                  still.size() == 1 ? "" : "s", fmt::join(still, ", "), kStill_deg),
      "swing the elbow from side to side and turn the wrist between points");
}

std::vector<Eigen::Vector3d> tips_of(InputFiles& files, const CsvTable& table, const ArmModel& arm,
                                     const TableOptions& options) {
  const auto readings = joint_readings(table, arm.joint_count(), options, files.diagnostics());
  files.require_good();
  warn_of_still_joints(*readings, files.diagnostics());
  return tips_in_base(arm, readings->encoder_rad);
}

std::vector<Eigen::Vector3d> coordinates_of(InputFiles& files, const CsvTable& table,
                                            const TableOptions& options) {
  if (!table.find("x") && table.find("q1")) {
    files.diagnostics().error({table.file().path, 0, 0}, "holds joint angles, no coordinates",
                              "give the arm that turns them into tips: --arm ARM");
    files.require_good();
  }
  auto readings = point_readings(table, options, files.diagnostics());
  files.require_good();
  if (readings->planar) {
    files.diagnostics().error({table.file().path, 0, 0}, "has no column z_mm",
                              "give the z of every point, or name its column with --map z_mm=..");
    files.require_good();
  }
  return std::move(readings->points_mm);
}

}  // namespace

std::vector<TouchedPlace> touched_places(InputFiles& files, const std::string& readings,
                                         const std::optional<ArmModel>& arm,
                                         const TableOptions& options) {
  const auto table = files.table(readings, options);
  files.require_good();
  const std::vector<Eigen::Vector3d> points =
      arm ? tips_of(files, *table, *arm, options) : coordinates_of(files, *table, options);
  const auto names = table->find("point");
  std::vector<TouchedPlace> places;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const std::string name = names ? std::string(table->field(row, *names)) : std::string();
    auto place = std::find_if(places.begin(), places.end(),
                              [&](const TouchedPlace& each) { return each.name == name; });
    if (place == places.end()) place = places.insert(place, {name, {}});
    place->points_mm.push_back(points[row]);
  }
  return places;
}

}  // namespace armcal
