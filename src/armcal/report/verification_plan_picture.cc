// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_plan_picture.h"

#include <fmt/format.h>

#include "armcal/report/plan_scene.h"

namespace armcal {
namespace {

constexpr double kPictureMargin = 24.0;  // about each view
constexpr double kTitle = 30.0;          // height of a line of titles
constexpr double kPictureWidth = 2.0 * kSceneSize + 3.0 * kPictureMargin;

constexpr const char* kPictureStyle = R"(<style>
  text { font-family: sans-serif; font-size: 12px; fill: #111; }
  .title { font-size: 16px; font-weight: bold; }
  .small { font-size: 11px; fill: #555; }
  .label { paint-order: stroke; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; }
  .paper { fill: #fff; }
  .frame, .zone { fill: none; stroke: #888; stroke-width: 1; }
  .zone { stroke-dasharray: 2 4; }
  .volume { fill: none; stroke: #555; stroke-width: 1; stroke-dasharray: 8 3 2 3; }
  .solid { fill: #bbb; stroke: #555; stroke-width: 1; }
  .mark { fill: #fff; stroke: #111; stroke-width: 1.6; }
  .bar { fill: none; stroke: #111; stroke-width: 1.8; }
  .long { stroke-dasharray: 9 5; }
  .end { fill: #111; stroke: none; }
  @media (prefers-color-scheme: dark) {
    text { fill: #eee; } .small { fill: #aaa; } .label { stroke: #15171a; } .paper { fill: #15171a; }
    .frame, .zone { stroke: #888; } .volume { stroke: #aaa; } .solid { fill: #444; stroke: #aaa; }
    .mark { fill: #15171a; stroke: #eee; } .bar { stroke: #eee; } .end { fill: #eee; }
  }
</style>
)";

std::string purpose(const PlannedTest& test) {
  if (test.name == "probing") return "probing";
  return test.is_of_iso ? "articulated" : "diameter";
}

std::vector<Eigen::Vector3d> corners_of(const MeasuringVolume& volume) {
  std::vector<Eigen::Vector3d> corners;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d point = volume.low_mm;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0) point(axis) = volume.high_mm(axis);
    }
    corners.push_back(point);
  }
  return corners;
}

PlanScene scene_of(const VerificationPlan& plan, bool of_iso) {
  const RigidTransform first_joint_from_base = plan.arm.base_from_first_joint.inverse();
  const Surroundings& around = plan.wishes.room.surroundings;
  PlanScene scene;
  scene.reach_mm = plan.reach_mm;
  scene.sphere_diameter_mm = plan.wishes.sphere_diameter_mm;
  scene.bench_mm = around.bench_mm;
  scene.column_radius_mm = around.column_radius_mm;
  scene.column_top_mm = around.column_top_mm;
  if (const auto& volume = plan.wishes.room.volume) {
    for (const Eigen::Vector3d& corner : corners_of(*volume)) {
      scene.volume_corners_mm.push_back(first_joint_from_base * corner);
    }
  }
  for (const PlannedTest& test : plan.tests) {
    if (test.is_of_iso != of_iso) continue;
    for (const PlannedBar& bar : test.bars) {
      scene.bars.push_back({bar.position, first_joint_from_base * bar.from_mm,
                            first_joint_from_base * bar.to_mm,
                            bar.lengths_mm.back() > plan.reach_mm});
    }
    for (const PlannedSphere& sphere : test.spheres) {
      scene.spheres.push_back({fmt::format("{} ({})", purpose(test), sphere.position),
                               first_joint_from_base * sphere.centre_mm});
    }
    for (const PlannedSeat& seat : test.seats) {
      scene.seats.push_back(
          {fmt::format("{} seat", seat.zone), first_joint_from_base * seat.at_mm});
    }
  }
  return scene;
}

std::string view(const PlanScene& scene, bool of_iso, bool from_above, double x, double y) {
  const std::string clip = fmt::format("clip{}{}", of_iso ? "i" : "b", from_above ? "p" : "s");
  std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", x, y);
  svg += fmt::format("<clipPath id=\"{}\"><rect width=\"{}\" height=\"{}\"/></clipPath>\n", clip,
                     kSceneSize, kSceneSize);
  svg += fmt::format("<g clip-path=\"url(#{})\">\n{}</g>\n", clip, scene_shapes(scene, from_above));
  svg += scene_box("frame", {0.0, 0.0}, {kSceneSize, kSceneSize});
  svg += scene_text(8.0, kSceneSize - 10.0, "small label",
                    from_above ? "from above: x to the right, y up"
                               : "from the side: x to the right, first axis up");
  return svg + "</g>\n";
}

DrawnLegend legend(double y) {
  return scene_legend({"sphere", "seat", "bar, end A filled", "bar longer than the reach",
                       "shares of the reach about joint 1", "column and bench"},
                      kPictureMargin, y, kPictureWidth - 2.0 * kPictureMargin);
}

}  // namespace

std::string verification_picture(const VerificationPlan& plan) {
  std::string body;
  double y = kPictureMargin;
  const auto add_standard = [&](bool of_iso, const char* title) {
    const PlanScene scene = scene_of(plan, of_iso);
    body += scene_text(kPictureMargin, y + 16.0, "title",
                       fmt::format("{}: {}", title, plan.arm.name.empty() ? "arm" : plan.arm.name));
    y += kTitle;
    body += view(scene, of_iso, true, kPictureMargin, y);
    body += view(scene, of_iso, false, 2.0 * kPictureMargin + kSceneSize, y);
    y += kSceneSize + kPictureMargin;
  };
  if (plan.wishes.iso10360_12) add_standard(true, "ISO 10360-12");
  if (plan.wishes.b89_4_22) add_standard(false, "ASME B89.4.22");
  const DrawnLegend words = legend(y);
  body += words.shapes;
  const double height = y + words.height;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\">\n",
             kPictureWidth, height) +
         kPictureStyle +
         fmt::format("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kPictureWidth,
                     height) +
         body + "</svg>\n";
}

}  // namespace armcal
