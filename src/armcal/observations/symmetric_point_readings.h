// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/diagnostics.h"

namespace armcal {

/// The three gestures of the symmetric-point procedure; theory/symmetric_point.md.
enum class SymmetricKind {
  reversal,  ///< distance of the tip before and after a half turn of one joint, the rest locked
  circle_radius,  ///< radius of the circle of the tip while one joint turns
  zero_search,  ///< reading of a joint at which the circle of a lower joint is smallest or largest
};
[[nodiscard]] std::string_view to_string(SymmetricKind kind);

/// Points that a reference machine took for one reading.
struct RawSymmetricPoints {
  std::string file;
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<char> end;            ///< reversal: 'A' before, 'B' after the half turn; else empty
  std::vector<double> setting_rad;  ///< zero_search: reading of the searched joint; else empty
  Eigen::MatrixXd encoder_rad;      ///< readings of all joints, one column per point; or no columns
  std::vector<int> lines;
};

/// One reading: a scalar function of the arm, at a stated posture. Reduced readings carry `value`
/// and `u`; raw ones carry points and get them by `reduce`.
struct SymmetricReading {
  std::string name;
  SymmetricKind kind = SymmetricKind::reversal;
  int joint = 0;  ///< joint turned (reversal, circle_radius) or searched (zero_search), from 1
  int sweep = 0;  ///< zero_search: the lower joint whose circle is watched, from 1
  /// Encoder readings with the tip at its first end, and at the second (reversal; differs in
  /// `joint` by a half turn where the file does not say better).
  Eigen::VectorXd posture_rad;
  Eigen::VectorXd posture_end_rad;
  double value = 0.0;  ///< mm; rad for zero_search
  /// Standard uncertainty, same unit; positive once reduced. Of a raw reading: what repeats cannot
  /// show (type B), and then always mm - for a zero search of each radius.
  double u = 0.0;
  bool reduced = false;
  std::optional<RawSymmetricPoints> raw;
  std::string
      solves;  ///< parameter that the chain of equations takes from this reading; may be empty
  SourcePosition where;

  [[nodiscard]] bool is_angle() const { return kind == SymmetricKind::zero_search; }
};

/// A published result, to be held against the readings.
struct Claim {
  std::string parameter;
  double value = 0.0;  ///< mm or rad, as the parameter
  double u = 0.0;      ///< standard uncertainty of its rounding, same unit
  SourcePosition where;
};

/// Everything a *.symmetric.toml says.
struct SymmetricPointProcedure {
  std::string file;      ///< where it was read from
  std::string arm_file;  ///< path as resolved from there
  std::vector<SymmetricReading> readings;
  std::vector<Claim> claims;
  /// Names or patterns of the parameters to estimate; empty: those that readings `solve`. "*" is
  /// everything that the readings determine.
  std::vector<std::string> unknowns;
  std::vector<std::string> hold;
  /// What may have the opposite sign of the nominal arm: parameters, and `direction4` for a
  /// counting direction.
  std::vector<std::string> unknown_signs;
  /// Standard uncertainty of one reading of one encoder: what it adds to a distance is added to
  /// that of each reading.
  double u_encoder_rad = 0.0;
  double significance = 0.001;  ///< level of the outlier tests (each reading)
  double power = 0.80;          ///< with which the smallest detectable error is detected
};

}  // namespace armcal
