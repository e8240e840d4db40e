// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/posture_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {
namespace {

constexpr const char* kLinkFill = "var(--arm-link, #aeb6bf)";
constexpr const char* kJointFill = "var(--arm-joint, #8993a0)";
constexpr const char* kCapFill = "var(--arm-cap, #d5dbe1)";
constexpr const char* kEdge = "var(--arm-edge, #4b5563)";
constexpr const char* kTipFill = "var(--arm-tip, #b3202c)";

// Radius of the first joint in the drawing, of the last in that of the first, and how long a
// joint's cylinder is in its radius.
constexpr double kThickest = 10.5;
constexpr double kLastPart = 0.55;
constexpr double kHalfLength = 1.15;
constexpr double kTipRadius = 3.6;

double radius_of(int joint, int count) {
  const double part = count > 1 ? static_cast<double>(joint) / (count - 1) : 0.0;
  return kThickest * std::lerp(1.0, kLastPart, part);
}

std::string filled(const char* style, const std::string& fill) {
  return fmt::format(
      "class=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1\" stroke-linejoin=\"round\"", style,
      fill, kEdge);
}

std::string path(const std::string& d, const std::string& attributes) {
  return fmt::format("<path d=\"{}\" {}/>\n", d, attributes);
}

std::string xy(const Eigen::Vector2d& at) { return point(at.x(), at.y()); }

Eigen::Vector2d across(const Eigen::Vector2d& along) {
  const double length = along.norm();
  if (length < 1e-9) return {1.0, 0.0};
  return Eigen::Vector2d(-along.y(), along.x()) / length;
}

std::string tapered(const Eigen::Vector2d& from, double from_half, const Eigen::Vector2d& to,
                    double to_half) {
  const Eigen::Vector2d side = across(to - from);
  return fmt::format("M{}L{}L{}L{}z", xy(from + from_half * side), xy(to + to_half * side),
                     xy(to - to_half * side), xy(from - from_half * side));
}

// A cylinder: the mantle with the round of its far end, then the cap that faces the eye.
std::string cylinder(const Eigen::Vector2d& middle, Eigen::Vector3d axis, double half_length,
                     double radius, const std::string& mantle_fill, const std::string& cap_fill) {
  if (axis.z() < 0.0) axis = -axis;
  const Eigen::Vector2d half = half_length * axis.head<2>();
  const Eigen::Vector2d side = across(half);
  const Eigen::Vector2d near = middle + half;
  const Eigen::Vector2d far = middle - half;
  const double degrees = std::atan2(side.y(), side.x()) * 180.0 / std::numbers::pi;
  const std::string arc =
      fmt::format("A{} {} {} 0 0 ", coordinate(radius),
                  coordinate(std::max(0.01, radius * axis.z())), coordinate(degrees));
  const std::string one = xy(near + radius * side);
  const std::string other = xy(near - radius * side);
  return path(fmt::format("M{}L{}L{}L{}{}{}z", xy(far + radius * side), one, other,
                          xy(far - radius * side), arc, xy(far + radius * side)),
              filled("joint", mantle_fill)) +
         path(fmt::format("M{}{}{}{}{}z", one, arc, other, arc, one), filled("cap", cap_fill));
}

PaintedPiece pedestal(const StandingArm& arm, const SpaceView& view, double ground_mm) {
  const Eigen::Vector3d top = arm.point(0);
  const Eigen::Vector3d foot = on_ground(top, view.up(), ground_mm);
  const Eigen::Vector3d up = view.direction(view.up());
  const double radius = 1.25 * kThickest;
  const double height = view.scale() * (top - foot).norm();
  std::string svg = cylinder(view.at(foot), up, 2.0, 1.7 * radius, kJointFill, kCapFill);
  svg += cylinder(view.at(0.5 * (top + foot)), up, 0.5 * height, radius, kLinkFill, kCapFill);
  // Everything else stands on it.
  return {-std::numeric_limits<double>::infinity(), svg};
}

}  // namespace

