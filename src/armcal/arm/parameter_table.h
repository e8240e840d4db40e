// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

enum class ParameterKind { zero, d, b, a, alpha, beta, tip_a, tip_b, tip_d, cosine, sine };

enum class ParameterUnit { mm, rad };

/// free: estimated from the data; held: kept at its nominal value; prior: estimated, with a stated
/// uncertainty about the nominal value as one more datum.
enum class ParameterStatus { free, held, prior };

[[nodiscard]] std::string_view to_string(ParameterUnit unit);
[[nodiscard]] std::string_view to_string(ParameterStatus status);

/// The one definition of a parameter: files, results, reports and front ends all read this.
struct Parameter {
  std::string name;  ///< zero1, d2, b3, alpha4, beta4, a7 (tip of a six-joint arm), cos1_3 ..
  ParameterKind kind = ParameterKind::zero;
  int joint =
      0;  ///< joint of a zero or harmonic; joint a link leads to; n + 1 for the tip. From 1.
  int harmonic = 0;  ///< order k of a harmonic, else 0
  ParameterUnit unit = ParameterUnit::mm;
  double nominal = 0.0;  ///< value in the arm that the table was made from
  ParameterStatus status = ParameterStatus::held;
};

/// All parameters of an arm in their fixed order: zero1..zeroN; d b a alpha beta of each link, base
/// to tip; a b d of the tip; cos and sin of each harmonic, joint by joint. Vectors of parameters
/// and columns of Jacobians everywhere follow it.
class ParameterTable {
 public:
  explicit ParameterTable(const ArmModel& arm);

  [[nodiscard]] int size() const { return static_cast<int>(parameters_.size()); }
  [[nodiscard]] const Parameter& operator[](int index) const {
    return parameters_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] Eigen::VectorXd nominal() const;

  [[nodiscard]] std::optional<int> find(std::string_view name) const;
  /// Indices of all names that match a shell-like pattern such as `alpha*`.
  [[nodiscard]] std::vector<int> matching(std::string_view pattern) const;

  void set_status(int index, ParameterStatus status) {
    parameters_[static_cast<std::size_t>(index)].status = status;
  }

 private:
  std::vector<Parameter> parameters_;
};

/// Value of every parameter of the arm, in table order.
[[nodiscard]] Eigen::VectorXd parameter_values(const ArmModel& arm);

/// The same arm with other values. @param values  in table order of this arm
[[nodiscard]] ArmModel with_parameter_values(const ArmModel& arm, const Eigen::VectorXd& values);

}  // namespace armcal
