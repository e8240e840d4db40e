// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/plan_figures.h"

#include <fmt/format.h>

#include <cmath>

#include "armcal/geometry/rigid_transform.h"
#include "armcal/io/xml_text.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/plan_scene.h"

namespace armcal {
namespace {

// Of this drawing alone: classes under its own, colours of the page.
constexpr const char* kFigureStyle = R"(<style>
  @media screen { .drawing svg.armcal-plan { min-width: 27rem; } }
  .armcal-plan text { font-family: inherit; font-size: 13px; fill: currentColor; stroke: none; }
  .armcal-plan .small { font-size: 12px; fill: var(--muted, currentColor); }
  .armcal-plan .label { paint-order: stroke; stroke: var(--paper, Canvas); stroke-width: 3.5px; stroke-linejoin: round; }
  .armcal-plan .paper { fill: var(--paper, Canvas); stroke: none; }
  .armcal-plan .frame, .armcal-plan .zone { fill: none; stroke: var(--edge, #888); stroke-width: 1; }
  .armcal-plan .zone { stroke-dasharray: 2 4; }
  .armcal-plan .volume { fill: none; stroke: var(--edge, #888); stroke-width: 1; stroke-dasharray: 8 3 2 3; }
  .armcal-plan .solid { fill: var(--grid, #bbb); stroke: var(--edge, #888); stroke-width: 1; }
  .armcal-plan .mark { fill: var(--paper, Canvas); stroke: var(--series-0, #0072b2); stroke-width: 2; }
  .armcal-plan .bar { fill: none; stroke: var(--series-1, #d55e00); stroke-width: 2; }
  .armcal-plan .long { stroke-dasharray: 9 5; }
  .armcal-plan .end { fill: var(--series-1, #d55e00); stroke: none; }
</style>
)";

std::string sphere_label(const DocumentView& test, const DocumentView& sphere,
                         const Language& say) {
  const std::string key = fmt::format("verification_plan.purpose.{}", test.text("name"));
  const std::string position = plan_position(sphere.text("position"), say);
  return say.has(key) ? say("verification_plan.sphere_label", say(key), position) : position;
}

// Carries points of the base frame into the frame of the first joint.
RigidTransform first_joint_from_base(const DocumentView& surroundings) {
  const DocumentView joint = surroundings["first_joint"];
  const std::vector<DocumentView> axes = joint.list("axes");
  if (axes.size() != 3) joint["axes"].complain("is not a list of three axes");
  RigidTransform base_from_first_joint;
  base_from_first_joint.translation_mm = point_under(joint, "origin_mm");
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> axis = axes[static_cast<std::size_t>(i)].as_numbers();
    if (axis.size() != 3) axes[static_cast<std::size_t>(i)].complain("has not three numbers");
    base_from_first_joint.rotation.col(i) << axis[0], axis[1], axis[2];
  }
  return base_from_first_joint.inverse();
}

std::vector<Eigen::Vector3d> corners_of_volume(const DocumentView& volume) {
  const Eigen::Vector3d low = point_under(volume, "low");
  const Eigen::Vector3d high = point_under(volume, "high");
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {low.x(), high.x()}) {
    for (const double y : {low.y(), high.y()}) {
      for (const double z : {low.z(), high.z()}) corners.emplace_back(x, y, z);
    }
  }
  return corners;
}

double positive(const DocumentView& view, std::string_view key) {
  const double value = view.number(key);
  if (!(std::isfinite(value) && value > 0.0)) view[key].complain("is not larger than 0");
  return value;
}

PlanScene surroundings_of(const DocumentView& document) {
  const DocumentView around = document["surroundings"];
  PlanScene scene;
  scene.reach_mm = positive(document, "reach_mm");
  scene.sphere_diameter_mm = document["wishes"].number("sphere_diameter_mm");
  scene.bench_mm = around.number_if("bench_mm");
  scene.column_radius_mm = around.number("column_radius_mm");
  scene.column_top_mm = around.number("column_top_mm");
  if (around.has("volume_mm")) {
    const RigidTransform first_joint = first_joint_from_base(around);
    for (const Eigen::Vector3d& each : corners_of_volume(around["volume_mm"])) {
      scene.volume_corners_mm.push_back(first_joint * each);
    }
  }
  return scene;
}

PlanScene scene_of(const DocumentView& document, const std::vector<DocumentView>& tests,
                   const Language& say) {
  const RigidTransform first_joint = first_joint_from_base(document["surroundings"]);
  PlanScene scene = surroundings_of(document);
  for (const DocumentView& test : tests) {
    for (const DocumentView& bar : test.list("bars")) {
      const std::vector<double> lengths = bar.numbers("lengths_mm");
      scene.bars.push_back({plan_position(bar.text("position"), say),
                            first_joint * point_under(bar, "end_A_mm"),
                            first_joint * point_under(bar, "end_B_mm"),
                            !lengths.empty() && lengths.back() > scene.reach_mm});
    }
    for (const DocumentView& sphere : test.list("spheres")) {
      scene.spheres.push_back(
          {sphere_label(test, sphere, say), first_joint * point_under(sphere, "center_mm")});
    }
    for (const DocumentView& seat : test.list("seats")) {
      scene.seats.push_back(
          {say("verification_plan.seat_label", plan_position(seat.text("zone"), say)),
           first_joint * point_under(seat, "at_mm")});
    }
  }
  return scene;
}

DrawnLegend legend_of(double y, const Language& say) {
  constexpr double kMargin = 4.0;
  return scene_legend(
      {say("verification_plan.legend.sphere"), say("verification_plan.legend.seat"),
       say("verification_plan.legend.bar"), say("verification_plan.legend.long_bar"),
       say("verification_plan.legend.zones"), say("verification_plan.legend.solid")},
      kMargin, y, kSceneSize - 2.0 * kMargin);
}

Figure view_of(const PlanScene& scene, bool from_above, const std::string& id,
               const Language& say) {
  Figure figure;
  figure.id = fmt::format("{}-{}", id, from_above ? "top" : "side");
  figure.title = say(from_above ? "verification_plan.from_above" : "verification_plan.from_side");
  figure.text =
      say(from_above ? "verification_plan.from_above_text" : "verification_plan.from_side_text");
  const DrawnLegend legend = legend_of(kSceneSize + 18.0, say);
  figure.svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"armcal-plan\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" role=\"img\" style=\"width:100%;max-width:{2:.0f}px\">\n<title>{3}</title>\n{4}"
      "<clipPath id=\"{5}-clip\"><rect width=\"{0:.0f}\" height=\"{0:.0f}\"/></clipPath>\n"
      "<g clip-path=\"url(#{5}-clip)\">\n{6}</g>\n{7}{8}</svg>\n",
      kSceneSize, kSceneSize + 12.0 + legend.height, 1.25 * kSceneSize, xml_escaped(figure.title),
      kFigureStyle, figure.id, scene_shapes(scene, from_above),
      scene_box("frame", {0.5, 0.5}, {kSceneSize - 0.5, kSceneSize - 0.5}), legend.shapes);
  return figure;
}

}  // namespace

Eigen::Vector3d point_under(const DocumentView& view, std::string_view key) {
  const std::vector<double> point = view.numbers(key);
  if (point.size() != 3) view[key].complain("has not three numbers");
  const Eigen::Vector3d found(point[0], point[1], point[2]);
  if (!found.allFinite()) view[key].complain("holds what is not a number");
  return found;
}

Figures plan_figures(const DocumentView& document, const std::vector<DocumentView>& tests,
                     const std::string& id, const Language& say) {
  if (!document.has("surroundings")) return {};
  const PlanScene scene = scene_of(document, tests, say);
  return {{view_of(scene, true, id, say), view_of(scene, false, id, say)}};
}

std::string plan_position(const std::string& name, const Language& say) {
  return in_language(name, "verification_plan.phrase", say);
}

}  // namespace armcal
