// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_plan_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/io/xml_text.h"
#include "armcal/report/label_places.h"

namespace armcal {
namespace {

constexpr double kPanel = 560.0;   // width and height of a view
constexpr double kMargin = 24.0;   // about each
constexpr double kTitle = 30.0;    // height of a line of titles
constexpr double kLegend = 46.0;   // height of the legend
constexpr double kReach = 250.0;   // of the arm, in the drawing
constexpr double kBench = 14.0;    // thickness of the bench, in the drawing
constexpr double kMarkSize = 6.0;  // half of a seat, least half of a sphere
constexpr double kZones[] = {0.2, 0.8, 1.0};

constexpr const char* kStyle = R"(<style>
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

std::string text_at(double x, double y, const char* style, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", style, x, y,
                     xml_escaped(text));
}

std::string line(const char* style, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style,
      from.x(), from.y(), to.x(), to.y());
}

std::string circle(const char* style, const Eigen::Vector2d& at, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", style,
                     at.x(), at.y(), radius);
}

std::string box(const char* style, const Eigen::Vector2d& corner, const Eigen::Vector2d& other) {
  const Eigen::Vector2d low = corner.cwiseMin(other);
  const Eigen::Vector2d size = (corner - other).cwiseAbs();
  return fmt::format(
      "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", style,
      low.x(), low.y(), size.x(), size.y());
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

// One of the two views of a standard: draws in its own square, y downwards.
class View {
 public:
  View(const VerificationPlan& plan, bool from_above)
      : plan_(plan), from_above_(from_above), scale_(kReach / plan.reach_mm) {}

  [[nodiscard]] std::string drawing(bool of_iso) {
    std::string shapes = surroundings();
    for (const PlannedTest& test : plan_.tests) {
      if (test.is_of_iso != of_iso) continue;
      for (const PlannedBar& bar : test.bars) shapes += drawn(bar);
      for (const PlannedSphere& sphere : test.spheres) shapes += drawn(test, sphere);
      for (const PlannedSeat& seat : test.seats) shapes += drawn(seat);
    }
    for (const auto& [text, at] : wanted_) {
      const PlacedLabel label = labels_.place(text, at.x(), at.y());
      shapes += text_at(label.x, label.y, "label", label.text);
    }
    return shapes;
  }

 private:
  // A point of the frame of the first joint.
  [[nodiscard]] Eigen::Vector2d in_drawing(const Eigen::Vector3d& p) const {
    const double half = 0.5 * kPanel;
    return {half + scale_ * p.x(), half - scale_ * (from_above_ ? p.y() : p.z())};
  }
  [[nodiscard]] Eigen::Vector2d of_base(const Eigen::Vector3d& point) const {
    return in_drawing(plan_.arm.base_from_first_joint.inverse() * point);
  }

  [[nodiscard]] std::string surroundings() {
    const Surroundings& around = plan_.wishes.room.surroundings;
    const Eigen::Vector2d centre = in_drawing(Eigen::Vector3d::Zero());
    std::string shapes;
    for (const double share : kZones) {
      shapes += circle("zone", centre, share * kReach);
      const Eigen::Vector2d top = centre - Eigen::Vector2d(0.0, share * kReach);
      wanted_.emplace_back(fmt::format("{:.0f} %", 100.0 * share), top);
    }
    const double bench = around.bench_mm.value_or(-plan_.reach_mm);
    if (around.bench_mm && !from_above_) {
      const double top = in_drawing({0.0, 0.0, bench}).y();
      shapes += box("paper", {0.0, top}, {kPanel, kPanel});
      shapes += box("solid", {0.0, top}, {kPanel, std::min(kPanel, top + kBench)});
    }
    const double radius = around.column_radius_mm;
    if (radius > 0.0) {
      shapes += from_above_ ? circle("solid", centre, scale_ * radius)
                            : box("solid", in_drawing({-radius, 0.0, around.column_top_mm}),
                                  in_drawing({radius, 0.0, bench}));
    }
    shapes += line("frame", centre - Eigen::Vector2d(8, 0), centre + Eigen::Vector2d(8, 0));
    shapes += line("frame", centre - Eigen::Vector2d(0, 8), centre + Eigen::Vector2d(0, 8));
    return shapes + measuring_volume();
  }

  // The box as its outline: of an arm that stands askew, the box about its corners.
  [[nodiscard]] std::string measuring_volume() const {
    const auto& volume = plan_.wishes.room.volume;
    if (!volume) return "";
    Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL);
    Eigen::Vector2d high = -low;
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d point = volume->low_mm;
      for (int axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) != 0) point(axis) = volume->high_mm(axis);
      }
      low = low.cwiseMin(of_base(point));
      high = high.cwiseMax(of_base(point));
    }
    const Eigen::Vector2d edge = Eigen::Vector2d::Constant(kPanel);
    return box("volume", low.cwiseMax(Eigen::Vector2d::Zero()), high.cwiseMin(edge));
  }

  [[nodiscard]] std::string drawn(const PlannedBar& bar) {
    const Eigen::Vector2d from = of_base(bar.from_mm);
    const Eigen::Vector2d to = of_base(bar.to_mm);
    labels_.reserve_line(from.x(), from.y(), to.x(), to.y());
    wanted_.emplace_back(bar.position, from);
    const bool is_long = bar.lengths_mm.back() > plan_.reach_mm;
    return bar_line(from, to, is_long);
  }

  [[nodiscard]] std::string drawn(const PlannedTest& test, const PlannedSphere& sphere) {
    const Eigen::Vector2d at = of_base(sphere.centre_mm);
    const double radius = std::max(kMarkSize, 0.5 * scale_ * plan_.wishes.sphere_diameter_mm);
    labels_.reserve(at.x(), at.y(), radius);
    wanted_.emplace_back(fmt::format("{} ({})", purpose(test), sphere.position), at);
    return circle("mark", at, radius);
  }

  [[nodiscard]] std::string drawn(const PlannedSeat& seat) {
    const Eigen::Vector2d at = of_base(seat.at_mm);
    labels_.reserve(at.x(), at.y(), kMarkSize);
    wanted_.emplace_back(seat.zone + " seat", at);
    return seat_mark(at);
  }

  [[nodiscard]] static std::string purpose(const PlannedTest& test) {
    if (test.name == "probing") return "probing";
    return test.is_of_iso ? "articulated" : "diameter";
  }

  const VerificationPlan& plan_;
  bool from_above_;
  double scale_;
  LabelPlaces labels_{kPanel, kPanel};
  std::vector<std::pair<std::string, Eigen::Vector2d>> wanted_;
};

