// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace armcal {

/// One of the values that a reported value was found from.
struct ResultPart {
  std::string name;  ///< "position A", "articulation 3", "500 mm at P2, repeat 1"
  double value_mm = 0.0;
  std::optional<double> length_mm;  ///< calibrated length, where the limit depends on it
  int readings = 0;                 ///< that it was found from
  std::string where;                ///< place in the user's file, where the caller gave one
};

/// What a test of a standard found, with its definition: a number without one means nothing.
struct TestResult {
  std::string name;        ///< "probing size error"
  std::string standard;    ///< "ISO 10360-12:2016"; empty for a form that no standard defines
  std::string definition;  ///< of the value, in one sentence
  /// The standard's symbol. Empty unless everything that the standard asks for is there; for
  /// standards without symbols always.
  std::string symbol;
  std::optional<double> value_mm;  ///< nothing where no part could be computed
  bool is_signed = true;           ///< limits lie at -MPE and +MPE; else only at +MPE
  std::vector<ResultPart> parts;
  /// What the standard asks for and the readings lack: "24 points at position B, 25 are asked for".
  std::vector<std::string> missing;
  /// What makes the readings wrong rather than few: another sphere, other units, points in a plane.
  std::vector<std::string> problems;

  [[nodiscard]] bool complete() const {
    return value_mm.has_value() && missing.empty() && problems.empty();
  }
};

/// Gives the symbol to a result that is complete, none to others.
[[nodiscard]] TestResult with_symbol_if_complete(TestResult result, const char* symbol);

/// The part of largest magnitude; the first of equals. Nothing without parts.
[[nodiscard]] std::optional<double> largest_by_magnitude(const std::vector<ResultPart>& parts);

}  // namespace armcal
