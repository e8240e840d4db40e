// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/arm/parameter_table.h"
#include "armcal/symmetric_point/adjustment.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal::testing {

/// What the 2016 paper solves for: a5, a7, b3, b5, b7.
inline std::vector<int> papers_five(const ParameterTable& table) {
  std::vector<int> places;
  for (const char* name : {"a5", "a7", "b3", "b5", "b7"}) {
    places.push_back(table.find(name).value());
  }
  return places;
}
inline AdjustmentOptions papers_five() {
  AdjustmentOptions options;
  options.unknowns = papers_five(ParameterTable(nominal_romer()));
  return options;
}

}  // namespace armcal::testing
