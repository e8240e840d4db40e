// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/plan_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/io/xml_text.h"
#include "armcal/report/chart/svg.h"
#include "armcal/report/label_places.h"

namespace armcal {
namespace {

constexpr double kReach = 250.0;   // of the arm, in the drawing
constexpr double kBench = 14.0;    // thickness of the bench, in the drawing
constexpr double kMarkSize = 6.0;  // half of a seat, least half of a sphere
constexpr double kZones[] = {0.2, 0.8, 1.0};

std::string line(const char* style, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style,
      from.x(), from.y(), to.x(), to.y());
}

std::string circle(const char* style, const Eigen::Vector2d& at, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", style,
                     at.x(), at.y(), radius);
}

std::string seat_mark(const Eigen::Vector2d& at) {
  const double s = kMarkSize;
  return fmt::format("<path class=\"mark\" d=\"M {:.1f} {:.1f} l {:.1f} {:.1f} h {:.1f} z\"/>\n",
                     at.x(), at.y() + s, -s, -2.0 * s, 2.0 * s);
}

std::string bar_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool dashed) {
  return line(dashed ? "bar long" : "bar", from, to) + circle("end", from, 3.5) +
         circle("mark", to, 3.0);
}

// Draws in a square of kSceneSize, y downwards.
class View {
 public:
  View(const PlanScene& scene, bool from_above)
      : scene_(scene), from_above_(from_above), scale_(kReach / scene.reach_mm) {}

  [[nodiscard]] std::string drawing() {
    std::string shapes = surroundings();
    for (const PlanScene::Bar& bar : scene_.bars) shapes += drawn(bar);
    for (const PlanScene::Place& sphere : scene_.spheres) shapes += drawn_sphere(sphere);
    for (const PlanScene::Place& seat : scene_.seats) shapes += drawn_seat(seat);
    for (const auto& [text, at] : wanted_) {
      const PlacedLabel label = labels_.place(text, at.x(), at.y());
      shapes += scene_text(label.x, label.y, "label", label.text);
    }
    return shapes;
  }

 private:
  [[nodiscard]] Eigen::Vector2d in_drawing(const Eigen::Vector3d& p) const {
    const double half = 0.5 * kSceneSize;
    return {half + scale_ * p.x(), half - scale_ * (from_above_ ? p.y() : p.z())};
  }

  [[nodiscard]] std::string surroundings() {
    const Eigen::Vector2d centre = in_drawing(Eigen::Vector3d::Zero());
    std::string shapes;
    for (const double share : kZones) {
      shapes += circle("zone", centre, share * kReach);
      const Eigen::Vector2d top = centre - Eigen::Vector2d(0.0, share * kReach);
      wanted_.emplace_back(fmt::format("{:.0f} %", 100.0 * share), top);
    }
    const double bench = scene_.bench_mm.value_or(-scene_.reach_mm);
    if (scene_.bench_mm && !from_above_) {
      const double top = in_drawing({0.0, 0.0, bench}).y();
      shapes += scene_box("paper", {0.0, top}, {kSceneSize, kSceneSize});
      shapes += scene_box("solid", {0.0, top}, {kSceneSize, std::min(kSceneSize, top + kBench)});
    }
    const double radius = scene_.column_radius_mm;
    if (radius > 0.0) {
      shapes += from_above_ ? circle("solid", centre, scale_ * radius)
                            : scene_box("solid", in_drawing({-radius, 0.0, scene_.column_top_mm}),
                                        in_drawing({radius, 0.0, bench}));
    }
    shapes += line("frame", centre - Eigen::Vector2d(8, 0), centre + Eigen::Vector2d(8, 0));
    shapes += line("frame", centre - Eigen::Vector2d(0, 8), centre + Eigen::Vector2d(0, 8));
    return shapes + measuring_volume();
  }

