// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/virtual_arm.h"

#include "armcal/arm/inverse_kinematics.h"

namespace armcal {
namespace {

constexpr std::uint64_t kGeometryStream = 1;

ArmModel drawn(const ArmModel& nominal, const ErrorSources& errors, std::uint64_t seed) {
  RandomStream random(seed, kGeometryStream);
  return drawn_arm(nominal, errors.geometry, random);
}

std::span<const double> span_of(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

VirtualArm::VirtualArm(ArmModel nominal, const ErrorSources& errors, std::uint64_t seed,
                       Surroundings surroundings)
    : VirtualArm(nominal, drawn(nominal, errors, seed), errors, seed, surroundings) {}

VirtualArm::VirtualArm(ArmModel nominal, ArmModel truth, const ErrorSources& errors,
                       std::uint64_t /*seed*/, Surroundings surroundings)
    : nominal_(std::move(nominal)),
      truth_(std::move(truth)),
      errors_(errors),
      surroundings_(surroundings),
      kinematics_(truth_) {}

Eigen::Vector3d VirtualArm::tip(const Eigen::VectorXd& encoder_rad,
                                const Circumstances& /*circumstances*/) const {
  return kinematics_.tip_in_base(span_of(encoder_rad));
}

Eigen::VectorXd VirtualArm::shown(const Eigen::VectorXd& encoder_rad, RandomStream& random) const {
  Eigen::VectorXd shown = encoder_rad;
  for (double& reading : shown) reading = shown_reading(reading, errors_.encoder_noise, random);
  return shown;
}

std::optional<std::string> VirtualArm::obstacle(const Eigen::VectorXd& encoder_rad) const {
  if (auto limit = broken_limit(truth_, span_of(encoder_rad))) return limit;
  return collision(kinematics_, span_of(encoder_rad), surroundings_);
}

std::optional<Eigen::VectorXd> VirtualArm::posture_with_tip_at(
    const Eigen::Vector3d& point_mm, const Eigen::VectorXd& start_rad,
    const Circumstances& circumstances) const {
  // What is not geometry is small: aim beside the point by what is missing, a few times.
  Eigen::Vector3d aim = point_mm;
  PostureSearch search{.encoder_rad = start_rad};
  constexpr int kCorrections = 10;
  for (int i = 0; i < kCorrections; ++i) {
    search = find_posture(kinematics_, aim, search.encoder_rad);
    if (!search.found) return std::nullopt;
    const Eigen::Vector3d missing = point_mm - tip(search.encoder_rad, circumstances);
    if (missing.norm() < 1e-9) {
      if (obstacle(search.encoder_rad)) return std::nullopt;
      return search.encoder_rad;
    }
    aim += missing;
  }
  return std::nullopt;
}

}  // namespace armcal
