// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/comparison/bench.h"

namespace armcal {

/// An arm to be built with errors of stated size, and what there is to calibrate it with.
struct Scenario {
  std::string name;
  std::string title;
  ArmModel nominal;
  ErrorSources errors;
  Surroundings surroundings;
  int readings = 120;
  double u_reference_mm = 0.005;
};

/// Scenarios that are built in. The first one is used where none is named.
[[nodiscard]] std::vector<std::string> scenario_names();
[[nodiscard]] std::optional<Scenario> scenario_named(std::string_view name);

/// Draws an arm. The same seed draws the same arm.
[[nodiscard]] Bench bench_of(const Scenario& scenario, std::uint64_t seed);

}  // namespace armcal