  // The box as its outline: of an arm that stands askew, the box about its corners.
  [[nodiscard]] std::string measuring_volume() const {
    if (scene_.volume_corners_mm.empty()) return "";
    Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL);
    Eigen::Vector2d high = -low;
    for (const Eigen::Vector3d& corner : scene_.volume_corners_mm) {
      low = low.cwiseMin(in_drawing(corner));
      high = high.cwiseMax(in_drawing(corner));
    }
    const Eigen::Vector2d edge = Eigen::Vector2d::Constant(kSceneSize);
    return scene_box("volume", low.cwiseMax(Eigen::Vector2d::Zero()), high.cwiseMin(edge));
  }

  [[nodiscard]] std::string drawn(const PlanScene::Bar& bar) {
    const Eigen::Vector2d from = in_drawing(bar.from_mm);
    const Eigen::Vector2d to = in_drawing(bar.to_mm);
    labels_.reserve_line(from.x(), from.y(), to.x(), to.y());
    wanted_.emplace_back(bar.label, from);
    return bar_line(from, to, bar.is_longer_than_reach);
  }

  [[nodiscard]] std::string drawn_sphere(const PlanScene::Place& sphere) {
    const Eigen::Vector2d at = in_drawing(sphere.at_mm);
    const double radius = std::max(kMarkSize, 0.5 * scale_ * scene_.sphere_diameter_mm);
    labels_.reserve(at.x(), at.y(), radius);
    wanted_.emplace_back(sphere.label, at);
    return circle("mark", at, radius);
  }

  [[nodiscard]] std::string drawn_seat(const PlanScene::Place& seat) {
    const Eigen::Vector2d at = in_drawing(seat.at_mm);
    labels_.reserve(at.x(), at.y(), kMarkSize);
    wanted_.emplace_back(seat.label, at);
    return seat_mark(at);
  }

  const PlanScene& scene_;
  bool from_above_;
  double scale_;
  LabelPlaces labels_{kSceneSize, kSceneSize};
  std::vector<std::pair<std::string, Eigen::Vector2d>> wanted_;
};

}  // namespace

std::string scene_text(double x, double y, const char* style, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", style, x, y,
                     xml_escaped(text));
}

std::string scene_box(const char* style, const Eigen::Vector2d& corner,
                      const Eigen::Vector2d& other) {
  const Eigen::Vector2d low = corner.cwiseMin(other);
  const Eigen::Vector2d size = (corner - other).cwiseAbs();
  return fmt::format(
      "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", style,
      low.x(), low.y(), size.x(), size.y());
}

std::string scene_shapes(const PlanScene& scene, bool from_above) {
  return View(scene, from_above).drawing();
}

DrawnLegend scene_legend(const SceneLegend& words, double x, double y, double width) {
  constexpr double kSize = 11.0, kRow = 20.0, kGap = 24.0;
  DrawnLegend legend;
  double at = x;
  const auto add = [&](const auto& mark, double mark_width, const std::string& text) {
    const double wanted = mark_width + text_width(text, kSize);
    if (at > x && at + wanted > x + width) {
      at = x;
      y += kRow;
      legend.height += kRow;
    }
    legend.shapes += mark(Eigen::Vector2d(at + kMarkSize, y)) +
                     scene_text(at + kMarkSize + mark_width, y + 4.0, "small", text);
    at += wanted + kGap;
  };
  const auto bar_mark = [](bool dashed) {
    return [dashed](const Eigen::Vector2d& p) {
      return bar_line({p.x() - kMarkSize, p.y()}, {p.x() + 34.0, p.y()}, dashed);
    };
  };
  legend.height = kRow;
  add([](const Eigen::Vector2d& p) { return circle("mark", p, kMarkSize); }, 14.0, words.sphere);
  add([](const Eigen::Vector2d& p) { return seat_mark(p); }, 14.0, words.seat);
  add(bar_mark(false), 44.0, words.bar);
  add(bar_mark(true), 44.0, words.long_bar);
  add([](const Eigen::Vector2d& p) { return circle("zone", p, kMarkSize); }, 14.0, words.zones);
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(kMarkSize);
  add([&](const Eigen::Vector2d& p) { return scene_box("solid", p - half, p + half); }, 14.0,
      words.solid);
  return legend;
}

}  // namespace armcal
