// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/decision_risk.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace armcal {
namespace {

// Beyond this many standard deviations a normal distribution holds less than 1e-22.
constexpr double kFar = 10.0;

struct Interval {
  double low;
  double high;
};

Interval with_ends(const ToleranceLimits& limits, const Interval& everything) {
  return {limits.lower.value_or(everything.low), limits.upper.value_or(everything.high)};
}

double density(double value, const MeasuringProcess& process) {
  const double z = (value - process.mean) / process.standard_deviation;
  return std::exp(-0.5 * z * z) / (process.standard_deviation * std::sqrt(2.0 * std::numbers::pi));
}

// Where the integrand changes quickly: about the mean in steps of the standard deviation, about the
// bounds of acceptance in steps of u.
std::vector<double> break_points(const MeasuringProcess& process, const Interval& everything,
                                 const Interval& tolerance, const Interval& acceptance) {
  std::vector<double> points = {everything.low, everything.high, tolerance.low, tolerance.high};
  for (int step = static_cast<int>(-kFar); step <= static_cast<int>(kFar); ++step) {
    points.push_back(process.mean + step * process.standard_deviation);
    points.push_back(acceptance.low + step * process.u);
    points.push_back(acceptance.high + step * process.u);
  }
  for (double& point : points) point = std::clamp(point, everything.low, everything.high);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void check(const MeasuringProcess& process) {
  for (const double spread : {process.standard_deviation, process.u}) {
    if (!(std::isfinite(spread) && spread > 0.0)) {
      throw std::invalid_argument(
          fmt::format("standard deviation {}: must be larger than 0", spread));
    }
  }
  if (!std::isfinite(process.mean)) {
    throw std::invalid_argument(fmt::format("mean {}: must be finite", process.mean));
  }
}

}  // namespace

DecisionRisk decision_risk(const MeasuringProcess& process, const ToleranceLimits& tolerance,
                           const ToleranceLimits& acceptance) {
  check(process);
  const double spread = kFar * process.standard_deviation;
  const Interval everything{process.mean - spread, process.mean + spread};
  const Interval conforming = with_ends(tolerance, everything);
  const auto points =
      break_points(process, everything, conforming, with_ends(acceptance, everything));
  const auto accepted_density = [&](double value) {
    return density(value, process) * conformance_probability(value, process.u, acceptance);
  };
  const auto rejected_density = [&](double value) {
    return density(value, process) * (1.0 - conformance_probability(value, process.u, acceptance));
  };
  using Rule = boost::math::quadrature::gauss<double, 20>;
  DecisionRisk risk;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double accepted = Rule::integrate(accepted_density, points[i - 1], points[i]);
    const double middle = std::midpoint(points[i - 1], points[i]);
    risk.accepted += accepted;
    if (middle < conforming.low || middle > conforming.high) {
      risk.false_acceptance += accepted;
    } else {
      risk.false_rejection += Rule::integrate(rejected_density, points[i - 1], points[i]);
    }
  }
  return risk;
}

}  // namespace armcal
