// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/sphere.h"
#include "armcal/observations/readings.h"
#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/verdict.h"

namespace armcal {

struct SphereTestOptions {
  double certified_diameter_mm = 0.0;
  /// Diameter of the probe's ball. The arm reports the centre of the ball, which stays its radius
  /// away from the surface: the fitted diameter is too large by this. 0 where the points are of the
  /// surface itself.
  double tip_diameter_mm = 0.0;
  std::optional<double> largest_diameter_error_mm;  ///< limit of |diameter error|
  std::optional<double> largest_form_error_mm;
};

/// A parameter of the arm whose error these readings would not show.
struct BlindSpot {
  std::string parameter;
  bool is_length = true;
  /// How much of an error of 1 mm (angles: of 1 mm at full reach) the test would show, as change of
  /// diameter or of form, whichever is larger. mm per mm.
  double shown = 0.0;
};

/// Points on a sphere of certified diameter, as in section 3.2 of the 2016 paper.
struct SphereTest {
  SphereFit fit;             ///< of the tip centres
  Eigen::Matrix3Xd outward;  ///< from the fitted centre to each tip, of length 1; along it lies the
                             ///< point's residual
  double diameter_mm = 0.0;  ///< with the tip's diameter taken off
  double uncompensated_diameter_mm = 0.0;
  double diameter_error_mm = 0.0;  ///< measured - certified
  double relative_error = 0.0;     ///< of the diameter
  double uncompensated_error_mm = 0.0;
  /// Largest minus smallest distance from the fitted centre; nothing for 4 points, which every
  /// sphere through them fits.
  std::optional<double> form_error_mm;
  std::optional<double> u_diameter_mm;  ///< from the scatter of the points
  Verdict diameter_verdict = Verdict::not_judged;
  Verdict form_verdict = Verdict::not_judged;
  Eigen::VectorXd
      joint_spans_rad;  ///< range of each joint over the readings; empty for coordinates
  std::vector<BlindSpot> blind_spots;  ///< of the arm that was given: lengths, then
                                       ///< angles, worst first; empty for coordinates

  [[nodiscard]] bool ok() const { return fit.ok(); }
  /// fail if any limit is exceeded, pass if every given limit is kept, not_judged without limits.
  [[nodiscard]] Verdict verdict() const;
};

/// Puts the joint angles through the arm, fits a sphere to the tips and compares it with the
/// certificate. theory/sphere_test.md eq. (1)-(4). Also says which parameters of the arm the
/// readings could not show to be wrong: a still wrist makes a wrong arm look right. @throws
/// std::invalid_argument unless the diameters are positive and finite (that of the tip: not
/// negative, and smaller than the fitted one) and the limits too
[[nodiscard]] SphereTest test_sphere(const ArmModel& arm, const JointReadings& readings,
                                     const SphereTestOptions& options);

/// The same for coordinates that the arm's own software gave.
[[nodiscard]] SphereTest test_sphere(const PointReadings& readings,
                                     const SphereTestOptions& options);

}  // namespace armcal
