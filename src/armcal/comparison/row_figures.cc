// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/row_figures.h"

#include <algorithm>
#include <cmath>

#include "armcal/core/diagnostics.h"

namespace armcal {
namespace {

template <class T>
void keep(std::vector<T>& values, const std::vector<int>& rows) {
  if (values.empty()) return;
  std::vector<T> kept;
  for (const int row : rows) kept.push_back(values[static_cast<std::size_t>(row)]);
  values = std::move(kept);
}

template <class Matrix>
void keep_columns(Matrix& matrix, const std::vector<int>& rows) {
  if (matrix.cols() > 0) matrix = Matrix(matrix(Eigen::all, rows));
}

ObservationGroup with_rows(ObservationGroup group, const std::vector<int>& rows) {
  keep(group.lines, rows);
  keep(group.is_check, rows);
  keep(group.orientation, rows);
  keep(group.place, rows);
  keep(group.place_to, rows);
  keep(group.feature, rows);
  keep(group.joint, rows);
  group.u_mm = Eigen::VectorXd(group.u_mm(rows));
  for (Eigen::VectorXd* values : {&group.value_mm, &group.time_s, &group.temperature_c}) {
    if (values->size() > 0) *values = Eigen::VectorXd((*values)(rows));
  }
  keep_columns(group.encoder_rad, rows);
  keep_columns(group.encoder_end_rad, rows);
  keep_columns(group.reference_mm, rows);
  return group;
}

// These rows as readings that place, and lengths as readings that are held out of it.
std::vector<ObservationGroup> judging_rows(std::span<const ObservationGroup> groups,
                                           bool held_out) {
  std::vector<ObservationGroup> judging;
  for (const ObservationGroup& group : groups) {
    std::vector<int> rows;
    for (int row = 0; row < group.count(); ++row) {
      if (group.is_check[static_cast<std::size_t>(row)] == held_out) rows.push_back(row);
    }
    if (rows.empty()) continue;
    judging.push_back(with_rows(group, rows));
    judging.back().is_check.assign(rows.size(), group.kind == ReferenceKind::length);
  }
  return judging;
}

ResidualStatistics together(const std::vector<ResidualStatistics>& parts) {
  ResidualStatistics all;
  double squares = 0.0;
  for (const ResidualStatistics& part : parts) {
    const auto count = static_cast<double>(part.count);
    all.count += part.count;
    squares += count * part.rms_mm * part.rms_mm;
    all.mean_mm += count * part.mean_mm;
    all.max_mm = std::max(all.max_mm, part.max_mm);
  }
  if (all.count == 0) return all;
  all.rms_mm = std::sqrt(squares / static_cast<double>(all.count));
  all.mean_mm /= static_cast<double>(all.count);
  return all;
}

}  // namespace

RowFigures row_figures(const ArmModel& arm, std::span<const ObservationGroup> groups,
                       bool held_out) {
  const std::vector<ObservationGroup> judging = judging_rows(groups, held_out);
  CalibrationOptions only_places;
  only_places.hold = {"*"};
  const Calibration placed = calibrate(arm, judging, only_places);
  // Half turns and circles bring nothing along: their residuals are those of the start.
  const bool no_places = placed.status == CalibrationStatus::nothing_determined;
  if (!placed.ok() && !no_places) {
    throw NumericalError("the rows cannot be placed: " + (placed.detail.empty()
                                                              ? std::string(explain(placed.status))
                                                              : placed.detail));
  }
  std::vector<ResidualStatistics> parts;
  for (const GroupResult& group : placed.groups) {
    const bool is_length = group.kind == ReferenceKind::length;
    parts.push_back(no_places ? group.nominal : is_length ? *group.check : group.fit);
  }
  RowFigures figures{together(parts), std::nullopt};
  double chi_squared = placed.chi_squared;
  int degrees_of_freedom = placed.degrees_of_freedom;
  for (const RowResidual& row : placed.residuals) {
    if (!row.is_check) continue;
    const double u_mm = judging[static_cast<std::size_t>(row.group)].u_mm(row.row);
    chi_squared += std::pow(row.residual_mm / u_mm, 2);
    ++degrees_of_freedom;
  }
  if (degrees_of_freedom > 0) figures.over_stated = std::sqrt(chi_squared / degrees_of_freedom);
  return figures;
}

}  // namespace armcal
