// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/reduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "armcal/core/invariant.h"
#include "armcal/core/units.h"
#include "armcal/symmetric_point/far_points.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

// Rows whose setting differs by less than this belong to one arc: the joint was locked, the encoder
// flickered.
constexpr double kSameSetting_rad = radians_from_degrees(0.05);

std::vector<std::size_t> rows_of_end(const RawSymmetricPoints& raw, char end) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < raw.points_mm.size(); ++i) {
    if (raw.end[i] == end) rows.push_back(i);
  }
  return rows;
}

Eigen::Vector3d mean_point(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::size_t row : rows) sum += raw.points_mm[row];
  return sum / static_cast<double>(rows.size());
}

Eigen::VectorXd mean_encoder(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(raw.encoder_rad.rows());
  for (const std::size_t row : rows) sum += raw.encoder_rad.col(static_cast<Eigen::Index>(row));
  return sum / static_cast<double>(rows.size());
}

EndStatistics statistics_of(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows,
                            const Eigen::Vector3d& along) {
  EndStatistics end;
  end.count = static_cast<int>(rows.size());
  end.mean_mm = mean_point(raw, rows);
  double sum = 0.0;
  for (const std::size_t row : rows) {
    const double deviation = along.dot(raw.points_mm[row] - end.mean_mm);
    sum += deviation * deviation;
  }
  if (end.count > 1) end.s_mm = std::sqrt(sum / (end.count - 1));
  return end;
}

std::vector<Eigen::Vector3d> points_of(const RawSymmetricPoints& raw,
                                       const std::vector<std::size_t>& rows) {
  std::vector<Eigen::Vector3d> points;
  for (const std::size_t row : rows) points.push_back(raw.points_mm[row]);
  return points;
}

SourcePosition place_of(const RawSymmetricPoints& raw, std::size_t row) {
  return {raw.file, row < raw.lines.size() ? raw.lines[row] : 0, 0};
}

constexpr const char* kMendBlunder = "measure it again, or delete the row if it is a blunder";

void warn_of_far_repeats(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows_a,
                         const std::vector<std::size_t>& rows_b, Diagnostics& diagnostics) {
  for (const FarPoint& far : far_repeats(points_of(raw, rows_a), points_of(raw, rows_b))) {
    const bool in_a = far.index < rows_a.size();
    const auto& rows = in_a ? rows_a : rows_b;
    const std::size_t row = rows[far.index - (in_a ? 0 : rows_a.size())];
    diagnostics.warning(
        place_of(raw, row),
        fmt::format("lies {:.3f} mm off the middle of the {} repeats of end {}; others lie {:.3f} "
                    "mm off{}",
                    far.distance_mm, rows.size(), in_a ? 'A' : 'B', far.usual_mm,
                    rows.size() == 2 ? ": one of the two is wrong" : ""),
        kMendBlunder);
  }
}

void warn_of_far_arc_points(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows,
                            Diagnostics& diagnostics) {
  for (const FarPoint& far : far_points_of_arc(points_of(raw, rows))) {
    diagnostics.warning(place_of(raw, rows[far.index]),
                        fmt::format("lies {:.3f} mm off the circle of the other points of its arc, "
                                    "which agree to {:.3f} mm",
                                    far.distance_mm, far.usual_mm),
                        kMendBlunder);
  }
}

// The encoders tell when more than the one joint moved. The model takes the recorded angles, so
// this is no error.
void warn_of_slip(const SymmetricReading& reading, const Eigen::VectorXd& slip_rad,
                  Diagnostics& diagnostics) {
  constexpr double kNoticeable_rad = radians_from_degrees(0.1);
  Eigen::Index joint = 0;
  const double largest = slip_rad.cwiseAbs().maxCoeff(&joint);
  if (largest <= kNoticeable_rad) return;
  diagnostics.warning(
      {reading.raw->file, 0, 0},
      fmt::format(
          "joint {} moved by {:.3f} deg between the ends of reading \"{}\": its distance is "
          "not of a half turn of joint {} alone",
          joint + 1, degrees_from_radians(slip_rad(joint)), reading.name, reading.joint),
      "the recorded angles are used, so the adjustment holds; lock the other joints for the "
      "paper's "
      "equations to hold as well");
}

double combined(double u_type_a, double u_type_b) { return std::hypot(u_type_a, u_type_b); }

bool has_uncertainty(const SymmetricReading& reading, Diagnostics& diagnostics) {
  if (reading.u > 0.0) return true;
  diagnostics.error(
      reading.where,
      fmt::format("reading \"{}\" has no uncertainty: its points show no scatter", reading.name),
      "give u_mm, or take at least two points at each end (four on an arc)");
  return false;
}

