// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/verification_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"
#include "armcal/io/checked_number.h"
#include "armcal/io/session_file.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

constexpr const char* kFormulas =
    "in um, with L in mm: 30, \"20 + L/50\" or \"min(20 + L/50, 80)\"";

struct KindEntry {
  std::string_view name;
  const char* limit;         // key of its first limit
  const char* second_limit;  // and of its second; null where it has one
};
// In the order of StatedTestKind.
constexpr std::array<KindEntry, 8> kTestKinds = {{
    {"probing", "mpe_size_um", "mpe_form_um"},
    {"articulated_location", "mpe_um", nullptr},
    {"length_uni", "mpe_um", nullptr},
    {"length_bi", "mpe_um", nullptr},
    {"effective_diameter", "mpe_um", "mpe_s_um"},
    {"single_point_articulation", "mpe_um", "mpe_2s_um"},
    {"volumetric_length", "mpe_um", "mpe_2rms_um"},
    {"half_range", "mpe_um", nullptr},
}};

const std::vector<std::string> kRules = {"iso14253-1", "conformance-probability",
                                         "simple-acceptance", "guard-band"};

const KindEntry& entry_of(StatedTestKind kind) {
  return kTestKinds[static_cast<std::size_t>(kind)];
}

StatedDecision read_decision(TomlSection section, Diagnostics& diagnostics) {
  StatedDecision decision;
  if (const auto rule = section.text("rule")) {
    decision.rule = *rule;
    if (std::find(kRules.begin(), kRules.end(), *rule) == kRules.end()) {
      diagnostics.error(section.where("rule"), fmt::format("unknown rule \"{}\"", *rule),
                        did_you_mean(*rule, kRules));
    }
  }
  decision.coverage_factor =
      positive_or(decision.coverage_factor, section, "coverage_factor", diagnostics);
  if (const auto probability = section.number("probability")) {
    decision.probability = *probability;
    if (!(*probability >= 0.5 && *probability < 1.0)) {
      diagnostics.error(
          section.where("probability"),
          fmt::format("probability is {}: must be at least 0.5 and below 1", *probability));
    }
  }
  if (section.has("guard_factor")) {
    decision.guard_factor = not_negative_or_zero(section, "guard_factor", diagnostics);
  }
  section.finish();
  return decision;
}

StatedEnvironment read_environment(TomlSection section, Diagnostics& diagnostics) {
  StatedEnvironment environment;
  if (const auto temperature = section.number("temperature_c")) {
    environment.temperature_C = *temperature;
    if (!(*temperature > -30.0 && *temperature < 70.0)) {
      diagnostics.error(
          section.where("temperature_c"),
          fmt::format("temperature_c is {}: no arm is verified at that", *temperature),
          "temperatures are in degrees Celsius");
    }
  }
  environment.u_temperature_K = not_negative_or_zero(section, "u_temperature_c", diagnostics);
  section.finish();
  return environment;
}

std::optional<StatedTestKind> test_kind_of(TomlSection& section, Diagnostics& diagnostics) {
  const auto name = section.required_text("kind");
  if (!name) return std::nullopt;
  std::vector<std::string> known;
  for (std::size_t i = 0; i < kTestKinds.size(); ++i) {
    if (*name == kTestKinds[i].name) return static_cast<StatedTestKind>(i);
    known.emplace_back(kTestKinds[i].name);
  }
  diagnostics.error(section.where("kind"), fmt::format("unknown kind \"{}\"", *name),
                    did_you_mean(*name, known));
  return std::nullopt;
}

// @param of_length  may the limit grow with a length?
std::optional<StatedLimit> read_limit(TomlSection& section, const char* key, bool of_length,
                                      Diagnostics& diagnostics) {
  if (key == nullptr) return std::nullopt;
  const auto formula = section.number_or_text(key);
  if (!formula) return std::nullopt;
  const auto limit = limit_of_formula(*formula);
  if (!limit) {
    diagnostics.error(section.where(key), fmt::format("{} \"{}\" is no limit", key, *formula),
                      kFormulas);
  } else if (limit->k && !of_length) {
    diagnostics.error(
        section.where(key),
        fmt::format("{} \"{}\" depends on a length, and this test has none", key, *formula),
        "give a constant, in um");
  }
  return limit;
}

void read_artefact_name(TomlSection& section, StatedTest& test, Diagnostics& diagnostics) {
  const bool needs_none = !needs_sphere(test.kind) && !measures_lengths(test.kind);
  if (!needs_none) {
    test.artefact = section.required_text("artefact").value_or("");
  } else if (section.has("artefact")) {
    static_cast<void>(section.text("artefact"));
    diagnostics.error(
        section.where("artefact"),
        fmt::format("{} is measured in a seat: it has no artefact", to_string(test.kind)));
  }
}

void read_table_keys(TomlSection& section, StatedTest& test, std::optional<AngleUnit> angles,
                     Diagnostics& diagnostics) {
  test.table.angles = angle_unit_of(section, diagnostics);
  if (!test.table.angles) test.table.angles = angles;
  test.table.keep_duplicates = section.boolean("keep_duplicates").value_or(false);
  test.table.keep_zero_points = section.boolean("keep_zero_points").value_or(false);
  if (auto map = section.section("map")) {
    for (auto& [ours, theirs] : map->all_texts()) test.table.map[ours] = theirs;
    map->finish();
  }
}

