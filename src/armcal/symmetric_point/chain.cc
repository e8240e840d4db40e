// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/chain.h"

#include <fmt/format.h>

#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

// Solves one reading for one parameter; false when the reading does not depend on it or no value
// fits.
bool solve_reading(const ArmModel& arm, const SymmetricReading& reading, int index,
                   Eigen::VectorXd& values) {
  constexpr int kMaxSteps = 50;
  const double tolerance = reading.is_angle() ? 1e-14 : 1e-12 * reach_mm(arm);
  for (int i = 0; i < kMaxSteps; ++i) {
    const ReadingPrediction prediction = predict(with_parameter_values(arm, values), reading);
    const double slope = prediction.gradient(index);
    if (!std::isfinite(slope) || std::abs(slope) < 1e-6) return false;
    const double missing = reading.value - prediction.value;
    if (std::abs(missing) <= tolerance) return true;
    values(index) += missing / slope;
  }
  return false;
}

}  // namespace

Chain solve_chain(const ArmModel& nominal, std::span<const SymmetricReading> readings) {
  const ParameterTable table(nominal);
  Chain chain;
  Eigen::VectorXd values = parameter_values(nominal);
  std::vector<int> solved;
  std::vector<const SymmetricReading*> used;
  for (const SymmetricReading& reading : readings) {
    if (reading.solves.empty()) continue;
    const int index = table.find(reading.solves).value();
    if (!solve_reading(nominal, reading, index, values)) {
      chain.problem = fmt::format("{} cannot be solved for {}", reading.name, reading.solves);
      chain.arm = with_parameter_values(nominal, values);
      return chain;
    }
    solved.push_back(index);
    used.push_back(&reading);
    chain.steps.push_back({table[index].name, reading.name, table[index].unit == ParameterUnit::rad,
                           values(index), 0.0});
  }
  chain.complete = true;
  chain.arm = with_parameter_values(nominal, values);

  // Each reading depends on its own parameter and on earlier ones: the uncertainties follow by
  // forward substitution, parameter by parameter.
  const auto count = static_cast<Eigen::Index>(solved.size());
  Eigen::MatrixXd gain = Eigen::MatrixXd::Zero(count, count);  // parameters by readings
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::VectorXd gradient = predict(chain.arm, *used[at]).gradient;
    gain(i, i) = 1.0;
    for (Eigen::Index j = 0; j < i; ++j) {
      gain.row(i) -= gradient(solved[static_cast<std::size_t>(j)]) * gain.row(j);
    }
    gain.row(i) /= gradient(solved[at]);
    double variance = 0.0;
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double part = gain(i, j) * used[static_cast<std::size_t>(j)]->u;
      variance += part * part;
    }
    chain.steps[at].u = std::sqrt(variance);
  }
  return chain;
}

}  // namespace armcal
