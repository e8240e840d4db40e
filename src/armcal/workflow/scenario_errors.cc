// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_errors.h"

#include "armcal/workflow/scenario_keys.h"

namespace armcal {
namespace {

using namespace scenario_key;

const std::vector<ScenarioKey<GeometryErrors>>& keys_of(const GeometryErrors&) {
  static const std::vector<ScenarioKey<GeometryErrors>> keys = {
      angle("u_twist", &GeometryErrors::u_twist_rad), angle("u_zero", &GeometryErrors::u_zero_rad),
      amount("u_offset_mm", &GeometryErrors::u_offset_mm),
      amount("u_length_mm", &GeometryErrors::u_length_mm)};
  return keys;
}

const std::vector<ScenarioKey<EncoderNoise>>& keys_of(const EncoderNoise&) {
  static const std::vector<ScenarioKey<EncoderNoise>> keys = {
      angle("u", &EncoderNoise::u_rad), angle("step", &EncoderNoise::step_rad)};
  return keys;
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
            const bool typical = section.boolean("typical").value_or(false);
            if constexpr (requires { Errors::typical(); }) {
              if (typical) sources.*member = Errors::typical();
            }
            read_keys(section, keys_of(Errors{}), sources.*member, diagnostics);
            section.finish();
          }};
}

// A new source is a line here, and its keys above.
const std::vector<Source>& sources() {
  static const std::vector<Source> all = {
      source("geometry", &ErrorSources::geometry),
      source("encoder_noise", &ErrorSources::encoder_noise),
  };
  return all;
}

}  // namespace

ErrorSources read_error_sources(TomlSection& section, Diagnostics& diagnostics) {
  ErrorSources errors;
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
