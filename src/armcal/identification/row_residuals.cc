// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/row_residuals.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace armcal {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

RowResidual row_of(const ObservationResidual& each, const ObservedPlaces& places,
                   std::span<const ObservationGroup> groups) {
  const Residual& residual = *each.residual;
  RowResidual row;
  row.group = static_cast<int>(&residual.group() - groups.data());
  row.row = residual.row(each.observation);
  row.is_check = residual.group().is_check[static_cast<std::size_t>(row.row)];
  row.residual_mm = each.length_mm;
  row.nominal_residual_mm = kNone;
  row.components = each.components;
  row.point_mm.setConstant(kNone);
  row.vector_mm.setConstant(kNone);
  if (places.point_mm.cols() == 0) return row;
  row.point_mm = places.point_mm.col(each.observation);
  row.vector_mm = each.first_mm;
  if (places.direction.cols() > 0)
    row.vector_mm = each.first_mm.x() * places.direction.col(each.observation);
  return row;
}

}  // namespace

std::vector<RowResidual> row_residuals(const std::vector<ObservationResidual>& residuals,
                                       const std::vector<double>& nominal_lengths_mm,
                                       const Unknowns& unknowns, const Eigen::VectorXd& x,
                                       std::span<const ObservationGroup> groups) {
  const ArmModel arm = unknowns.arm_at(x);
  const ArmAt at{arm, TipRows(arm, unknowns.columns())};
  std::vector<RowResidual> rows;
  rows.reserve(residuals.size());
  ObservedPlaces places;
  const Residual* places_of = nullptr;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (residuals[i].residual != places_of) {
      places_of = residuals[i].residual;
      places = places_of->places(at, unknowns, x);
    }
    rows.push_back(row_of(residuals[i], places, groups));
    if (!nominal_lengths_mm.empty()) rows.back().nominal_residual_mm = nominal_lengths_mm[i];
  }
  return rows;
}

void sort_rows(std::vector<RowResidual>& rows) {
  const auto before = [](const RowResidual& one, const RowResidual& other) {
    return std::tie(one.group, one.row) < std::tie(other.group, other.row);
  };
  // Mostly they are: then nothing is copied.
  if (!std::is_sorted(rows.begin(), rows.end(), before))
    std::sort(rows.begin(), rows.end(), before);
}

std::vector<double> lengths_of(const std::vector<ObservationResidual>& residuals) {
  std::vector<double> lengths;
  lengths.reserve(residuals.size());
  for (const ObservationResidual& each : residuals) lengths.push_back(each.length_mm);
  return lengths;
}

}  // namespace armcal
