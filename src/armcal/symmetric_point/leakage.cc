// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/leakage.h"

#include <algorithm>

#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/symmetric_point/adjustment.h"

namespace armcal {
namespace {

// The least-squares inverse of the recovered columns applied to all the others.
std::optional<Leakage> leakage_of_design(const ParameterTable& table, const Eigen::MatrixXd& design,
                                         const std::vector<int>& recovered) {
  Leakage leakage;
  std::vector<int> assumed;
  for (int i = 0; i < table.size(); ++i) {
    if (std::find(recovered.begin(), recovered.end(), i) == recovered.end()) assumed.push_back(i);
  }
  Eigen::MatrixXd own(design.rows(), static_cast<Eigen::Index>(recovered.size()));
  for (std::size_t i = 0; i < recovered.size(); ++i) {
    own.col(static_cast<Eigen::Index>(i)) = design.col(recovered[i]);
    leakage.recovered.push_back(table[recovered[i]].name);
  }
  Eigen::MatrixXd others(design.rows(), static_cast<Eigen::Index>(assumed.size()));
  for (std::size_t i = 0; i < assumed.size(); ++i) {
    others.col(static_cast<Eigen::Index>(i)) = design.col(assumed[i]);
    leakage.assumed.push_back(table[assumed[i]].name);
  }
  const auto factor = inverse_factor(own);
  if (!factor) return std::nullopt;
  leakage.table = *factor * (factor->transpose() * (own.transpose() * others));
  return leakage;
}

}  // namespace

std::optional<Leakage> leakage_of_adjustment(const ArmModel& arm,
                                             std::span<const SymmetricReading> readings,
                                             const std::vector<int>& recovered) {
  return leakage_of_design(ParameterTable(arm), design_matrix(arm, readings), recovered);
}

std::optional<Leakage> leakage_of_chain(const ArmModel& arm,
                                        std::span<const SymmetricReading> readings) {
  const ParameterTable table(arm);
  std::vector<SymmetricReading> links;
  std::vector<int> recovered;
  for (const SymmetricReading& reading : readings) {
    if (reading.solves.empty()) continue;
    links.push_back(reading);
    recovered.push_back(table.find(reading.solves).value());
  }
  return leakage_of_design(table, design_matrix(arm, links), recovered);
}

}  // namespace armcal
