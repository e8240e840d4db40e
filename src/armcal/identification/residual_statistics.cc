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

// Points that it compares: poses count as three.
double point_count(const Residual& residual) {
  return std::max(1.0, static_cast<double>(dimension(residual)) / 3.0);
}

Eigen::Index nuisance_columns(const Residual& residual, const Unknowns& unknowns) {
  Eigen::Index count = 0;
  for (const int id : residual.nuisances()) {
    count += static_cast<Eigen::Index>(step_names(unknowns[id]).size());
  }
  return count;
}

// Measured - predicted of rows first .. first + size - 1.
RowComponents differences(const BlockRows& rows, Eigen::Index first, Eigen::Index size) {
  RowComponents result(size);
  for (Eigen::Index r = 0; r < size; ++r) result(r) = -rows.residual(first + r);
  return result;
}

// @param unknowns  without columns of the arm
void append_residuals(const Residual& residual, const ArmAt& at, const Unknowns& unknowns,
                      const Eigen::VectorXd& x, std::vector<ObservationResidual>& result) {
  const Eigen::Index size = dimension(residual);
  const double points = point_count(residual);
  const Eigen::Index columns = nuisance_columns(residual, unknowns);
  for (Eigen::Index first = 0; first < residual.count(); first += kObservationsPerBlock) {
    const Eigen::Index count = std::min(kObservationsPerBlock, residual.count() - first);
    std::vector<double> data(static_cast<std::size_t>(size * count * (columns + 1)), 0.0);
    const BlockRows rows{size * count, columns, columns + 1, data.data()};
    residual.fill(at, unknowns, x, first, count, rows);
    const std::size_t begin = result.size();
    for (Eigen::Index k = 0; k < count; ++k) {
      const RowComponents own_mm = differences(rows, size * k, size);
      ObservationResidual each{
          &residual, first + k, own_mm.norm() / std::sqrt(points), Eigen::Vector3d::Zero(), {}};
      const Eigen::Index shown = std::min<Eigen::Index>(3, size);
      each.first_mm.head(shown) = own_mm.head(shown);
      result.push_back(each);
    }
    residual.whiten(first, count, rows);
    for (Eigen::Index k = 0; k < count; ++k) {
      result[begin + static_cast<std::size_t>(k)].components = differences(rows, size * k, size);
    }
  }
}

}  // namespace

std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const Unknowns& unknowns,
    const Eigen::VectorXd& x) {
  return residuals_of_observations(residuals, unknowns.arm_at(x), unknowns, x);
}

std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const ArmModel& arm, const Unknowns& unknowns,
    const Eigen::VectorXd& x) {
  const ArmAt at{arm, TipRows(arm, {})};
  // Without columns of the arm: derivatives would take longer than all the rest.
  const Unknowns places = unknowns.with_free({});
  const Eigen::VectorXd values = places.state_from(unknowns, x);
  std::vector<ObservationResidual> result;
  Eigen::Index count = 0;
  for (const Residual* residual : residuals) count += residual->count();
  result.reserve(static_cast<std::size_t>(count));
  for (const Residual* residual : residuals)
    append_residuals(*residual, at, places, values, result);
  return result;
}

ResidualStatistics statistics_of(const std::vector<ObservationResidual>& residuals,
                                 const ObservationGroup& group) {
  ResidualStatistics statistics;
  double squares = 0.0;
  double variances = 0.0;
  for (const ObservationResidual& each : residuals) {
    if (&each.residual->group() != &group) continue;
    ++statistics.count;
    squares += each.length_mm * each.length_mm;
    variances += each.residual->variance(each.observation) / point_count(*each.residual);
    statistics.mean_mm += each.length_mm;
    statistics.max_mm = std::max(statistics.max_mm, each.length_mm);
  }
  if (statistics.count == 0) return statistics;
  statistics.mean_mm /= static_cast<double>(statistics.count);
  statistics.rms_mm = std::sqrt(squares / static_cast<double>(statistics.count));
  statistics.floor_mm = std::sqrt(variances / static_cast<double>(statistics.count));
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
    ratios.push_back(each.components.squaredNorm() / chi_squared_quantile(0.5, freedom));
  }
  const double scale = median(ratios);
  if (!(scale > 0.0)) return flagged;
  const double level = 1.0 - 0.01 / static_cast<double>(residuals.size());
  for (const ObservationResidual& each : residuals) {
    const auto freedom = static_cast<double>(dimension(*each.residual));
    const double square = each.components.squaredNorm() / scale;
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
