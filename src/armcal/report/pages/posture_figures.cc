// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/posture_figures.h"

#include <fmt/format.h>

#include "armcal/core/units.h"
#include "armcal/report/chart/arm_drawing.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

Eigen::VectorXd radians_of(const DocumentView& reading, const char* key) {
  const std::vector<double> deg = reading.numbers(key);
  return Eigen::Map<const Eigen::VectorXd>(deg.data(), static_cast<Eigen::Index>(deg.size())) *
         radians_from_degrees(1.0);
}

Figure half_turn(const ArmModel& arm, const PostureReading& each, const std::string& id,
                 const Language& say) {
  HalfTurnDrawing drawing;
  drawing.id = id;
  drawing.title = each.reading.text("name");
  drawing.joint_name = say("figures.joint", whole(each.reading.number("joint")));
  drawing.text = say("symmetric.posture_text", drawing.joint_name, each.value);
  drawing.nothing = say("figures.nothing");
  drawing.arm = arm;
  drawing.a_rad = radians_of(each.reading, "posture_deg");
  drawing.b_rad = radians_of(each.reading, "posture_end_deg");
  drawing.joint = each.reading.ordinal("joint", arm.joint_count()) - 1;
  drawing.distance = each.value;
  return figure_of(drawing);
}

Figure one_posture(const ArmModel& arm, const PostureReading& each, const std::string& id,
                   const Language& say) {
  ArmDrawing drawing;
  drawing.id = id;
  drawing.title = each.reading.text("name");
  drawing.text = say("symmetric.posture_single",
                     say("figures.joint", whole(each.reading.number("joint"))), each.value);
  drawing.nothing = say("figures.nothing");
  drawing.scene.arm = arm;
  drawing.scene.postures.push_back(
      {drawing.title, radians_of(each.reading, "posture_deg"), std::nullopt, false});
  Figure figure = figure_of(drawing);
  figure.live.clear();
  figure.is_wide = false;
  return figure;
}

}  // namespace

Figures posture_figures(const ArmModel& arm, const std::vector<PostureReading>& readings,
                        const Language& say) {
  Figures figures;
  for (const PostureReading& each : readings) {
    const std::string id = fmt::format("posture-{}", figures.items.size() + 1);
    figures.items.push_back(each.reading.has("posture_end_deg") ? half_turn(arm, each, id, say)
                                                                : one_posture(arm, each, id, say));
  }
  return figures;
}

}  // namespace armcal
