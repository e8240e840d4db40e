// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/test_result.h"

#include <cmath>

namespace armcal {

TestResult with_symbol_if_complete(TestResult result, const char* symbol) {
  result.symbol = result.complete() ? symbol : "";
  return result;
}

std::optional<double> largest_by_magnitude(const std::vector<ResultPart>& parts) {
  std::optional<double> largest;
  for (const ResultPart& part : parts) {
    if (!largest || std::abs(part.value_mm) > std::abs(*largest)) largest = part.value_mm;
  }
  return largest;
}

}  // namespace armcal
