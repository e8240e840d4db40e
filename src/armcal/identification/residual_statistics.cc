// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residual_statistics.h"

#include <algorithm>
#include <cmath>

#include "armcal/numerics/distributions.h"
#include "armcal/numerics/median.h"

namespace armcal {
namespace {

// Coordinates that one observation compares.
Eigen::Index dimension(const Residual& residual) { return residual.rows_per_observation(); }

// Derivatives that a row of it has.
Eigen::Index column_count(const Residual& residual, const Unknowns& unknowns) {
  Eigen::Index count = residual.depends_on_arm() ? unknowns.arm_size() : 0;
  for (const int id : residual.nuisances()) {
    count += static_cast<Eigen::Index>(step_names(unknowns[id]).size());
  }
  return count;
}

// Root of the sum of squares of rows first .. first + size - 1.
double length_of(const BlockRows& rows, Eigen::Index first, Eigen::Index size) {
  double squares = 0.0;
  for (Eigen::Index r = first; r < first + size; ++r)
    squares += rows.residual(r) * rows.residual(r);
  return std::sqrt(squares);
}

void append_residuals(const Residual& residual, const ArmAt& at, const Unknowns& unknowns,
                      const Eigen::VectorXd& x, std::vector<ObservationResidual>& result) {
  const Eigen::Index size = dimension(residual);
  const double points = std::max<double>(1.0, static_cast<double>(size) / 3.0);
  const Eigen::Index columns = column_count(residual, unknowns);
  for (Eigen::Index first = 0; first < residual.count(); first += kObservationsPerBlock) {
    const Eigen::Index count = std::min(kObservationsPerBlock, residual.count() - first);
    std::vector<double> data(static_cast<std::size_t>(size * count * (columns + 1)), 0.0);
    const BlockRows rows{size * count, columns, columns + 1, data.data()};
    residual.fill(at, unknowns, x, first, count, rows);
    const std::size_t begin = result.size();
    for (Eigen::Index k = 0; k < count; ++k) {
      result.push_back(
          {&residual, first + k, length_of(rows, size * k, size) / std::sqrt(points), 0.0});
    }
    residual.whiten(first, count, rows);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double length = length_of(rows, size * k, size);
      result[begin + static_cast<std::size_t>(k)].normalised_square = length * length;
    }
  }
}

}  // namespace

std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const Unknowns& unknowns,
    const Eigen::VectorXd& x) {
  const ArmModel arm = unknowns.arm_at(x);
  const ArmAt at{arm, TipRows(arm, unknowns.columns())};
  std::vector<ObservationResidual> result;
  for (const Residual* residual : residuals) append_residuals(*residual, at, unknowns, x, result);
  return result;
}

ResidualStatistics statistics_of(const std::vector<ObservationResidual>& residuals,
                                 const ObservationGroup& group) {
  ResidualStatistics statistics;
  double squares = 0.0;
  for (const ObservationResidual& each : residuals) {
    if (&each.residual->group() != &group) continue;
    ++statistics.count;
    squares += each.length_mm * each.length_mm;
    statistics.mean_mm += each.length_mm;
    statistics.max_mm = std::max(statistics.max_mm, each.length_mm);
  }
  if (statistics.count == 0) return statistics;
  statistics.mean_mm /= static_cast<double>(statistics.count);
  statistics.rms_mm = std::sqrt(squares / static_cast<double>(statistics.count));
  return statistics;
}

std::vector<FlaggedRow> flagged_rows(const std::vector<ObservationResidual>& residuals,
                                     bool is_check) {
  std::vector<FlaggedRow> flagged;
  constexpr std::size_t kLeast = 8;  // fewer tell no usual size
  if (residuals.size() < kLeast) return flagged;
  // One usual size for all: ratios of squares to their medians if the stated uncertainties were
  // right.
  std::vector<double> ratios;
  for (const ObservationResidual& each : residuals) {
    const auto freedom = static_cast<double>(dimension(*each.residual));
    ratios.push_back(each.normalised_square / chi_squared_quantile(0.5, freedom));
  }
  const double scale = median(ratios);
  if (!(scale > 0.0)) return flagged;
  const double level = 1.0 - 0.01 / static_cast<double>(residuals.size());
  for (const ObservationResidual& each : residuals) {
    const auto freedom = static_cast<double>(dimension(*each.residual));
    const double square = each.normalised_square / scale;
    if (square <= chi_squared_quantile(level, freedom)) continue;
    const ObservationGroup& group = each.residual->group();
    const int row = each.residual->row(each.observation);
    flagged.push_back({group.name,
                       {group.file, group.lines[static_cast<std::size_t>(row)], 0},
                       each.length_mm,
                       std::sqrt(square / freedom),
                       is_check});
  }
  std::stable_sort(flagged.begin(), flagged.end(),
                   [](const FlaggedRow& one, const FlaggedRow& other) {
                     return one.normalised > other.normalised;
                   });
  return flagged;
}

}  // namespace armcal
