// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/zero_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/small_least_squares.h"
#include "armcal/symmetric_point/radius_wave.h"

namespace armcal {
namespace {

constexpr std::size_t kLeastForShape = 3;
constexpr std::size_t kLeastForWave = 6;
constexpr double kLeastSpanForWave_rad = radians_from_degrees(120.0);

// Weights of the squared radii: u(r^2) = 2 r u(r).
double weight(const RadiusAtSetting& at) { return 1.0 / (2.0 * at.radius_mm * at.u_mm); }

void finish(ZeroSearchResult& result, const std::vector<RadiusAtSetting>& radii,
            const std::function<double(double)>& fitted_squared_radius, int unknowns) {
  for (const RadiusAtSetting& at : radii) {
    const double fitted = std::sqrt(std::max(0.0, fitted_squared_radius(at.setting_rad)));
    result.residuals_mm.push_back(at.radius_mm - fitted);
    const double whitened = result.residuals_mm.back() / at.u_mm;
    result.chi_squared += whitened * whitened;
  }
  result.degrees_of_freedom = static_cast<int>(radii.size()) - unknowns;
  // Radii that scatter more than their uncertainties say (Birge): believe the scatter.
  if (result.degrees_of_freedom > 0) {
    const double ratio = result.chi_squared / result.degrees_of_freedom;
    result.u_rad *= std::sqrt(std::max(1.0, ratio));
  }
  // An extremum known no better than this could be any other one.
  constexpr double kUseless_rad = radians_from_degrees(20.0);
  const bool useful = result.u_rad < kUseless_rad;
  result.status = useful ? ZeroStatus::converged : ZeroStatus::not_determined;
}

void fit_full_wave(ZeroSearchResult& result, const std::vector<RadiusAtSetting>& radii,
                   double guess) {
  const auto count = static_cast<Eigen::Index>(radii.size());
  Eigen::MatrixXd design(count, 5);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RadiusAtSetting& at = radii[static_cast<std::size_t>(i)];
    design.row(i) = weight(at) * wave_basis(at.setting_rad).transpose();
    right(i) = weight(at) * at.radius_mm * at.radius_mm;
  }
  const RadiusWave wave = shortest_solution(design, right);
  const auto factor = inverse_factor(design);
  const auto extremum = extremum_near(wave, guess);
  if (!factor || !extremum) {
    result.status = factor ? ZeroStatus::no_extremum : ZeroStatus::not_determined;
    return;
  }
  result.setting_rad = *extremum;
  const double bend = wave.dot(wave_bend(result.setting_rad));
  result.is_minimum = bend > 0.0;
  result.u_rad = (factor->transpose() * wave_slope(result.setting_rad)).norm() / std::abs(bend);
  finish(
      result, radii, [&](double e) { return wave.dot(wave_basis(e)); }, 5);
}

void fit_nominal_shape(ZeroSearchResult& result, const std::vector<RadiusAtSetting>& radii,
                       const std::function<double(double)>& nominal_squared_radius, double guess) {
  const RadiusWave shape = wave_of(nominal_squared_radius);
  const auto nominal_setting = extremum_near(shape, guess);
  if (!nominal_setting) {
    result.status = ZeroStatus::no_extremum;
    return;
  }
  // Unknowns: height and scale of the wave, and its shift along the settings.
  SmallProblem problem;
  for (const RadiusAtSetting& at : radii) {
    const double rounding =
        16.0 * std::numeric_limits<double>::epsilon() * at.radius_mm * at.radius_mm * weight(at);
    problem.residual_resolution = std::max(problem.residual_resolution, rounding);
  }
  problem.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
    const auto count = static_cast<Eigen::Index>(radii.size());
    r.resize(count);
    J.resize(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const RadiusAtSetting& at = radii[static_cast<std::size_t>(i)];
      const double e = at.setting_rad - x(2);
      const double value = shape.tail<4>().dot(wave_basis(e).tail<4>());
      r(i) = weight(at) * (x(0) + x(1) * value - at.radius_mm * at.radius_mm);
      J.row(i) << weight(at), weight(at) * value, -weight(at) * x(1) * shape.dot(wave_slope(e));
    }
  };
  const SmallSolution solution =
      solve_small_least_squares(problem, Eigen::Vector3d(shape(0), 1.0, 0.0));
  const auto factor = inverse_factor(solution.jacobian);
  if (!solution.ok() || !factor) {
    result.status = ZeroStatus::not_determined;
    return;
  }
  result.setting_rad = *nominal_setting + solution.x(2);
  result.is_minimum = solution.x(1) * shape.dot(wave_bend(*nominal_setting)) > 0.0;
  result.u_rad = factor->row(2).norm();
  finish(
      result, radii,
      [&](double e) {
        return solution.x(0) +
               solution.x(1) * shape.tail<4>().dot(wave_basis(e - solution.x(2)).tail<4>());
      },
      3);
}

}  // namespace

std::string_view explain(ZeroStatus status) {
  switch (status) {
    case ZeroStatus::converged:
      return "converged";
    case ZeroStatus::too_few_settings:
      return "a zero search needs at least three settings";
    case ZeroStatus::no_extremum:
      return "the radius has no extremum near the settings";
    case ZeroStatus::not_determined:
      return "the radii do not determine where the radius is extremal";
  }
  return "unknown";
}

ZeroSearchResult search_zero(const std::vector<RadiusAtSetting>& radii,
                             const std::function<double(double)>& nominal_squared_radius,
                             double guess_rad) {
  ZeroSearchResult result;
  if (radii.size() < kLeastForShape) return result;
  const auto [lowest, highest] = std::minmax_element(
      radii.begin(), radii.end(),
      [](const auto& one, const auto& other) { return one.setting_rad < other.setting_rad; });
  const bool wide = highest->setting_rad - lowest->setting_rad >= kLeastSpanForWave_rad;
  if (wide && radii.size() >= kLeastForWave) {
    result.law = ZeroLaw::full_wave;
    fit_full_wave(result, radii, guess_rad);
  } else {
    result.law = ZeroLaw::nominal_shape;
    fit_nominal_shape(result, radii, nominal_squared_radius, guess_rad);
  }
  return result;
}

}  // namespace armcal
