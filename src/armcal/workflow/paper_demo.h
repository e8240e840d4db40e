// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "armcal/report/document.h"

namespace armcal {

/// The 2016 paper recomputed from its printed readings: text for a terminal, and the same as JSON.
struct PaperDemo {
  std::string text;
  Json json;
  std::vector<InputRecord> inputs;
};

/// Uses the examples built into the library, and nothing else.
[[nodiscard]] PaperDemo run_paper_demo();

}  // namespace armcal
