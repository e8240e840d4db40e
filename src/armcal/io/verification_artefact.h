// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"

namespace armcal {

class TomlSection;

/// A calibrated length with the expanded uncertainty of its certificate.
struct CertifiedLength {
  std::string name;
  double length_mm = 0.0;
  double U_mm = 0.0;
};

/// One [[artefact]]: a sphere, or one or more calibrated lengths.
struct StatedArtefact {
  SourcePosition where;
  std::string name;
  bool is_sphere = true;
  double diameter_mm = 0.0;
  double U_mm = 0.0;             ///< sphere: of the diameter; lengths have their own
  double coverage_factor = 2.0;  ///< of U
  double form_mm = 0.0;          ///< sphere: largest minus smallest radius, by certificate
  double expansion_per_K = 0.0;
  double u_expansion_per_K = 0.0;
  std::string certificate;
  std::string file;  ///< lengths: of their table; empty where `lengths` are given
  std::vector<CertifiedLength> lengths;
};

/// Reads an [[artefact]] of a verification file, to its end. Lengths in a table of their own are
/// still to be read (`certified_lengths`).
/// @param path  of the file, beside which the table lies
[[nodiscard]] StatedArtefact read_artefact(TomlSection& section, const std::string& path,
                                           Diagnostics& diagnostics);

}  // namespace armcal
