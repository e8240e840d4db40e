// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace armcal {

/// What is drawn of a plan of one standard: where its artefacts stand about the arm. Points are in
/// the frame of the first joint (z along its axis), mm.
struct PlanScene {
  struct Place {
    std::string label;
    Eigen::Vector3d at_mm;
  };
  struct Bar {
    std::string label;
    Eigen::Vector3d from_mm;  ///< end A
    Eigen::Vector3d to_mm;
    bool is_longer_than_reach = false;
  };

  double reach_mm = 0.0;
  double sphere_diameter_mm = 0.0;
  std::optional<double> bench_mm;  ///< height of the bench
  double column_radius_mm = 0.0;   ///< 0: none
  double column_top_mm = 0.0;
  std::vector<Eigen::Vector3d> volume_corners_mm;  ///< of the measuring volume; empty: none
  std::vector<Place> spheres, seats;
  std::vector<Bar> bars;
};

/// Width and height of a view.
inline constexpr double kSceneSize = 560.0;

/// The scene from above (x to the right, y up) or from the side (x to the right, first axis up):
/// SVG shapes of the classes title, small, label, paper, frame, zone, volume, solid, mark, bar,
/// long, end, whose look the caller's style sheet says. Labels keep off shapes and off each other.
[[nodiscard]] std::string scene_shapes(const PlanScene& scene, bool from_above);

/// A sample of each sign with its word, in rows no wider than `width`.
struct SceneLegend {
  std::string sphere, seat, bar, long_bar, zones, solid;
};
struct DrawnLegend {
  std::string shapes;
  double height = 0.0;
};
[[nodiscard]] DrawnLegend scene_legend(const SceneLegend& words, double x, double y, double width);

// SVG of single things, for what stands around a scene.
[[nodiscard]] std::string scene_text(double x, double y, const char* style,
                                     const std::string& text);
[[nodiscard]] std::string scene_box(const char* style, const Eigen::Vector2d& corner,
                                    const Eigen::Vector2d& other);

}  // namespace armcal
