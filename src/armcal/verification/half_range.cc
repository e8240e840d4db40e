// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/half_range.h"

#include <Eigen/Dense>

namespace armcal {

TestResult half_range(std::span<const Eigen::Vector3d> points_mm, const std::string& seat) {
  TestResult result;
  result.name = "half range per axis, " + seat;
  result.definition =
      "(largest - smallest) / 2 of the coordinates of one seat along each of x, y and z; the "
      "largest of the three";
  result.is_signed = false;
  if (points_mm.size() < 2) {
    result.missing.push_back("a range needs at least 2 points in " + seat);
    return result;
  }
  Eigen::Array3d low = points_mm.front().array();
  Eigen::Array3d high = low;
  for (const Eigen::Vector3d& point : points_mm) {
    if (!point.allFinite()) {
      result.problems.push_back(seat + ": a coordinate is not a finite number");
      return result;
    }
    low = low.min(point.array());
    high = high.max(point.array());
  }
  const Eigen::Array3d half = (high - low) / 2.0;
  const int readings = static_cast<int>(points_mm.size());
  for (const int axis : {0, 1, 2}) {
    result.parts.push_back(
        {.name = std::string(1, "xyz"[axis]), .value_mm = half(axis), .readings = readings});
  }
  result.value_mm = half.maxCoeff();
  return result;
}

}  // namespace armcal
