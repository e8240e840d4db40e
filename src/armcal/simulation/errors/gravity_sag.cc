// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/gravity_sag.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>
#include <stdexcept>

namespace armcal {
namespace {

// What hangs on a place of the arm: a force, and a moment about that place.
struct Load {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_N_mm = Eigen::Vector3d::Zero();
};

// Turn and shift of the far end of a beam along `way`, clamped at its near end.
// theory/virtual_arm.md eq. (6)-(7)
void bend(LinkState& link, const LinkBody& body, const Load& at_end,
          const Eigen::Vector3d& weight_N) {
  const double length = link.way_mm.norm();
  if (length == 0.0) return;
  const Eigen::Vector3d along = link.way_mm / length;
  const double twisting = along.dot(at_end.moment_N_mm);
  const Eigen::Vector3d bending = at_end.moment_N_mm - twisting * along;
  const Eigen::Vector3d by_force = along.cross(at_end.force_N);
  const Eigen::Vector3d by_weight = along.cross(weight_N);
  const double c = body.centre * length;
  const Eigen::Vector3d turn =
      bending * length + by_force * length * length / 2.0 + by_weight * c * c / 2.0;
  const Eigen::Vector3d way = bending * length * length / 2.0 +
                              by_force * length * length * length / 3.0 +
                              by_weight * c * c * (3.0 * length - c) / 6.0;
  link.bend_rad +=
      body.bending_per_N_mm2 * turn + body.torsion_per_N_mm2 * twisting * length * along;
  link.sag_mm += body.bending_per_N_mm2 * way.cross(along);
}

}  // namespace

bool GravitySag::is_on() const {
  const bool has_mass = tube_kg_per_mm > 0.0 || joint_kg > 0.0 || probe_kg > 0.0;
  const bool gives_way =
      bending_per_N_mm2 > 0.0 || torsion_per_N_mm2 > 0.0 || bearing_rad_per_N_mm > 0.0;
  return !links.empty() || (has_mass && gives_way);
}

GravitySag GravitySag::typical() {
  using std::numbers::pi;
  constexpr double radius_mm = 43.0;
  constexpr double wall_mm = 4.0;
  const double second_moment_mm4 = pi * radius_mm * radius_mm * radius_mm * wall_mm;
  return {.tube_kg_per_mm = 2.0 * pi * radius_mm * wall_mm * 1.7e-6,
          .joint_kg = 0.5,
          .probe_kg = 0.3,
          .bending_per_N_mm2 = 1.0 / (140e3 * second_moment_mm4),
          .torsion_per_N_mm2 = 1.0 / (25e3 * 2.0 * second_moment_mm4),
          .bearing_rad_per_N_mm = 1e-9,
          .links = {}};
}

std::vector<LinkBody> bodies_of(const ArmModel& arm, const GravitySag& sag) {
  const std::size_t n = arm.joints.size();
  if (!sag.links.empty()) {
    if (sag.links.size() == n) return sag.links;
    throw std::invalid_argument(
        fmt::format("sag is given for {} links, but arm \"{}\" has {} (the last leads to the tip)",
                    sag.links.size(), arm.name, n));
  }
  std::vector<LinkBody> bodies(n, {.bending_per_N_mm2 = sag.bending_per_N_mm2,
                                   .torsion_per_N_mm2 = sag.torsion_per_N_mm2,
                                   .bearing_rad_per_N_mm = sag.bearing_rad_per_N_mm});
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Link& link = arm.links[i];
    const double tube_kg =
        sag.tube_kg_per_mm * Eigen::Vector3d(link.a_mm, link.b_mm, link.d_mm).norm();
    bodies[i].mass_kg = tube_kg + sag.joint_kg;
    if (bodies[i].mass_kg > 0.0)
      bodies[i].centre = (0.5 * tube_kg + sag.joint_kg) / bodies[i].mass_kg;
  }
  bodies.back().mass_kg = sag.probe_kg;
  return bodies;
}

void add_sag(ArmState& state, const std::vector<LinkBody>& bodies, const Eigen::Vector3d& down) {
  const ArmFrames straight = frames_of(state);
  Load load;  // of all that is further out, about the far end of the link: eq. (5)
  for (std::size_t i = bodies.size(); i-- > 0;) {
    const LinkBody& body = bodies[i];
    const Eigen::Matrix3d& rotation = straight.base_from_link[i].rotation;
    const Eigen::Vector3d way = rotation * state.links[i].way_mm;
    const Eigen::Vector3d weight = body.mass_kg * kGravity_m_per_s2 * down;
    const auto in_link = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
      return rotation.transpose() * v;
    };
    bend(state.links[i], body, {in_link(load.force_N), in_link(load.moment_N_mm)}, in_link(weight));
    load.moment_N_mm += way.cross(load.force_N) + (body.centre * way).cross(weight);
    load.force_N += weight;
    // Bearings hold what is across their axis: eq. (8).
    Eigen::Vector3d across = in_link(load.moment_N_mm);
    across.z() = 0.0;
    const Eigen::AngleAxisd turned(state.joints[i].angle_rad, Eigen::Vector3d::UnitZ());
    state.joints[i].tilt_rad += body.bearing_rad_per_N_mm * (turned * across);
  }
}

}  // namespace armcal
