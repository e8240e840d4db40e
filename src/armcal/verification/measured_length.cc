// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/measured_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/verification/as_asked.h"

namespace armcal {
namespace {

// More than any arm that is taken for one measures wrong.
constexpr double kAnotherLengthShare = 0.1;
constexpr double kAnotherLength_mm = 5.0;

std::string name_of(const MeasuredLength& length) {
  std::string name = fmt::format("{:.6g} mm", length.calibrated_mm);
  if (!length.position.empty()) name += " at " + length.position;
  if (length.repeat > 0) name += fmt::format(", repeat {}", length.repeat);
  return name;
}

std::optional<std::string> problem_of(const MeasuredLength& length) {
  if (!(std::isfinite(length.calibrated_mm) && length.calibrated_mm > 0.0)) {
    return fmt::format("calibrated length {} mm must be larger than 0", length.calibrated_mm);
  }
  if (!(std::isfinite(length.measured_mm) && length.measured_mm > 0.0)) {
    return fmt::format("measured length {} mm must be larger than 0", length.measured_mm);
  }
  const double error_mm = std::abs(length.measured_mm - length.calibrated_mm);
  const double tolerated_mm =
      std::max(kAnotherLength_mm, kAnotherLengthShare * length.calibrated_mm);
  const auto unit = unit_that_explains(length.measured_mm, length.calibrated_mm);
  if (error_mm <= tolerated_mm && !unit) return std::nullopt;
  const std::string measured = fmt::format("{:.4f} mm was measured: ", length.measured_mm);
  return measured + unit.value_or("another length?");
}

}  // namespace

std::vector<ResultPart> length_errors(std::span<const MeasuredLength> lengths) {
  std::vector<ResultPart> parts;
  for (const MeasuredLength& length : lengths) {
    parts.push_back({.name = name_of(length),
                     .value_mm = length.measured_mm - length.calibrated_mm,
                     .length_mm = length.calibrated_mm,
                     .readings = 1,
                     .where = length.where});
  }
  return parts;
}

std::vector<std::string> problems_of(std::span<const MeasuredLength> lengths) {
  std::vector<std::string> problems;
  for (const MeasuredLength& length : lengths) {
    if (const auto problem = problem_of(length)) {
      problems.push_back(name_of(length) + ": " + *problem);
    }
  }
  return problems;
}

}  // namespace armcal
