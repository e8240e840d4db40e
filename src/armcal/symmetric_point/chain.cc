// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/chain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numeric>

#include "armcal/arm/estimability.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/rank_analysis.h"
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

// Rows: readings; columns: the parameters they solve.
Eigen::MatrixXd chain_design(const ArmModel& arm, const std::vector<const SymmetricReading*>& used,
                             const std::vector<int>& solved) {
  const auto count = static_cast<Eigen::Index>(solved.size());
  Eigen::MatrixXd design(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::VectorXd gradient = predict(arm, *used[static_cast<std::size_t>(i)]).gradient;
    for (Eigen::Index j = 0; j < count; ++j) {
      design(i, j) = gradient(solved[static_cast<std::size_t>(j)]);
    }
  }
  return design;
}

// Why these readings cannot give these parameters, or nothing where they can.
std::string reason_of_singularity(const Eigen::MatrixXd& design, const Chain& chain) {
  if (!design.allFinite()) return "a reading does not exist on the arm that the chain gives";
  std::vector<int> order(chain.steps.size());
  std::iota(order.begin(), order.end(), 0);
  const RankAnalysis analysis = analyse_rank(design, order);
  std::vector<std::string> names;
  std::vector<std::string> readings;
  for (const ChainStep& step : chain.steps) {
    names.push_back(step.parameter);
    readings.push_back(step.reading);
  }
  const std::string all = fmt::format("{}", fmt::join(readings, ", "));
  for (const DependentColumn& dependent : analysis.dependent) {
    return fmt::format("{} cannot tell {} from the rest: {}", all,
                       names[static_cast<std::size_t>(dependent.column)],
                       describe(dependent, analysis, names));
  }
  for (const int unseen : analysis.unseen) {
    return fmt::format("{} do not depend on {}", all, names[static_cast<std::size_t>(unseen)]);
  }
  return {};
}

// Each reading depends on its own parameter and on earlier ones: the uncertainties follow by
// forward substitution, parameter by parameter.
void add_uncertainties(Chain& chain, const Eigen::MatrixXd& design,
                       const std::vector<const SymmetricReading*>& used) {
  const Eigen::Index count = design.rows();
  Eigen::MatrixXd gain = Eigen::MatrixXd::Zero(count, count);  // parameters by readings
  for (Eigen::Index i = 0; i < count; ++i) {
    gain(i, i) = 1.0;
    for (Eigen::Index j = 0; j < i; ++j) gain.row(i) -= design(i, j) * gain.row(j);
    gain.row(i) /= design(i, i);
    double variance = 0.0;
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double part = gain(i, j) * used[static_cast<std::size_t>(j)]->u;
      variance += part * part;
    }
    chain.steps[static_cast<std::size_t>(i)].u = std::sqrt(variance);
  }
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
    Eigen::VectorXd attempt = values;
    if (!solve_reading(nominal, reading, index, attempt)) {
      chain.problem = fmt::format("{} cannot be solved for {}", reading.name, reading.solves);
      break;
    }
    values = attempt;
    solved.push_back(index);
    used.push_back(&reading);
    chain.steps.push_back({table[index].name, reading.name, table[index].unit == ParameterUnit::rad,
                           values(index), 0.0});
  }
  chain.arm = with_parameter_values(nominal, values);
  const Eigen::MatrixXd design = chain_design(chain.arm, used, solved);
  const std::string singularity = reason_of_singularity(design, chain);
  if (!singularity.empty()) {
    chain.problem = singularity;
    chain.steps.clear();
    chain.arm = nominal;
    return chain;
  }
  chain.complete = chain.problem.empty();
  add_uncertainties(chain, design, used);
  return chain;
}

}  // namespace armcal
