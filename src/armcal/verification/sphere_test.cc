// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/sphere_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// An error of which less than a tenth shows would pass unseen beside the noise of any arm.
constexpr double kShownEnough = 0.1;

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

void check(const SphereTestOptions& options) {
  if (!is_positive(options.certified_diameter_mm)) {
    throw std::invalid_argument(fmt::format("certified diameter {} mm: must be larger than 0",
                                            options.certified_diameter_mm));
  }
  if (options.tip_diameter_mm != 0.0 && !is_positive(options.tip_diameter_mm)) {
    throw std::invalid_argument(
        fmt::format("tip diameter {} mm: must not be negative", options.tip_diameter_mm));
  }
  for (const auto& limit : {options.largest_diameter_error_mm, options.largest_form_error_mm}) {
    if (limit && !is_positive(*limit)) {
      throw std::invalid_argument(fmt::format("limit {} mm: must be larger than 0", *limit));
    }
  }
}

Verdict judge(const std::optional<double>& error, const std::optional<double>& limit) {
  if (!limit || !error) return Verdict::not_judged;
  return std::abs(*error) <= *limit ? Verdict::pass : Verdict::fail;
}

Eigen::Matrix3Xd directions_from(const Eigen::Vector3d& center_mm,
                                 std::span<const Eigen::Vector3d> points_mm) {
  Eigen::Matrix3Xd directions(3, static_cast<Eigen::Index>(points_mm.size()));
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    directions.col(i) = (points_mm[static_cast<std::size_t>(i)] - center_mm).normalized();
  }
  return directions;
}

SphereTest test_points(std::span<const Eigen::Vector3d> points, const SphereTestOptions& options) {
  check(options);
  SphereTest test;
  test.fit = fit_sphere(points);
  if (!test.ok()) return test;
  test.outward = directions_from(test.fit.center_mm, points);
  test.uncompensated_diameter_mm = 2.0 * test.fit.radius_mm;
  test.diameter_mm = test.uncompensated_diameter_mm - options.tip_diameter_mm;
  test.diameter_error_mm = test.diameter_mm - options.certified_diameter_mm;
  test.uncompensated_error_mm = test.uncompensated_diameter_mm - options.certified_diameter_mm;
  test.relative_error = test.diameter_error_mm / options.certified_diameter_mm;
  if (test.diameter_mm <= 0.0) {
    throw std::invalid_argument(
        fmt::format("tip diameter {} mm: leaves nothing of the fitted sphere of {:.4f} mm",
                    options.tip_diameter_mm, test.uncompensated_diameter_mm));
  }
  if (test.fit.count >= kLeastPointsForForm) test.form_error_mm = test.fit.form_mm;
  if (const auto u_radius = test.fit.standard_uncertainty("radius")) {
    test.u_diameter_mm = 2.0 * *u_radius;
  }
  test.diameter_verdict = judge(test.diameter_error_mm, options.largest_diameter_error_mm);
  test.form_verdict = judge(test.form_error_mm, options.largest_form_error_mm);
  return test;
}

// How the radial residuals after the fit, and the fitted radius, answer to an error of each
// parameter.
std::vector<BlindSpot> blind_spots_of(const ArmModel& arm, const JointReadings& readings,
                                      const SphereFit& fit) {
  const ForwardKinematics kinematics(arm);
  const ParameterTable table(arm);
  const Eigen::Index count = readings.count();
  Eigen::MatrixXd radial(count, table.size());  // change of each tip's distance from the centre
  Eigen::MatrixXd sphere(count, 4);  // the same for a shift of the sphere and a change of radius
  TipLinearisation at;
  for (Eigen::Index i = 0; i < count; ++i) {
    kinematics.linearise(readings.posture(i), at);
    const Eigen::Vector3d outward = (at.tip_mm - fit.center_mm).normalized();
    radial.row(i) = outward.transpose() * at.J_tip_parameters;
    sphere.row(i) << outward.transpose(), 1.0;
  }
  const auto factor = inverse_factor(sphere);
  if (!factor) return {};
  const Eigen::MatrixXd answer = *factor * (factor->transpose() * (sphere.transpose() * radial));
  const Eigen::MatrixXd left_over = radial - sphere * answer;

  std::vector<BlindSpot> spots;
  for (int p = 0; p < table.size(); ++p) {
    // Conventions of the base frame and of the last axis move no measured length; beta stands in
    // for d.
    const bool convention = table[p].name == "zero1" || table[p].name == "d2" ||
                            table[p].kind == ParameterKind::beta || table[p].harmonic > 0;
    if (convention) continue;
    const bool is_length = table[p].unit == ParameterUnit::mm;
    const double unit = is_length ? 1.0 : 1.0 / reach_mm(arm);
    const double form = unit * (left_over.col(p).maxCoeff() - left_over.col(p).minCoeff());
    const double diameter = unit * 2.0 * std::abs(answer(3, p));
    const double shown = std::max(form, diameter);
    if (shown < kShownEnough) spots.push_back({table[p].name, is_length, shown});
  }
  std::stable_sort(spots.begin(), spots.end(), [](const BlindSpot& one, const BlindSpot& other) {
    if (one.is_length != other.is_length) return one.is_length;
    return one.shown < other.shown;
  });
  return spots;
}

}  // namespace

Verdict SphereTest::verdict() const {
  if (diameter_verdict == Verdict::fail || form_verdict == Verdict::fail) return Verdict::fail;
  const bool judged = diameter_verdict == Verdict::pass || form_verdict == Verdict::pass;
  return judged ? Verdict::pass : Verdict::not_judged;
}

SphereTest test_sphere(const PointReadings& readings, const SphereTestOptions& options) {
  return test_points(readings.points_mm, options);
}

SphereTest test_sphere(const ArmModel& arm, const JointReadings& readings,
                       const SphereTestOptions& options) {
  const ForwardKinematics kinematics(arm);
  std::vector<Eigen::Vector3d> tips;
  for (Eigen::Index i = 0; i < readings.count(); ++i) {
    tips.push_back(kinematics.tip_in_base(readings.posture(i)));
  }
  SphereTest test = test_points(tips, options);
  if (!test.ok()) return test;
  test.joint_spans_rad =
      readings.encoder_rad.rowwise().maxCoeff() - readings.encoder_rad.rowwise().minCoeff();
  test.blind_spots = blind_spots_of(arm, readings, test.fit);
  return test;
}

}  // namespace armcal
