// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/report/html/page.h"

namespace armcal {

/// A value that was held against a limit.
struct LimitedValue {
  double value = 0.0;
  double U = 0.0;    ///< expanded uncertainty of the test; 0: none is drawn
  std::string text;  ///< "0.031 mm"
  std::string word;  ///< verdict: "pass"; empty where there is none
  Tone tone = Tone::neutral;
};

/// One test: all numbers in one unit.
struct LimitBarRow {
  std::string name;
  std::string symbol;         ///< "P_Size.Sph.1x25::"; may be empty
  std::string limit;          ///< "MPE 0.040 mm"
  double mpe = 0.0;           ///< not positive: there is no limit, and no bar, only the text
  bool is_two_sided = false;  ///< an error with a sign, from -MPE to MPE
  /// Inside of the limit: below MPE by this much it passes. Negative where the rule widens.
  double guard = 0.0;
  bool is_undecided_beyond = false;  ///< fails only above MPE + guard
  std::optional<LimitedValue> as_found, as_left;
};

struct LimitBars {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;
  // Words of the legend; those of what is not drawn are not shown.
  std::string as_found, as_left, uncertainty, passes, guarded;
  std::vector<LimitBarRow> rows;
};

/// A bar for each test, scaled so that the limits of all stand below each other: as found hollow,
/// as left filled, each with the reach of its uncertainty; where it passes tinted, the zone of the
/// guard band hatched. What lies beyond the end of the scale is an arrow there.
[[nodiscard]] Figure figure_of(const LimitBars& bars);

}  // namespace armcal
