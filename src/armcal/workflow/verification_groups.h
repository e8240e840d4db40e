// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "armcal/io/verification_tables.h"
#include "armcal/verification/b89_4_22/single_point_articulation.h"
#include "armcal/verification/measured_length.h"
#include "armcal/verification/probed_sphere.h"

namespace armcal {

/// Rows of one test with the tips that one arm gives for them (or the coordinates of the table):
/// what the tests of the standards are asked about. Groups come in the order in which the table
/// first names them, with the place of their first row.
struct RowsWithTips {
  const VerificationRows& rows;
  std::span<const Eigen::Vector3d> tips_mm;  ///< empty where lengths were measured
};

/// One set of points for each position.
[[nodiscard]] std::vector<SpherePoints> spheres_by_place(const RowsWithTips& tips);

/// One set of points for each repeat at each position.
[[nodiscard]] std::vector<SpherePoints> spheres_by_repeat(const RowsWithTips& tips);

/// One set of points for each articulation. An error where the sphere moved meanwhile.
[[nodiscard]] std::vector<SpherePoints> spheres_by_articulation(const RowsWithTips& tips,
                                                                Diagnostics& diagnostics);

/// One seat for each position.
[[nodiscard]] std::vector<b89_4_22::SeatPoints> seats_by_place(const RowsWithTips& tips);

struct LengthReading {
  std::vector<double> calibrated_mm;  ///< of each length of the artefact, at the test's temperature
  /// Taken off the distance of two touched points: the probe's diameter where the ends are touched
  /// from opposite sides, else 0.
  double probe_mm = 0.0;
  bool opposite_ends = false;  ///< bidirectional: centres of spheres do not measure it
};

/// Every measurement of a length: as the table gives it, or as the distance of its two ends. An end
/// is one point (a seat, a face) or at least four on a sphere, whose centre it is. Ends without the
/// other, and ends of two or three points, are errors with the line.
[[nodiscard]] std::vector<MeasuredLength> measured_lengths(const RowsWithTips& tips,
                                                           const LengthReading& reading,
                                                           Diagnostics& diagnostics);

}  // namespace armcal
