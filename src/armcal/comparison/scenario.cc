// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/scenario.h"

#include "armcal/core/units.h"
#include "armcal/simulation/measuring_arms.h"

namespace armcal {
namespace {

ErrorSources geometry_and_noise() {
  ErrorSources errors;
  errors.geometry = GeometryErrors::typical();
  errors.encoder_noise.u_rad = radians_from_arcseconds(2.0);
  return errors;
}

ErrorSources with_eccentric_scales() {
  ErrorSources errors = geometry_and_noise();
  errors.scale_eccentricity = ScaleEccentricity::typical();
  return errors;
}

std::vector<Scenario> all_scenarios() {
  return {{.name = "romer",
           .title = "six joints as the ROMER Infinite 2.0, geometry errors, encoders of 2 arcsec",
           .nominal = romer_arm(),
           .errors = geometry_and_noise()},
          {.name = "romer-eccentric",
           .title = "the same with eccentric scales: 5 arcsec once, 2 arcsec twice per turn",
           .nominal = romer_arm(),
           .errors = with_eccentric_scales()},
          {.name = "seven-joint",
           .title = "seven joints, geometry errors, encoders of 2 arcsec",
           .nominal = seven_joint_arm(),
           .errors = geometry_and_noise()}};
}

}  // namespace

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const Scenario& scenario : all_scenarios()) names.push_back(scenario.name);
  return names;
}

std::optional<Scenario> scenario_named(std::string_view name) {
  for (Scenario& scenario : all_scenarios()) {
    if (scenario.name == name) return std::move(scenario);
  }
  return std::nullopt;
}

Bench bench_of(const Scenario& scenario, std::uint64_t seed) {
  return {.arm = VirtualArm(scenario.nominal, scenario.errors, seed, scenario.surroundings),
          .seed = seed,
          .readings = scenario.readings,
          .u_reference_mm = scenario.u_reference_mm};
}

}  // namespace armcal
