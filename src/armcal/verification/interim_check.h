// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/verification/verdict.h"

namespace armcal {

enum class CheckKind {
  seat,    ///< the ball of the probe in a cone or kinematic seat, in many postures
  sphere,  ///< points on a sphere of certified diameter
};
[[nodiscard]] std::string_view to_string(CheckKind kind);

/// Points of one seat or on one sphere.
struct TouchedPlace {
  std::string name;  ///< may be empty
  std::vector<Eigen::Vector3d> points_mm;
};

/// Largest allowed magnitudes, mm; nothing: not judged.
struct CheckLimits {
  std::optional<double> deviation_mm, twice_s_mm, half_range_mm;  ///< seats
  std::optional<double> diameter_mm, form_mm;                     ///< spheres
  std::optional<double> length_mm;                                ///< of the length error
};

struct InterimCheckOptions {
  std::optional<double> diameter_mm;  ///< certified diameter: spheres; without it seats
  double tip_diameter_mm = 0.0;       ///< diameter of the probe's ball, taken off (outside contact)
  std::optional<double> length_mm;    ///< certified distance of the two places
  CheckLimits limits;
};

/// One number of a check, and how it was judged. Limits are compared with values as they are: a
/// check of five minutes asks whether the arm is as it was, not whether it conforms.
struct CheckValue {
  std::string name;   ///< key of files: max_deviation
  std::string title;  ///< "largest deviation"
  std::string definition;
  double value_mm = 0.0;
  std::optional<double> limit_mm;
  Verdict verdict = Verdict::not_judged;
};

/// A seat or sphere of a check as it was found.
struct CheckedPlace {
  std::string name;
  std::size_t count = 0;
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();  ///< mean point, centre of the sphere
};

/// The five-minute check between calibrations: one or more seats or spheres, and where there are
/// two the length between them.
///
/// Seats: max_deviation and two_s (theory/verification.md eq. (7), (8)), half_range_x, _y, _z (eq.
/// (10)). Spheres: diameter_error, form_error. Of several places the worst counts. Two places:
/// length, and length_error where its certificate is given (theory/interim_check.md eq. (1)).
struct InterimCheck {
  CheckKind kind = CheckKind::seat;
  std::vector<CheckedPlace> places;
  std::vector<CheckValue> values;

  [[nodiscard]] Verdict verdict() const;
};

/// Fewest points of a place that can contradict each other, and so many that an own bad one stands
/// out.
[[nodiscard]] std::size_t least_points(CheckKind kind);
[[nodiscard]] std::size_t advised_points(CheckKind kind);

/// What keeps these places from being checked so, in words; empty where nothing does.
[[nodiscard]] std::vector<std::string> problems_of(std::span<const TouchedPlace> places,
                                                   const InterimCheckOptions& options);

/// @throws std::invalid_argument with all `problems_of`; NumericalError where points are no sphere
[[nodiscard]] InterimCheck check_arm(std::span<const TouchedPlace> places,
                                     const InterimCheckOptions& options);

/// Values that a history is watched by: one that tells of the arm's repeatability, one of its
/// scale. Watching all would alarm falsely several times as often.
[[nodiscard]] bool is_watched(std::string_view name);
/// May the value be negative, so that it has limits on both sides?
[[nodiscard]] bool is_signed(std::string_view name);
/// "largest deviation" for "max_deviation"; the name itself where it is not known.
[[nodiscard]] std::string title_of(std::string_view name);

}  // namespace armcal
