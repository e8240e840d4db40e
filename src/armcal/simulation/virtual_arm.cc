// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/virtual_arm.h"

#include <cmath>

#include "armcal/arm/inverse_kinematics.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// One stream per source. The laboratory's come after these.
enum Stream : std::uint64_t {
  kGeometry = 1,
  kScaleEccentricity = 2,
  kBearingRunOut = 3,
  kThermalExpansion = 4,
  kWarmUpDrift = 5,
};

ArmModel drawn_geometry(const ArmModel& nominal, const ErrorSources& errors, std::uint64_t seed) {
  RandomStream random(seed, kGeometry);
  return drawn_arm(nominal, errors.geometry, random);
}

ArmModel with_drawn_scales(const ArmModel& truth, const ErrorSources& errors, std::uint64_t seed) {
  RandomStream random(seed, kScaleEccentricity);
  return with_eccentric_scales(truth, errors.scale_eccentricity, random);
}

}  // namespace

VirtualArm::VirtualArm(ArmModel nominal, const ErrorSources& errors, std::uint64_t seed,
                       Surroundings surroundings)
    : VirtualArm(nominal, drawn_geometry(nominal, errors, seed), errors, seed, surroundings) {}

VirtualArm::VirtualArm(ArmModel nominal, ArmModel truth, const ErrorSources& errors,
                       std::uint64_t seed, Surroundings surroundings)
    : nominal_(std::move(nominal)),
      truth_(with_drawn_scales(truth, errors, seed)),
      errors_(errors),
      surroundings_(surroundings),
      drawn_(drawn(truth_, errors, seed)),
      kinematics_(truth_) {}

VirtualArm::Drawn VirtualArm::drawn(const ArmModel& truth, const ErrorSources& errors,
                                    std::uint64_t seed) {
  const int n = truth.joint_count();
  Drawn result;
  if (errors.bearing_run_out.is_on()) {
    RandomStream random(seed, kBearingRunOut);
    result.run_out = drawn_run_out(n, errors.bearing_run_out, random);
  }
  if (errors.gravity_sag.is_on()) result.bodies = bodies_of(truth, errors.gravity_sag);
  if (errors.thermal_expansion.is_on()) {
    RandomStream random(seed, kThermalExpansion);
    result.growth = drawn_expansion(n, errors.thermal_expansion, random);
  }
  if (errors.warm_up_drift.is_on()) {
    RandomStream random(seed, kWarmUpDrift);
    result.drift = drawn_drift(n, errors.warm_up_drift, random);
  }
  return result;
}

ArmState VirtualArm::state(const Eigen::VectorXd& encoder_rad,
                           const Circumstances& circumstances) const {
  ArmState state = state_of(truth_, as_span(encoder_rad));
  if (errors_.warm_up_drift.is_on()) {
    const double share = -std::expm1(-circumstances.time_s / errors_.warm_up_drift.time_constant_s);
    add_drift(state, drawn_.drift, truth_.joints, share);
  }
  if (errors_.thermal_expansion.is_on()) add_expansion(state, drawn_.growth);
  if (errors_.bearing_run_out.is_on()) add_run_out(state, drawn_.run_out);
  if (errors_.gravity_sag.is_on()) add_sag(state, drawn_.bodies, errors_.down);
  if (errors_.base_movement.tilts()) add_tilt(state, errors_.base_movement, errors_.down);
  if (errors_.base_movement.is_random()) add_movement(state, circumstances.base_movement);
  return state;
}

Eigen::Vector3d VirtualArm::tip(const Eigen::VectorXd& encoder_rad,
                                const Circumstances& circumstances) const {
  const ArmState state = this->state(encoder_rad, circumstances);
  const ArmFrames frames = frames_of(state);
  if (!errors_.probing_force.is_on() || circumstances.push.isZero(0.0)) return frames.tip_mm;
  const Eigen::Vector3d stylus =
      frames.base_from_link.back().rotation * state.links.back().way_mm.stableNormalized();
  return frames.tip_mm + yield_to(errors_.probing_force, circumstances.push, stylus);
}

Eigen::Matrix3d VirtualArm::base_from_last_joint(const Eigen::VectorXd& encoder_rad,
                                                 const Circumstances& circumstances) const {
  return frames_of(state(encoder_rad, circumstances)).base_from_link.back().rotation;
}

Eigen::VectorXd VirtualArm::shown(const Eigen::VectorXd& encoder_rad, RandomStream& random) const {
  Eigen::VectorXd shown = encoder_rad;
  for (double& reading : shown) reading = shown_reading(reading, errors_.encoder_noise, random);
  return shown;
}

std::optional<std::string> VirtualArm::obstacle(const Eigen::VectorXd& encoder_rad) const {
  if (auto limit = broken_limit(truth_, as_span(encoder_rad))) return limit;
  return collision(kinematics_, as_span(encoder_rad), surroundings_);
}

std::optional<Eigen::VectorXd> VirtualArm::posture_with_tip_at(
    const Eigen::Vector3d& point_mm, const Eigen::VectorXd& start_rad,
    const Circumstances& circumstances) const {
  const Eigen::Vector3d shoulder = truth_.base_from_first_joint.translation_mm;
  constexpr double kRoom = 1.01;  // for what lengthens an arm beyond its geometry
  if ((point_mm - shoulder).norm() > kRoom * reach_mm(truth_)) return std::nullopt;
  // What is not geometry is small: aim beside the point by what is missing, a few times. Each time
  // gains at least two digits, for what is missing changes little with the posture.
  constexpr int kCorrections = 10;
  constexpr double kArrived_mm = 1e-9;
  const PostureSearchOptions options = {.tolerance_mm = 0.1 * kArrived_mm,
                                        .limits = joint_limits(truth_)};
  Eigen::Vector3d aim = point_mm;
  PostureSearch search{.encoder_rad = start_rad};
  for (int i = 0; i < kCorrections; ++i) {
    search = find_posture(kinematics_, aim, search.encoder_rad, options);
    if (!search.found) return std::nullopt;
    const Eigen::Vector3d missing = point_mm - tip(search.encoder_rad, circumstances);
    if (missing.norm() < kArrived_mm) {
      if (obstacle(search.encoder_rad)) return std::nullopt;
      return search.encoder_rad;
    }
    aim += missing;
  }
  return std::nullopt;
}

}  // namespace armcal
