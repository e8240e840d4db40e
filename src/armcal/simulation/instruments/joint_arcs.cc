// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/joint_arcs.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/observations/empty_group.h"

namespace armcal {
namespace {

constexpr int kHomes = 200;
constexpr double kSmallestChord_mm = 10.0;

struct Range {
  double low_rad, high_rad;
};

// How far a joint turns from home before something is in its way, in steps of 5 deg.
Range free_range(const VirtualArm& arm, const Eigen::VectorXd& home, Eigen::Index joint,
                 double span_rad) {
  const double step = radians_from_degrees(5.0);
  Range range{home(joint), home(joint)};
  for (const double way : {1.0, -1.0}) {
    Eigen::VectorXd posture = home;
    double& end = way > 0.0 ? range.high_rad : range.low_rad;
    for (;;) {
      const double next = way * std::min(std::abs(end - home(joint)) + step, span_rad / 2.0);
      posture(joint) = home(joint) + next;
      if (posture(joint) == end || arm.obstacle(posture)) break;
      end = posture(joint);
    }
  }
  return range;
}

struct Home {
  Eigen::VectorXd posture;
  std::vector<Range> ranges;
  double smallest_chord_mm = -1.0;
  int joint = 0;  // that has it, from 1
};

// Longest chord of the arc that the tip draws about each joint: what its axis is known by.
Home home_at(const VirtualArm& arm, const Eigen::VectorXd& posture, double span_rad) {
  const TipLinearisation at = ForwardKinematics(arm.nominal()).linearise(as_span(posture));
  Home home{posture, {}};
  for (Eigen::Index j = 0; j < posture.size(); ++j) {
    home.ranges.push_back(free_range(arm, posture, j, span_rad));
    const Range& range = home.ranges.back();
    const double half = std::min(range.high_rad - range.low_rad, std::numbers::pi) / 2.0;
    const double chord_mm = 2.0 * at.J_tip_encoder.col(j).norm() * std::sin(half);
    if (j > 0 && chord_mm >= home.smallest_chord_mm) continue;
    home.smallest_chord_mm = chord_mm;
    home.joint = static_cast<int>(j) + 1;
  }
  return home;
}

Home best_home(Laboratory& laboratory, const JointArcs& arcs) {
  Home best;
  for (int i = 0; i < kHomes; ++i) {
    Home home = home_at(laboratory.arm(), laboratory.free_posture(), arcs.span_rad);
    if (home.smallest_chord_mm > best.smallest_chord_mm) best = std::move(home);
  }
  if (best.smallest_chord_mm < kSmallestChord_mm) {
    throw Impossible(fmt::format(
        "in none of {} postures do the arcs of all joints reach {:.0f} mm across: joint {} gets no "
        "farther than {:.3f} mm",
        kHomes, kSmallestChord_mm, best.joint, best.smallest_chord_mm));
  }
  return best;
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const JointArcs& arcs) {
  if (arcs.points < 3) {
    throw Impossible(fmt::format("a circle needs three points, not {}", arcs.points));
  }
  const int joints = laboratory.arm().truth().joint_count();
  const Home home = best_home(laboratory, arcs);
  const RigidTransform reference_from_base = laboratory.convenient_place(0.0);
  const int rows = arcs.points * joints;
  ObservationGroup group =
      empty_group(ReferenceKind::reference_points, arcs.name, rows, joints, arcs.u_mm);
  group.reference_mm.resize(3, rows);
  group.place.assign(static_cast<std::size_t>(rows), arcs.name);
  for (int row = 0; row < rows; ++row) {
    const int joint = row / arcs.points;
    const Range& range = home.ranges[static_cast<std::size_t>(joint)];
    const double along = static_cast<double>(row % arcs.points) / (arcs.points - 1);
    Eigen::VectorXd posture = home.posture;
    posture(joint) = range.low_rad + along * (range.high_rad - range.low_rad);
    const TakenReading taken = laboratory.take(posture);
    group.encoder_rad.col(row) = taken.encoder_rad;
    group.reference_mm.col(row) = reference_from_base * taken.tip_mm + laboratory.noise(arcs.u_mm);
    group.joint.push_back(joint + 1);
  }
  return {group};
}

}  // namespace armcal
