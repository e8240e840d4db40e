// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/fit_summary.h"

#include <cmath>

namespace armcal {

std::string_view to_string(FitStatus status) {
  switch (status) {
    case FitStatus::converged:
      return "converged";
    case FitStatus::too_few_points:
      return "too_few_points";
    case FitStatus::not_finite:
      return "not_finite";
    case FitStatus::points_coincide:
      return "points_coincide";
    case FitStatus::points_are_collinear:
      return "points_are_collinear";
    case FitStatus::points_are_coplanar:
      return "points_are_coplanar";
    case FitStatus::radius_unbounded:
      return "radius_unbounded";
    case FitStatus::ambiguous:
      return "ambiguous";
    case FitStatus::no_convergence:
      return "no_convergence";
  }
  return "unknown";
}

std::string_view explain(FitStatus status) {
  switch (status) {
    case FitStatus::converged:
      return "converged";
    case FitStatus::too_few_points:
      return "there are too few points";
    case FitStatus::not_finite:
      return "a coordinate is not a finite number";
    case FitStatus::points_coincide:
      return "the points coincide";
    case FitStatus::points_are_collinear:
      return "the points lie on one line";
    case FitStatus::points_are_coplanar:
      return "the points lie in one plane";
    case FitStatus::radius_unbounded:
      return "the points do not bound the radius: within their scatter it runs to infinity";
    case FitStatus::ambiguous:
      return "more than one rotation fits the points equally well";
    case FitStatus::no_convergence:
      return "the iteration did not converge";
  }
  return "unknown";
}

std::optional<double> FitSummary::standard_uncertainty(std::string_view quantity) const {
  if (!covariance) return std::nullopt;
  for (std::size_t i = 0; i < covariance_of.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    if (covariance_of[i] == quantity) return std::sqrt((*covariance)(index, index));
  }
  return std::nullopt;
}

}  // namespace armcal
