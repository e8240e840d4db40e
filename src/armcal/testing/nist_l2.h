// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace armcal::testing {

/// One NIST L2 reference pair: the points and the numbers of the reference fit, in NIST's order.
struct NistPair {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> fit;
};

/// All pairs of a geometry ("Sphere", "Plane", "Circle3d", "Line3d", ..) of the reference data.
[[nodiscard]] std::vector<NistPair> nist_pairs(const std::string& geometry);

}  // namespace armcal::testing
