// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/scenario.h"

#include <numbers>

#include "armcal/core/units.h"

namespace armcal {
namespace {

// Axes at right angles in turn, as on every such arm.
ArmModel right_angled_arm(const std::string& name, int joints) {
  ArmModel arm;
  arm.name = name;
  arm.joints.resize(static_cast<std::size_t>(joints));
  arm.links.resize(static_cast<std::size_t>(joints) - 1);
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    arm.links[i].alpha_rad = (i % 2 == 0 ? 0.5 : -0.5) * std::numbers::pi;
  }
  return arm;
}

// Round numbers near those of Wang et al. 2016, Table 2 read with the model
// (examples/wang2016/nominal.arm.toml). No stops: its procedure needs full turns.
ArmModel romer() {
  ArmModel arm = right_angled_arm("ROMER Infinite 2.0, nominal", 6);
  arm.links[1].b_mm = 750.0;
  arm.links[3].b_mm = 530.0;
  arm.links[3].a_mm = 80.0;
  arm.tip.a_mm = -25.0;
  arm.tip.b_mm = 175.0;
  return arm;
}

// As examples/arms/seven-joint.arm.toml.
ArmModel seven_joints() {
  ArmModel arm = right_angled_arm("seven-joint measuring arm", 7);
  arm.links[0].d_mm = 300.0;
  arm.links[1].b_mm = 600.0;
  arm.links[2].a_mm = 45.0;
  arm.links[3].b_mm = 500.0;
  arm.links[4].a_mm = 35.0;
  arm.links[5].b_mm = 100.0;
  arm.tip.a_mm = 30.0;
  arm.tip.d_mm = 150.0;
  const double range_deg[7][2] = {{-360, 360}, {-60, 120},  {-360, 360}, {-30, 210},
                                  {-360, 360}, {-110, 110}, {-360, 360}};
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    arm.joints[i].min_rad = radians_from_degrees(range_deg[i][0]);
    arm.joints[i].max_rad = radians_from_degrees(range_deg[i][1]);
  }
  return arm;
}

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
           .nominal = romer(),
           .errors = geometry_and_noise()},
          {.name = "romer-eccentric",
           .title = "the same with eccentric scales: 5 arcsec once, 2 arcsec twice per turn",
           .nominal = romer(),
           .errors = with_eccentric_scales()},
          {.name = "seven-joint",
           .title = "seven joints, geometry errors, encoders of 2 arcsec",
           .nominal = seven_joints(),
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