std::optional<StandingArm> standing(const ArmModel& arm, const Eigen::VectorXd& q_rad) {
  if (q_rad.size() != arm.joint_count() || !q_rad.allFinite()) return {};
  const ForwardKinematics kinematics(arm);
  const TipLinearisation at =
      kinematics.linearise(std::span(q_rad.data(), static_cast<std::size_t>(q_rad.size())));
  return StandingArm{at.joint_origins_mm, at.joint_axes, at.tip_mm};
}

std::vector<PaintedPiece> solid_pieces(const StandingArm& arm, const SpaceView& view,
                                       double ground_mm, int emphasised) {
  const int n = arm.joint_count();
  std::vector<PaintedPiece> pieces = {pedestal(arm, view, ground_mm)};
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d from = arm.point(i);
    const Eigen::Vector3d to = arm.point(i + 1);
    const double half = 0.62 * radius_of(i, n);
    const double end = i + 1 < n ? 0.62 * radius_of(i + 1, n) : 1.0;
    const double length = (view.at(to) - view.at(from)).norm();
    if (length > 0.5) {
      // As near as its quarter at the joint that carries it.
      pieces.push_back(
          {view.nearness(0.75 * from + 0.25 * to),
           path(tapered(view.at(from), half, view.at(to), end), filled("link", kLinkFill))});
    }
    const bool is_marked = i == emphasised;
    pieces.push_back(
        {view.nearness(from) + 1e-6 * i,
         cylinder(view.at(from), view.direction(arm.axes.col(i)), kHalfLength * radius_of(i, n),
                  radius_of(i, n), is_marked ? series_colour(1) : kJointFill,
                  is_marked ? series_colour(4) : kCapFill)});
  }
  const Eigen::Vector2d tip = view.at(arm.tip_mm);
  pieces.push_back(
      {view.nearness(arm.tip_mm),
       fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", coordinate(tip.x()),
                   coordinate(tip.y()), coordinate(kTipRadius), filled("tip", kTipFill))});
  return pieces;
}

std::string dashed_arm(const StandingArm& arm, const SpaceView& view) {
  std::string line;
  std::string joints;
  for (int i = 0; i <= arm.joint_count(); ++i) {
    const Eigen::Vector2d at = view.at(arm.point(i));
    line += fmt::format("{}{}", i == 0 ? "M" : "L", xy(at));
    if (i < arm.joint_count()) joints += fmt::format("M{}h0", xy(at));
  }
  const Eigen::Vector2d tip = view.at(arm.tip_mm);
  return path(line,
              "class=\"ghost\" stroke=\"currentColor\" stroke-opacity=\".7\" "
              "stroke-width=\"2.4\" stroke-dasharray=\"6 4\" stroke-linejoin=\"round\"") +
         path(joints,
              "class=\"ghost\" stroke=\"currentColor\" stroke-opacity=\".7\" "
              "stroke-width=\"7\" stroke-linecap=\"round\"") +
         fmt::format(
             "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"tip\" fill=\"{}\" "
             "stroke=\"{}\" stroke-width=\"2\"/>\n",
             coordinate(tip.x()), coordinate(tip.y()), coordinate(kTipRadius), kPaperColour,
             kTipFill);
}

std::string shadow(const StandingArm& arm, const SpaceView& view, double ground_mm) {
  std::string line;
  for (int i = 0; i <= arm.joint_count(); ++i) {
    const Eigen::Vector2d at = view.at(on_ground(arm.point(i), view.up(), ground_mm));
    line += fmt::format("{}{}", i == 0 ? "M" : "L", xy(at));
  }
  return path(line,
              "class=\"shadow\" stroke=\"currentColor\" stroke-opacity=\".1\" "
              "stroke-width=\"9\" stroke-linejoin=\"round\" stroke-linecap=\"round\"");
}

Eigen::Vector3d on_ground(const Eigen::Vector3d& point, const Eigen::Vector3d& up,
                          double ground_mm) {
  return point + (ground_mm - up.dot(point)) * up;
}

}  // namespace armcal