// Distance between the means of two ends with the uncertainty that the repeats show.
struct EndDistance {
  double distance_mm = 0.0;
  double u_type_a_mm = 0.0;
  EndStatistics a, b;
};

EndDistance end_distance(const RawSymmetricPoints& raw, const std::vector<std::size_t>& rows_a,
                         const std::vector<std::size_t>& rows_b) {
  const Eigen::Vector3d step = mean_point(raw, rows_b) - mean_point(raw, rows_a);
  EndDistance result;
  result.distance_mm = step.norm();
  const Eigen::Vector3d along = result.distance_mm > 0.0
                                    ? Eigen::Vector3d(step / result.distance_mm)
                                    : Eigen::Vector3d::UnitX();
  result.a = statistics_of(raw, rows_a, along);
  result.b = statistics_of(raw, rows_b, along);
  // Both ends are taken by the same machine: one spread for both, from all repeats together. theory
  // eq. (23)
  const int freedom = result.a.count + result.b.count - 2;
  if (freedom > 0) {
    const double pooled = ((result.a.count - 1) * result.a.s_mm * result.a.s_mm +
                           (result.b.count - 1) * result.b.s_mm * result.b.s_mm) /
                          freedom;
    result.u_type_a_mm = std::sqrt(pooled / result.a.count + pooled / result.b.count);
  }
  return result;
}

bool reduce_reversal(SymmetricReading& reading, Reduction& reduction, Diagnostics& diagnostics) {
  const RawSymmetricPoints& raw = *reading.raw;
  const auto rows_a = rows_of_end(raw, 'A');
  const auto rows_b = rows_of_end(raw, 'B');
  if (rows_a.empty() || rows_b.empty()) {
    diagnostics.error({raw.file, 0, 0},
                      fmt::format("no point at end {}", rows_a.empty() ? 'A' : 'B'),
                      "a reversal needs points before (A) and after (B) the half turn");
    return false;
  }
  warn_of_far_repeats(raw, rows_a, rows_b, diagnostics);
  const EndDistance ends = end_distance(raw, rows_a, rows_b);
  reading.value = ends.distance_mm;
  reduction.end_a = ends.a;
  reduction.end_b = ends.b;
  reduction.u_type_a = ends.u_type_a_mm;
  reading.u = combined(reduction.u_type_a, reading.u);
  if (raw.encoder_rad.cols() > 0) {
    reading.posture_rad = mean_encoder(raw, rows_a);
    reading.posture_end_rad = mean_encoder(raw, rows_b);
    Eigen::VectorXd difference = reading.posture_end_rad - reading.posture_rad;
    reduction.half_turn_rad = difference(reading.joint - 1);
    difference(reading.joint - 1) = 0.0;
    reduction.largest_slip_rad = difference.lpNorm<Eigen::Infinity>();
    warn_of_slip(reading, difference, diagnostics);
  } else {
    reduction.half_turn_rad = std::numbers::pi;
  }
  return has_uncertainty(reading, diagnostics);
}

