// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "armcal/report/chart/chart.h"

namespace armcal {

/// Where the encoder of a joint was read.
struct JointStrip {
  std::string name;
  // Mechanical range; infinite where there is no stop.
  double low_deg = -std::numeric_limits<double>::infinity();
  double high_deg = std::numeric_limits<double>::infinity();
  std::vector<double> fit_deg, check_deg;
};

struct CoverageStrips {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;
  std::string axis;        ///< "encoder, deg"
  std::string fit, check;  ///< words of the legend
  std::string span;        ///< above the widths that are covered
  std::vector<JointStrip> joints;
};

/// A strip for each joint, on one axis: its range framed, darker where more readings of the fit
/// are, check readings as strokes below it; at the right how wide a range the fit covers.
[[nodiscard]] Figure figure_of(const CoverageStrips& strips);

/// What was reached, seen from above and from the side.
struct ReachedPoints {
  std::string id;  ///< of the charts: with -top and -side behind it
  std::string top_title, side_title;
  std::string text;
  std::string nothing;
  std::string x, y, z;     ///< labels of axes, with unit
  std::string fit, check;  ///< names of the series
  Eigen::Matrix3Xd fit_mm, check_mm;
};

/// x and y, and x and z, a millimetre as long either way.
[[nodiscard]] std::vector<Chart> views_of(const ReachedPoints& points);

}  // namespace armcal
