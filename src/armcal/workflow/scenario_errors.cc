// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_errors.h"

#include "armcal/workflow/scenario_keys.h"

namespace armcal {
namespace {

using namespace scenario_key;

template <class Options>
using Keys = std::vector<ScenarioKey<Options>>;

Keys<GeometryErrors> keys_of(const GeometryErrors&) {
  using T = GeometryErrors;
  return {angle("u_twist", &T::u_twist_rad), angle("u_zero", &T::u_zero_rad),
          amount("u_offset_mm", &T::u_offset_mm), amount("u_length_mm", &T::u_length_mm)};
}

Keys<EncoderNoise> keys_of(const EncoderNoise&) {
  using T = EncoderNoise;
  return {angle("u", &T::u_rad), angle("step", &T::step_rad)};
}

Keys<ScaleEccentricity> keys_of(const ScaleEccentricity&) {
  using T = ScaleEccentricity;
  return {angle("u_first", &T::u_first_rad), angle("u_second", &T::u_second_rad)};
}

Keys<BearingRunOut> keys_of(const BearingRunOut&) {
  using T = BearingRunOut;
  return {angle("u_tilt", &T::u_tilt_rad), amount("u_shift_mm", &T::u_shift_mm)};
}

Keys<LinkBody> keys_of(const LinkBody&) {
  using T = LinkBody;
  return {amount("mass_kg", &T::mass_kg), share("centre", &T::centre),
          amount("bending_per_N_mm2", &T::bending_per_N_mm2),
          amount("torsion_per_N_mm2", &T::torsion_per_N_mm2),
          amount("bearing_rad_per_N_mm", &T::bearing_rad_per_N_mm)};
}

void read_links(TomlSection& section, GravitySag& sag, Diagnostics& diagnostics) {
  for (TomlSection& link : section.sections("links")) {
    read_keys(link, keys_of(LinkBody{}), sag.links.emplace_back(), diagnostics);
    link.finish();
  }
}

Keys<GravitySag> keys_of(const GravitySag&) {
  using T = GravitySag;
  return {amount("tube_kg_per_mm", &T::tube_kg_per_mm),
          amount("joint_kg", &T::joint_kg),
          amount("probe_kg", &T::probe_kg),
          amount("bending_per_N_mm2", &T::bending_per_N_mm2),
          amount("torsion_per_N_mm2", &T::torsion_per_N_mm2),
          amount("bearing_rad_per_N_mm", &T::bearing_rad_per_N_mm),
          {"links", read_links}};
}

Keys<ThermalExpansion> keys_of(const ThermalExpansion&) {
  using T = ThermalExpansion;
  return {amount("expansion_per_K", &T::expansion_per_K, AmountRange::any),
          amount("temperature_K", &T::temperature_K, AmountRange::any),
          amount("u_temperature_K", &T::u_temperature_K)};
}

Keys<ProbingForce> keys_of(const ProbingForce&) {
  using T = ProbingForce;
  return {amount("force_N", &T::force_N), amount("arm_mm_per_N", &T::arm_mm_per_N),
          amount("stylus_mm_per_N", &T::stylus_mm_per_N)};
}

Keys<BaseMovement> keys_of(const BaseMovement&) {
  using T = BaseMovement;
  return {amount("u_shift_mm", &T::u_shift_mm), angle("u_tilt", &T::u_tilt_rad),
          amount("load_kg", &T::load_kg), amount("tilt_rad_per_N_mm", &T::tilt_rad_per_N_mm)};
}

Keys<WarmUpDrift> keys_of(const WarmUpDrift&) {
  using T = WarmUpDrift;
  return {angle("u_zero", &T::u_zero_rad), amount("u_length_per_length", &T::u_length),
          amount("time_constant_s", &T::time_constant_s, AmountRange::positive)};
}

Keys<Blunders> keys_of(const Blunders&) {
  using T = Blunders;
  return {share("share", &T::share), amount("size_mm", &T::size_mm)};
}

/// A source: the table that sets it up, and the member that it sets.
struct Source {
  std::string name;
  std::vector<std::string> keys;
  std::function<void(TomlSection&, ErrorSources&, Diagnostics&)> read;
};

template <class Errors>
Source source(const std::string& name, Errors ErrorSources::*member) {
  return {name, names_of(keys_of(Errors{})),
          [=](TomlSection& section, ErrorSources& sources, Diagnostics& diagnostics) {
            if (section.boolean("typical").value_or(false)) sources.*member = Errors::typical();
            read_keys(section, keys_of(Errors{}), sources.*member, diagnostics);
            section.finish();
          }};
}

// A new source is a line here, and its keys above.
std::vector<Source> sources() {
  using E = ErrorSources;
  return {source("geometry", &E::geometry),
          source("encoder_noise", &E::encoder_noise),
          source("scale_eccentricity", &E::scale_eccentricity),
          source("bearing_run_out", &E::bearing_run_out),
          source("gravity_sag", &E::gravity_sag),
          source("thermal_expansion", &E::thermal_expansion),
          source("probing_force", &E::probing_force),
          source("base_movement", &E::base_movement),
          source("warm_up_drift", &E::warm_up_drift),
          source("blunders", &E::blunders)};
}

void read_down(TomlSection& section, ErrorSources& errors, Diagnostics& diagnostics) {
  const auto down = section.numbers("down");
  if (!down) return;
  if (down->size() != 3 || down->norm() == 0.0) {
    diagnostics.error(section.where("down"), "down must be 3 numbers, not all 0",
                      "where gravity pulls, in the base frame: [0, 0, -1] on a bench");
    return;
  }
  errors.down = down->normalized();
}

}  // namespace

ErrorSources read_error_sources(TomlSection& section, Diagnostics& diagnostics) {
  const bool typical = section.boolean("typical").value_or(false);
  ErrorSources errors = typical ? ErrorSources::typical() : ErrorSources{};
  read_down(section, errors, diagnostics);
  for (const Source& each : sources()) {
    if (auto table = section.section(each.name)) each.read(*table, errors, diagnostics);
  }
  section.finish();
  return errors;
}

std::vector<ErrorSourceKeys> error_source_keys() {
  std::vector<ErrorSourceKeys> all;
  for (const Source& each : sources()) all.push_back({each.name, each.keys});
  return all;
}

}  // namespace armcal
