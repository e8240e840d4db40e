// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "armcal/core/progress.h"

namespace armcal {

/// The check of the 2016 paper (section 3.2): a sphere of this diameter, measured with the
/// calibrated arm, came out too small by this.
inline constexpr double kPaperSphere_mm = 15.8754;
inline constexpr double kPaperSphereError_mm = -0.0609;

/// Errors of the fitted diameter over many arms.
struct DiameterErrors {
  double median_mm = 0.0;       ///< of the magnitude
  double largest95_mm = 0.0;    ///< below which 95 % of the magnitudes are
  double share_as_large = 0.0;  ///< of arms whose error is at least that of the paper, either sign
  double median_form_mm = 0.0;  ///< largest minus smallest distance from the fitted centre
  /// Could this effect alone have made the paper's error? At least one arm in twenty errs as much.
  [[nodiscard]] bool explains_the_paper() const { return largest95_mm >= -kPaperSphereError_mm; }
};

/// One thing that the procedure neglects, all else being perfect.
struct NeglectedEffect {
  std::string name;
  std::string brief;  ///< what was switched on, with its size
  int arms = 0;       ///< that could be judged
  DiameterErrors one_articulation;
  DiameterErrors five_articulations;
};

struct PaperSphereOptions {
  int arms = 400;  ///< drawn for each effect
  std::uint64_t seed = 1;
  int threads = 1;  ///< never changes a digit
  Monitor monitor;
};

/// How far each neglected effect alone carries into the paper's sphere check: arms are drawn with
/// one effect of realistic size each, taken through the whole procedure without noise, and the
/// consistent chain measures a sphere with 25 points over its upper half: all of them in one
/// articulation of the arm, and five points in each of five. @throws Interrupted
[[nodiscard]] std::vector<NeglectedEffect> study_paper_sphere(const PaperSphereOptions& options);

}  // namespace armcal
