// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/length_error_bi.h"

#include "armcal/verification/iso10360_12/length_layout.h"
#include "armcal/verification/iso10360_12/standard.h"

namespace armcal::iso10360_12 {

TestResult length_error_bi(std::span<const MeasuredLength> lengths,
                           std::optional<double> reach_mm) {
  TestResult result;
  result.name = "length error, bidirectional";
  result.standard = kStandard;
  result.definition =
      "measured minus calibrated length, ends touched from opposite directions; of all lengths the "
      "one that takes the largest share of its limit, without a limit the largest by magnitude";
  result.parts = length_errors(lengths);
  result.value_mm = largest_by_magnitude(result.parts);
  result.missing = missing_lengths(lengths, reach_mm);
  result.problems = problems_of(lengths);
  return with_symbol_if_complete(std::move(result), "E_Bi");
}

}  // namespace armcal::iso10360_12