bool reduce_arc(SymmetricReading& reading, Reduction& reduction, Diagnostics& diagnostics) {
  const RawSymmetricPoints& raw = *reading.raw;
  const CircleFit fit = fit_circle(raw.points_mm);
  if (!fit.ok()) {
    diagnostics.error({raw.file, 0, 0}, fmt::format("circle of reading \"{}\": {}", reading.name,
                                                    explain(fit.status)));
    return false;
  }
  std::vector<std::size_t> rows(raw.points_mm.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  warn_of_far_arc_points(raw, rows, diagnostics);
  reading.value = fit.radius_mm;
  reduction.u_type_a = fit.standard_uncertainty("radius").value_or(0.0);
  reading.u = combined(reduction.u_type_a, reading.u);
  reduction.arc = fit;
  if (raw.encoder_rad.cols() > 0) {
    reading.posture_rad = raw.encoder_rad.rowwise().mean();
    reading.posture_end_rad = reading.posture_rad;
  }
  return has_uncertainty(reading, diagnostics);
}

// Rows of one setting of the searched joint, in file order.
std::vector<std::vector<std::size_t>> rows_by_setting(const RawSymmetricPoints& raw) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < raw.points_mm.size(); ++i) {
    const bool same =
        !groups.empty() &&
        std::abs(raw.setting_rad[i] - raw.setting_rad[groups.back().front()]) < kSameSetting_rad;
    if (!same) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

// Radius at one setting, from an arc or, where ends are given, from a half turn of the swept joint.
std::optional<RadiusAtSetting> radius_at_setting(const SymmetricReading& reading,
                                                 const std::vector<std::size_t>& rows,
                                                 Diagnostics& diagnostics) {
  const RawSymmetricPoints& raw = *reading.raw;
  RadiusAtSetting at;
  for (const std::size_t row : rows)
    at.setting_rad += raw.setting_rad[row] / static_cast<double>(rows.size());
  const SourcePosition where = place_of(raw, rows.front());
  if (!raw.end.empty()) {
    std::vector<std::size_t> ends[2];
    for (const std::size_t row : rows) ends[raw.end[row] == 'A' ? 0 : 1].push_back(row);
    if (ends[0].empty() || ends[1].empty()) {
      diagnostics.error(where, fmt::format("setting {:.3f} deg has points at one end only",
                                           degrees_from_radians(at.setting_rad)));
      return std::nullopt;
    }
    warn_of_far_repeats(raw, ends[0], ends[1], diagnostics);
    const EndDistance distance = end_distance(raw, ends[0], ends[1]);
    at.radius_mm = distance.distance_mm / 2.0;
    at.u_mm = distance.u_type_a_mm / 2.0;
    return at;
  }
  const CircleFit fit = fit_circle(points_of(raw, rows));
  if (!fit.ok()) {
    diagnostics.error(
        where, fmt::format("arc at setting {:.3f} deg: {}", degrees_from_radians(at.setting_rad),
                           explain(fit.status)));
    return std::nullopt;
  }
  warn_of_far_arc_points(raw, rows, diagnostics);
  at.radius_mm = fit.radius_mm;
  at.u_mm = fit.standard_uncertainty("radius").value_or(0.0);
  return at;
}

// Arcs of few points scatter by chance far less or far more than the machine does: all settings
// share one relative spread, the root mean square. `u_point_mm` is the file's u_mm, of what repeats
// cannot show.
void share_uncertainty(std::vector<RadiusAtSetting>& radii, double u_file_mm) {
  double sum = 0.0;
  for (const RadiusAtSetting& at : radii) sum += at.u_mm * at.u_mm;
  const double shared = std::sqrt(sum / static_cast<double>(radii.size()));
  for (RadiusAtSetting& at : radii) at.u_mm = combined(std::max(at.u_mm, shared), u_file_mm);
}

bool reduce_zero_search(SymmetricReading& reading, Reduction& reduction, const ArmModel& nominal,
                        double u_file_mm, Diagnostics& diagnostics) {
  const RawSymmetricPoints& raw = *reading.raw;
  for (const auto& rows : rows_by_setting(raw)) {
    const auto at = radius_at_setting(reading, rows, diagnostics);
    if (!at) return false;
    reduction.radii.push_back(*at);
  }
  const double guess = reading.posture_rad(reading.joint - 1);
  if (raw.encoder_rad.cols() > 0) {
    reading.posture_rad = raw.encoder_rad.rowwise().mean();
    reading.posture_rad(reading.joint - 1) = guess;
    reading.posture_end_rad = reading.posture_rad;
  }
  if (reduction.radii.empty()) {
    diagnostics.error({raw.file, 0, 0}, "no points");
    return false;
  }
  share_uncertainty(reduction.radii, u_file_mm);
  if (!(reduction.radii.front().u_mm > 0.0)) {
    reading.u = 0.0;
    return has_uncertainty(reading, diagnostics);
  }
  const auto nominal_squared_radius = [&](double setting) {
    SymmetricReading at;
    at.kind = SymmetricKind::circle_radius;
    at.joint = reading.sweep;
    at.posture_rad = reading.posture_rad;
    at.posture_rad(reading.joint - 1) = setting;
    const double radius = predict(nominal, at).value;
    return std::isfinite(radius) ? radius * radius : 0.0;
  };
  reduction.zero = search_zero(reduction.radii, nominal_squared_radius, guess);
  if (!reduction.zero->ok()) {
    diagnostics.error({raw.file, 0, 0}, fmt::format("zero search \"{}\": {}", reading.name,
                                                    explain(reduction.zero->status)));
    return false;
  }
  reading.value = reduction.zero->setting_rad;
  reading.u = reduction.zero->u_rad;
  reduction.u_type_a = reading.u;
  return true;
}

}  // namespace

std::optional<ReducedReading> reduce(const SymmetricReading& reading, const ArmModel& nominal,
                                     Diagnostics& diagnostics) {
  ReducedReading result{reading, {}};
  result.reduction.reading = reading.name;
  if (reading.reduced) return result;
  ARMCAL_INVARIANT(reading.raw.has_value());
  bool done = false;
  switch (reading.kind) {
    case SymmetricKind::reversal:
      done = reduce_reversal(result.reading, result.reduction, diagnostics);
      break;
    case SymmetricKind::circle_radius:
      done = reduce_arc(result.reading, result.reduction, diagnostics);
      break;
    case SymmetricKind::zero_search:
      done = reduce_zero_search(result.reading, result.reduction, nominal, reading.u, diagnostics);
      break;
  }
  if (!done) return std::nullopt;
  result.reading.reduced = true;
  return result;
}

}  // namespace armcal
