// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "armcal/io/toml_value.h"

namespace armcal {

// The options of a simulation are plain structs; a scenario sets their members by keys. One
// definition per key, made by the functions below, feeds the reader, the list of keys and the test
// that the documentation names them all.

enum class AmountRange { not_negative, positive, any };

// Each returns nothing where the key is absent or wrong, which goes to `diagnostics`.
std::optional<double> read_amount(TomlSection& section, const std::string& key, AmountRange range,
                                  Diagnostics& diagnostics);
std::optional<double> read_share(TomlSection& section, const std::string& key,
                                 Diagnostics& diagnostics);
/// rad, from STEM_deg or STEM_arcsec
std::optional<double> read_angle(TomlSection& section, const std::string& stem, AmountRange range,
                                 Diagnostics& diagnostics);
std::optional<int> read_count(TomlSection& section, const std::string& key, int least,
                              Diagnostics& diagnostics);
/// One of `words`, by its place among them.
std::optional<std::size_t> read_choice(TomlSection& section, const std::string& key,
                                       const std::vector<std::string>& words,
                                       Diagnostics& diagnostics);
std::optional<std::vector<int>> read_counts(TomlSection& section, const std::string& key, int least,
                                            Diagnostics& diagnostics);

/// A key of the table that sets up an `Options`.
template <class Options>
struct ScenarioKey {
  std::string name;  ///< as it is documented
  std::function<void(TomlSection&, Options&, Diagnostics&)> read;
};

namespace scenario_key {

template <class Options>
ScenarioKey<Options> amount(const std::string& name, double Options::*member,
                            AmountRange range = AmountRange::not_negative) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (const auto value = read_amount(section, name, range, diagnostics)) {
              options.*member = *value;
            }
          }};
}

/// A part of a whole, 0 to 1.
template <class Options>
ScenarioKey<Options> share(const std::string& name, double Options::*member) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (const auto value = read_share(section, name, diagnostics)) {
              options.*member = *value;
            }
          }};
}

/// Called STEM_arcsec or STEM_deg.
template <class Options>
ScenarioKey<Options> angle(const std::string& stem, double Options::*member,
                           AmountRange range = AmountRange::not_negative) {
  return {stem + "_arcsec", [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (const auto value = read_angle(section, stem, range, diagnostics)) {
              options.*member = *value;
            }
          }};
}

template <class Options>
ScenarioKey<Options> count(const std::string& name, int Options::*member, int least = 1) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (const auto value = read_count(section, name, least, diagnostics)) {
              options.*member = *value;
            }
          }};
}

template <class Options>
ScenarioKey<Options> counts(const std::string& name, std::vector<int> Options::*member) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (auto values = read_counts(section, name, 1, diagnostics)) {
              options.*member = std::move(*values);
            }
          }};
}

template <class Options>
ScenarioKey<Options> yes_no(const std::string& name, bool Options::*member) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& /*diagnostics*/) {
            if (const auto value = section.boolean(name)) options.*member = *value;
          }};
}

template <class Options>
ScenarioKey<Options> text(const std::string& name, std::string Options::*member) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& /*diagnostics*/) {
            if (auto value = section.text(name)) options.*member = std::move(*value);
          }};
}

template <class Options, class Choice>
ScenarioKey<Options> choice(const std::string& name, Choice Options::*member,
                            std::vector<std::string> words, std::vector<Choice> choices) {
  return {name, [=](TomlSection& section, Options& options, Diagnostics& diagnostics) {
            if (const auto index = read_choice(section, name, words, diagnostics)) {
              options.*member = choices[*index];
            }
          }};
}

}  // namespace scenario_key

template <class Options>
void read_keys(TomlSection& section, const std::vector<ScenarioKey<Options>>& keys,
               Options& options, Diagnostics& diagnostics) {
  for (const ScenarioKey<Options>& key : keys) key.read(section, options, diagnostics);
}

template <class Options>
std::vector<std::string> names_of(const std::vector<ScenarioKey<Options>>& keys) {
  std::vector<std::string> names;
  for (const ScenarioKey<Options>& key : keys) names.push_back(key.name);
  return names;
}

}  // namespace armcal
