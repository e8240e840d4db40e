// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/geometry/sphere.h"

namespace armcal {

/// Fewest points that can contradict a sphere.
inline constexpr Eigen::Index kLeastPointsForForm = 5;

/// Points probed on a calibrated sphere in one go: at one position, or with one articulation.
struct SpherePoints {
  std::string name;  ///< of the position or articulation, as the user calls it
  std::vector<Eigen::Vector3d> points_mm;  ///< centres of the probe's ball
  std::string where;                       ///< place in the user's file; may be empty
};

/// What the points are held against.
struct ReferenceSphere {
  double diameter_mm = 0.0;  ///< certified, at the temperature of the test
  /// Diameter of the probe's ball, taken off the fitted diameter (contact from outside). 0 where
  /// the points are of the surface itself.
  double probe_diameter_mm = 0.0;
};

/// Least-squares sphere through one set of points.
struct ProbedSphere {
  SphereFit fit;             ///< of the centres of the probe's ball
  double diameter_mm = 0.0;  ///< probe taken off
  double diameter_error_mm = 0.0;
  /// Why these points cannot be points on this sphere: refused by the fit, another sphere (diameter
  /// off by more than 1 mm or 10 % and by more than the form error: a bad arm shows form as well),
  /// other units (10, 25.4, 100 or 1000 times too large or small), no sphere at all (form error of
  /// more than half the diameter). In words, with the name of the set.
  std::optional<std::string> problem;

  [[nodiscard]] bool ok() const { return fit.ok(); }
};

/// theory/verification.md eq. (1), (2)
/// @param what  word for the set in messages: "position" gives "position A: ..."
/// @throws std::invalid_argument unless the diameter is positive and finite, and that of the probe
/// not negative and finite
[[nodiscard]] ProbedSphere probe_sphere(const SpherePoints& points, const ReferenceSphere& sphere,
                                        const std::string& what);

}  // namespace armcal
