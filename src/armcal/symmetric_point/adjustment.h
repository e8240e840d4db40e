// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// One reading beside the adjusted model, with what the other readings say about it.
struct AdjustedReading {
  std::string name;
  bool is_angle = false;  ///< values in rad, else mm
  double value = 0.0;
  double predicted = 0.0;  ///< by the adjusted arm
  double residual = 0.0;   ///< measured - predicted
  double u = 0.0;
  /// Share of the reading that is checked by the others, 0 (by nothing) to 1. Baarda's redundancy
  /// number.
  double redundancy = 0.0;
  /// Smallest error of this reading that the test detects; nothing where nothing checks it.
  std::optional<double> smallest_detectable;
  /// residual over its own standard deviation; nothing where nothing checks it.
  std::optional<double> normalised;
  bool flagged = false;
  /// Other readings whose test is the same test: where one of them is wrong, none can be told from
  /// the rest.
  std::vector<std::string> inseparable_from;
  /// The error that would explain the residual, were it this reading's alone.
  std::optional<double> estimated_error;
};

/// A parameter that stays at its nominal value although it was asked for.
struct HeldParameter {
  std::string name;
  std::string reason;  ///< in words
  /// Weights of the adjusted parameters that move the readings alike; empty where no reading
  /// depends on it.
  std::vector<std::pair<std::string, double>> like;
};

enum class AdjustmentStatus {
  converged,
  no_readings,
  nothing_determined,
  not_defined,
  no_convergence
};
[[nodiscard]] std::string_view explain(AdjustmentStatus status);

/// Result of the weighted least-squares adjustment of all readings.
struct Adjustment {
  AdjustmentStatus status = AdjustmentStatus::no_readings;
  std::string detail;         ///< which reading is not defined, say
  ArmModel arm;               ///< with the adjusted values
  std::vector<int> unknowns;  ///< indices into the parameter table, most wanted first
  std::vector<std::string> unknown_names;
  Eigen::VectorXd values;      ///< of the unknowns, mm or rad
  Eigen::MatrixXd covariance;  ///< of the unknowns, from the stated uncertainties
  std::vector<HeldParameter> undetermined;
  double condition_number = 1.0;  ///< of the column-scaled design
  std::vector<AdjustedReading> readings;
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  /// Probability of a chi-squared at least as large if the uncertainties are as stated; 1 without
  /// redundancy.
  double chi_squared_probability = 1.0;
  double critical_value = 0.0;  ///< of |normalised| at the level of the test
  int iterations = 0;

  [[nodiscard]] bool ok() const { return status == AdjustmentStatus::converged; }
  [[nodiscard]] bool has_flagged() const;
  /// Standard uncertainty of an unknown by its place in `unknowns`.
  [[nodiscard]] double u(Eigen::Index place) const;
};

struct AdjustmentOptions {
  /// Parameters to estimate, by table index. What the readings cannot tell apart is held and told:
  /// first what is neither a length that the nominal arm has nor a zero that is searched, and each
  /// from the end of `wanted_order`.
  std::vector<int> unknowns;
  double significance = 0.001;
  double power = 0.80;
  /// A parameter that the readings determine no better than this is as good as unseen and is held.
  double largest_useful_u_mm = 5.0;
  double largest_useful_u_rad = 0.05;
};

/// What readings can determine of the parameters that are asked for.
struct DeterminedParameters {
  std::vector<int> unknowns;  ///< table indices, most wanted first
  std::vector<HeldParameter> held;
  double condition_number = 1.0;  ///< of the column-scaled design
};

/// The choice that `adjust` makes, at this arm. @param readings  with u > 0; values are not used
[[nodiscard]] DeterminedParameters determined_parameters(const ArmModel& arm,
                                                         std::span<const SymmetricReading> readings,
                                                         const AdjustmentOptions& options);
/// The same, of all parameters of the arm.
[[nodiscard]] DeterminedParameters determined_parameters(
    const ArmModel& arm, std::span<const SymmetricReading> readings);

/// Weighted least squares over all readings, starting from `nominal`, which also gives every
/// parameter that is not estimated. Data snooping: the reading with the largest normalised residual
/// above the critical value is flagged, set aside, and the rest is tested again.
/// theory/symmetric_point.md eq. (4)-(10).
/// @param readings  reduced, with u > 0; postures of the arm's number of joints
[[nodiscard]] Adjustment adjust(const ArmModel& nominal, std::span<const SymmetricReading> readings,
                                const AdjustmentOptions& options);

/// Whitened design of readings: row i is the gradient of reading i over its uncertainty, by every
/// parameter.
[[nodiscard]] Eigen::MatrixXd design_matrix(const ArmModel& arm,
                                            std::span<const SymmetricReading> readings);

}  // namespace armcal
