// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string_view>
#include <vector>

namespace armcal {

/// Radius of the circle of a lower joint at one setting of the searched joint.
struct RadiusAtSetting {
  double setting_rad = 0.0;
  double radius_mm = 0.0;
  double u_mm = 0.0;  ///< standard uncertainty, > 0
};

enum class ZeroLaw {
  full_wave,      ///< c0 + c1 cos e + s1 sin e + c2 cos 2e + s2 sin 2e: exact for any arm
  nominal_shape,  ///< the wave of the nominal arm, shifted, scaled and raised
};

enum class ZeroStatus { converged, too_few_settings, no_extremum, not_determined };
[[nodiscard]] std::string_view explain(ZeroStatus status);

struct ZeroSearchResult {
  ZeroStatus status = ZeroStatus::too_few_settings;
  ZeroLaw law = ZeroLaw::full_wave;
  double setting_rad = 0.0;  ///< where the radius is extremal
  double u_rad = 0.0;  ///< standard uncertainty; widened where the radii scatter more than stated
  bool is_minimum = true;
  int degrees_of_freedom = 0;
  double chi_squared = 0.0;
  std::vector<double> residuals_mm;  ///< radius minus fitted radius

  [[nodiscard]] bool ok() const { return status == ZeroStatus::converged; }
};

/// The zero search: from the radii of circles at several settings of a joint, the setting at which
/// the radius is extremal - by fitting the law that the squared radius obeys, not by picking the
/// smallest arc, and so with an uncertainty. theory/symmetric_point.md eq. (20)-(22). The full wave
/// is fitted where there are at least six settings over 120 deg or more; else the nominal shape,
/// from three settings on.
/// @param nominal_squared_radius  squared radius (mm^2) on the nominal arm as function of the
/// setting (rad)
/// @param guess_rad  the extremum nearest to this is meant
[[nodiscard]] ZeroSearchResult search_zero(
    const std::vector<RadiusAtSetting>& radii,
    const std::function<double(double)>& nominal_squared_radius, double guess_rad);

}  // namespace armcal
