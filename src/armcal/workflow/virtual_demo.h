// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "armcal/report/document.h"

namespace armcal {

/// A virtual arm whose truth is known, calibrated by a cone, by a cone and a bar, and by a
/// reference CMM: text for a terminal, and the same as JSON.
struct VirtualDemo {
  std::string text;
  Json json;
  std::uint64_t seed = 1;
  std::vector<InputRecord> inputs;
};

/// Runs the built-in scenario `demo`; every figure is computed.
[[nodiscard]] VirtualDemo run_virtual_demo();

}  // namespace armcal
