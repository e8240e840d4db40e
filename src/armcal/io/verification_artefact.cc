// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/verification_artefact.h"

#include <fmt/format.h>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"
#include "armcal/io/checked_number.h"
#include "armcal/io/plausibility.h"
#include "armcal/io/text_file.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

// Expansion by certificate, per kelvin.
double expansion_of(TomlSection& section, const char* key, Diagnostics& diagnostics) {
  const double expansion = not_negative_or_zero(section, key, diagnostics);
  constexpr double kLargest = 1e-3;
  if (expansion > kLargest) {
    diagnostics.error(section.where(key),
                      fmt::format("{} is {}: no material expands so much", key, expansion),
                      "steel is 11.5e-6");
  }
  return expansion;
}

void read_sphere(TomlSection& section, StatedArtefact& artefact, Diagnostics& diagnostics) {
  artefact.diameter_mm = required_length(section, "diameter_mm", diagnostics);
  artefact.U_mm = millimetres_from_micrometres(not_negative_or_zero(section, "U_um", diagnostics));
  artefact.form_mm =
      millimetres_from_micrometres(not_negative_or_zero(section, "form_um", diagnostics));
}

void read_lengths(TomlSection& section, StatedArtefact& artefact, const std::string& path,
                  Diagnostics& diagnostics) {
  if (const auto file = section.text("file")) artefact.file = path_beside(path, *file);
  const auto pairs = section.pairs("lengths");
  if (artefact.file.empty() == !section.has("lengths")) {
    diagnostics.error(section.where(), "an artefact of lengths needs either file or lengths",
                      "lengths = [[500.0012, 0.6]]: length in mm and its U in um; or the table, "
                      "file = \"lengths.csv\"");
  }
  if (!pairs) return;
  for (const Eigen::Vector2d& pair : *pairs) {
    const bool sound = pair(0) > 0.0 && pair(0) <= kLongestLength_mm && pair(1) >= 0.0;
    if (!sound) {
      diagnostics.error(section.where("lengths"),
                        fmt::format("[{}, {}] is no length with its uncertainty", pair(0), pair(1)),
                        "a length in mm, larger than 0, and its U in um, not negative");
    }
    artefact.lengths.push_back({fmt::format("{}", artefact.lengths.size() + 1), pair(0),
                                millimetres_from_micrometres(pair(1))});
  }
  if (pairs->empty()) diagnostics.error(section.where("lengths"), "lengths is empty");
}

}  // namespace

StatedArtefact read_artefact(TomlSection& section, const std::string& path,
                             Diagnostics& diagnostics) {
  StatedArtefact artefact;
  artefact.where = section.where();
  artefact.name = section.required_text("name").value_or("");
  const auto kind = section.required_text("kind");
  if (kind && *kind != "sphere" && *kind != "lengths") {
    const std::vector<std::string> known = {"sphere", "lengths"};
    diagnostics.error(section.where("kind"), fmt::format("unknown kind \"{}\"", *kind),
                      did_you_mean(*kind, known));
  }
  artefact.is_sphere = kind != "lengths";
  artefact.coverage_factor = positive_or(artefact.coverage_factor, section, "k", diagnostics);
  artefact.expansion_per_K = expansion_of(section, "expansion_per_c", diagnostics);
  artefact.u_expansion_per_K = expansion_of(section, "u_expansion_per_c", diagnostics);
  artefact.certificate = section.text("certificate").value_or("");
  if (artefact.is_sphere) {
    read_sphere(section, artefact, diagnostics);
  } else {
    read_lengths(section, artefact, path, diagnostics);
  }
  section.finish();
  return artefact;
}

}  // namespace armcal