std::string view(const VerificationPlan& plan, bool of_iso, bool from_above, double x, double y) {
  const std::string clip = fmt::format("clip{}{}", of_iso ? "i" : "b", from_above ? "p" : "s");
  std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", x, y);
  svg += fmt::format("<clipPath id=\"{}\"><rect width=\"{}\" height=\"{}\"/></clipPath>\n", clip,
                     kPanel, kPanel);
  svg += fmt::format("<g clip-path=\"url(#{})\">\n{}</g>\n", clip,
                     View(plan, from_above).drawing(of_iso));
  svg += box("frame", {0.0, 0.0}, {kPanel, kPanel});
  svg += text_at(8.0, kPanel - 10.0, "small label",
                 from_above ? "from above: x to the right, y up"
                            : "from the side: x to the right, first axis up");
  return svg + "</g>\n";
}

std::string legend(double y) {
  double x = kMargin + kMarkSize;
  std::string svg;
  const auto add = [&](const std::string& mark, double width, const std::string& text) {
    svg += mark + text_at(x + width, y + 4.0, "small", text);
    x += width + 24.0 + 6.0 * static_cast<double>(text.size());
  };
  const auto bar_mark = [&](bool dashed) {
    return bar_line({x - kMarkSize, y}, {x + 34.0, y}, dashed);
  };
  add(circle("mark", {x, y}, kMarkSize), 14.0, "sphere");
  add(seat_mark({x, y}), 14.0, "seat");
  add(bar_mark(false), 44.0, "bar, end A filled");
  add(bar_mark(true), 44.0, "bar longer than the reach");
  add(circle("zone", {x, y}, kMarkSize), 14.0, "shares of the reach about joint 1");
  add(box("solid", {x - kMarkSize, y - kMarkSize}, {x + kMarkSize, y + kMarkSize}), 14.0,
      "column and bench");
  return svg;
}

}  // namespace

std::string verification_picture(const VerificationPlan& plan) {
  std::string body;
  double y = kMargin;
  const auto add_standard = [&](bool of_iso, const char* title) {
    body += text_at(kMargin, y + 16.0, "title",
                    fmt::format("{}: {}", title, plan.arm.name.empty() ? "arm" : plan.arm.name));
    y += kTitle;
    body += view(plan, of_iso, true, kMargin, y);
    body += view(plan, of_iso, false, 2.0 * kMargin + kPanel, y);
    y += kPanel + kMargin;
  };
  if (plan.wishes.iso10360_12) add_standard(true, "ISO 10360-12");
  if (plan.wishes.b89_4_22) add_standard(false, "ASME B89.4.22");
  body += legend(y);
  const double width = 2.0 * kPanel + 3.0 * kMargin;
  const double height = y + kLegend - kMargin;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\">\n",
             width, height) +
         kStyle +
         fmt::format("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width,
                     height) +
         body + "</svg>\n";
}

}  // namespace armcal
