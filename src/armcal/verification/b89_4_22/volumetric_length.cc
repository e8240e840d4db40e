// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/b89_4_22/volumetric_length.h"

#include <cmath>

#include "armcal/verification/as_asked.h"
#include "armcal/verification/b89_4_22/standard.h"

namespace armcal::b89_4_22 {
namespace {

constexpr std::size_t kPlacements = 20;

}  // namespace

std::vector<TestResult> volumetric_length(std::span<const MeasuredLength> lengths) {
  TestResult largest;
  largest.name = "volumetric length, largest error";
  largest.standard = kStandard;
  largest.definition =
      "measured minus calibrated length; of twenty placements the one that takes the largest share "
      "of its limit, without a limit the largest by magnitude";
  add_unless_as_asked(largest.missing, lengths.size(), kPlacements, "length");
  largest.problems = problems_of(lengths);

  TestResult twice_rms = largest;
  twice_rms.name = "volumetric length, 2 RMS";
  twice_rms.definition =
      "twice the root mean square, about zero, of measured minus calibrated length over twenty "
      "placements";
  twice_rms.is_signed = false;

  largest.parts = length_errors(lengths);
  largest.value_mm = largest_by_magnitude(largest.parts);
  if (!lengths.empty()) {
    double squares = 0.0;
    for (const ResultPart& part : largest.parts) squares += part.value_mm * part.value_mm;
    twice_rms.value_mm = 2.0 * std::sqrt(squares / static_cast<double>(lengths.size()));
  }
  return {std::move(largest), std::move(twice_rms)};
}

}  // namespace armcal::b89_4_22
