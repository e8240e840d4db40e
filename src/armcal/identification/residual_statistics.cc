// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residual_statistics.h"

#include <algorithm>
#include <cmath>

#include "armcal/identification/estimation_problem.h"
#include "armcal/numerics/distributions.h"
#include "armcal/numerics/median.h"

namespace armcal {
namespace {

// Coordinates that one observation compares.
Eigen::Index dimension(const Residual& residual) { return residual.rows_per_observation(); }

// Residual in units of its stated uncertainty, as a chi-squared of that many degrees of freedom.
double normalised_square(const ObservationResidual& each) {
  const double points = std::max<double>(1.0, static_cast<double>(dimension(*each.residual)) / 3.0);
  const double whitened = each.length_mm / each.residual->u_mm(each.observation);
  return whitened * whitened * points;
}

}  // namespace

std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const Unknowns& unknowns,
    const Eigen::VectorXd& x) {
  const EstimationProblem problem(residuals, unknowns, {});
  const Eigen::VectorXd whitened = residuals_at(problem, x);
  std::vector<ObservationResidual> result;
  Eigen::Index row = 0;
  for (const EstimationProblem::Block& block : problem.blocks()) {
    const Eigen::Index rows = dimension(*block.residual);
    for (Eigen::Index k = block.first; k < block.first + block.count; ++k, row += rows) {
      const double points = std::max<double>(1.0, static_cast<double>(rows) / 3.0);
      result.push_back(
          {block.residual, k,
           whitened.segment(row, rows).norm() / std::sqrt(points) * block.residual->u_mm(k)});
    }
  }
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
    ratios.push_back(normalised_square(each) / chi_squared_quantile(0.5, freedom));
  }
  const double scale = median(ratios);
  if (!(scale > 0.0)) return flagged;
  const double level = 1.0 - 0.01 / static_cast<double>(residuals.size());
  for (const ObservationResidual& each : residuals) {
    const auto freedom = static_cast<double>(dimension(*each.residual));
    const double square = normalised_square(each) / scale;
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
