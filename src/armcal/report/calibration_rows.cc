// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/calibration_rows.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/core/utc_time.h"

namespace armcal {
namespace {

constexpr double kResidualsPer_mm = 1e9;
constexpr double kPlacesPer_mm = 1e6;
constexpr double kAnglesPer_deg = 1e10;
constexpr double kComponentsPerUnit = 1e6;
constexpr double kTimesPer_s = 1e3;

// Adding 0 turns -0 into 0.
Json rounded(double value, double steps) {
  return json_number(std::round(value * steps) / steps + 0.0);
}

template <typename Values>
Json list_of(const Values& values, double steps) {
  Json::array_t list;
  list.reserve(static_cast<std::size_t>(values.size()));
  for (const double value : values) list.push_back(rounded(value, steps));
  return list;
}

Json point_of(const Eigen::Vector3d& point, double steps) {
  return point.allFinite() ? list_of(point, steps) : Json();
}

Json angles_of(const ObservationGroup& group, Eigen::Index row) {
  if (group.encoder_rad.cols() == 0) return Json();
  return list_of(group.encoder_rad.col(row)
                     .unaryExpr([](double rad) { return degrees_from_radians(rad); })
                     .eval(),
                 kAnglesPer_deg);
}

Json time_of(const ObservationGroup& group, Eigen::Index row) {
  if (group.time_s.size() == 0 || std::isnan(group.time_s(row))) return Json();
  if (group.time_is_utc) return fractional_utc_text(group.time_s(row));
  return rounded(group.time_s(row), kTimesPer_s);
}

Json temperature_of(const ObservationGroup& group, Eigen::Index row) {
  return group.temperature_c.size() == 0 ? Json() : json_number(group.temperature_c(row));
}

// One row of the calibration beside the group that it belongs to.
struct Entry {
  const RowResidual& residual;
  const ObservationGroup& group;
  [[nodiscard]] std::size_t row() const { return static_cast<std::size_t>(residual.row); }
};

class Columns {
 public:
  Columns(const Calibration& calibration, std::span<const ObservationGroup> groups)
      : rows_(calibration.residuals), groups_(groups) {}

  template <typename Value>
  void add(const char* name, Value value) {
    Json::array_t column;
    column.reserve(rows_.size());
    for (const RowResidual& row : rows_)
      column.push_back(value(Entry{row, groups_[static_cast<std::size_t>(row.group)]}));
    json_[name] = std::move(column);
  }

  Json json() { return std::move(json_); }

 private:
  const std::vector<RowResidual>& rows_;
  std::span<const ObservationGroup> groups_;
  Json json_;
};

}  // namespace

Json json_of_rows(const Calibration& calibration, std::span<const ObservationGroup> groups) {
  Columns columns(calibration, groups);
  columns.add("group", [](const Entry& e) { return e.group.name; });
  columns.add("file", [](const Entry& e) { return e.group.file; });
  columns.add("line", [](const Entry& e) { return e.group.lines[e.row()]; });
  columns.add("check", [](const Entry& e) { return e.residual.is_check; });
  columns.add("residual_mm",
              [](const Entry& e) { return rounded(e.residual.residual_mm, kResidualsPer_mm); });
  columns.add("nominal_residual_mm", [](const Entry& e) {
    return rounded(e.residual.nominal_residual_mm, kResidualsPer_mm);
  });
  columns.add("normalised",
              [](const Entry& e) { return rounded(e.residual.normalised(), kComponentsPerUnit); });
  columns.add("u_mm", [](const Entry& e) { return e.group.u_mm(e.residual.row); });
  columns.add("time", [](const Entry& e) { return time_of(e.group, e.residual.row); });
  columns.add("temperature_c",
              [](const Entry& e) { return temperature_of(e.group, e.residual.row); });
  columns.add("q_deg", [](const Entry& e) { return angles_of(e.group, e.residual.row); });
  columns.add("tip_mm",
              [](const Entry& e) { return point_of(e.residual.point_mm, kPlacesPer_mm); });
  columns.add("residual_vector_mm",
              [](const Entry& e) { return point_of(e.residual.vector_mm, kResidualsPer_mm); });
  columns.add("components",
              [](const Entry& e) { return list_of(e.residual.components, kComponentsPerUnit); });
  return columns.json();
}

}  // namespace armcal