StatedTest read_test(TomlSection section, const std::string& path, std::optional<AngleUnit> angles,
                     Diagnostics& diagnostics) {
  StatedTest test;
  test.where = section.where();
  const auto kind = test_kind_of(section, diagnostics);
  test.kind = kind.value_or(test.kind);
  test.name = section.text("name").value_or(std::string(to_string(test.kind)));
  if (const auto file = section.required_text("file")) test.file = path_beside(path, *file);
  read_table_keys(section, test, angles, diagnostics);
  test.probe_diameter_mm = not_negative_or_zero(section, "probe_diameter_mm", diagnostics);
  test.u_repeatability_mm = millimetres_from_micrometres(
      not_negative_or_zero(section, "u_repeatability_um", diagnostics));
  if (!kind) return test;  // which other keys it has, nobody knows
  read_artefact_name(section, test, diagnostics);
  test.limit = read_limit(section, entry_of(*kind).limit, measures_lengths(*kind), diagnostics);
  test.second_limit = read_limit(section, entry_of(*kind).second_limit, false, diagnostics);
  section.finish();
  return test;
}

void check_names(const VerificationFile& verification, Diagnostics& diagnostics) {
  std::set<std::string> seen;
  std::vector<std::string> known;
  for (const StatedArtefact& artefact : verification.artefacts) {
    known.push_back(artefact.name);
    if (!seen.insert(artefact.name).second) {
      diagnostics.error(artefact.where,
                        fmt::format("two artefacts are named \"{}\"", artefact.name));
    }
  }
  for (const StatedTest& test : verification.tests) {
    if (test.artefact.empty()) continue;
    const StatedArtefact* artefact = verification.artefact(test.artefact);
    if (artefact == nullptr) {
      diagnostics.error(test.where, fmt::format("no artefact is named \"{}\"", test.artefact),
                        known.empty() ? "describe it: [[artefact]] with name, kind and certificate"
                                      : did_you_mean(test.artefact, known));
    } else if (artefact->is_sphere != needs_sphere(test.kind)) {
      diagnostics.error(test.where,
                        fmt::format("{} needs {}, and \"{}\" is {}", to_string(test.kind),
                                    needs_sphere(test.kind) ? "a sphere" : "calibrated lengths",
                                    test.artefact, artefact->is_sphere ? "a sphere" : "lengths"));
    }
  }
}

// What holds for the whole file.
void read_head(TomlSection& root, VerificationFile& verification, Diagnostics& diagnostics) {
  const std::string& path = verification.file;
  verification.name = root.text("name").value_or("");
  static_cast<void>(root.text("note"));
  if (const auto arm = root.text("arm")) verification.arm_file = path_beside(path, *arm);
  if (const auto arm = root.text("as_left")) verification.as_left_file = path_beside(path, *arm);
  if (root.has("reach_mm")) {
    verification.reach_mm = required_length(root, "reach_mm", diagnostics);
  }
  if (const auto origin = root.numbers("origin_mm")) {
    if (origin->size() == 3) {
      verification.origin_mm = *origin;
    } else {
      diagnostics.error(root.where("origin_mm"), "origin_mm must have 3 numbers");
    }
  }
}

}  // namespace

std::string_view to_string(StatedTestKind kind) { return entry_of(kind).name; }

bool is_of_iso(StatedTestKind kind) { return kind <= StatedTestKind::length_bi; }

bool measures_lengths(StatedTestKind kind) {
  return kind == StatedTestKind::length_uni || kind == StatedTestKind::length_bi ||
         kind == StatedTestKind::volumetric_length;
}

bool needs_sphere(StatedTestKind kind) {
  return kind == StatedTestKind::probing || kind == StatedTestKind::articulated_location ||
         kind == StatedTestKind::effective_diameter;
}

bool has_two_limits(StatedTestKind kind) { return entry_of(kind).second_limit != nullptr; }

const StatedArtefact* VerificationFile::artefact(std::string_view called) const {
  const auto at = std::find_if(artefacts.begin(), artefacts.end(),
                               [&](const StatedArtefact& each) { return each.name == called; });
  return at == artefacts.end() ? nullptr : &*at;
}

std::optional<VerificationFile> read_verification_file(const TextFile& file,
                                                       Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "verification", diagnostics);
  VerificationFile verification;
  verification.file = file.path;
  read_head(root, verification, diagnostics);
  const auto angles = angle_unit_of(root, diagnostics);
  if (auto section = root.section("decision")) {
    verification.decision = read_decision(*section, diagnostics);
  }
  if (auto section = root.section("environment")) {
    verification.environment = read_environment(*section, diagnostics);
  }
  for (TomlSection& section : root.sections("artefact")) {
    verification.artefacts.push_back(read_artefact(section, file.path, diagnostics));
  }
  for (TomlSection& section : root.sections("test")) {
    verification.tests.push_back(read_test(section, file.path, angles, diagnostics));
  }
  if (!root.has("test")) {
    diagnostics.error({file.path, 0, 0}, "has no tests", "write one [[test]] for each");
  }
  root.finish();
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  check_names(verification, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return verification;
}

}  // namespace armcal
