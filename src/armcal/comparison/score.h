// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "armcal/comparison/method.h"
#include "armcal/simulation/virtual_arm.h"

namespace armcal {

/// How near a found arm is to the true one, on postures that no method has seen.
struct Score {
  // Points: exact encoder readings, after the best rigid registration of both arms.
  double point_rms_mm = 0.0;
  double point_mean_mm = 0.0;
  double point_max_mm = 0.0;
  /// Root mean square of (distance of two tips on the found arm - true distance).
  double length_rms_mm = 0.0;
  /// With the noise of encoders and reference put on: rms of the found arm over that of the true
  /// arm. 1 where nothing better can be found.
  double noise_ratio = 0.0;
  int intervals = 0;  ///< parameters whose 95 % interval was judged
  int inside = 0;     ///< of these: hold the true value
};

/// The judge of a bench: knows the true arm, and asks every method the same questions.
///
/// Points are compared after a registration because the frame of the base is a convention: turning
/// or shifting all tips together changes nothing that an arm measures, and methods without a common
/// frame could not be compared otherwise. Lengths need none.
///
/// Parameters are compared with the true arm written in the method's own convention: what it held,
/// at the values that it held, everything else fitted without noise to the tips of the true arm.
/// Where that cannot reproduce the true arm (too few parameters), it is the nearest such arm.
class Judge {
 public:
  Judge(const VirtualArm& arm, double u_reference_mm, std::uint64_t seed, int postures = 500);

  [[nodiscard]] Score score(const FoundArm& found) const;
  /// Rms of a point of the true arm by the noise of encoders and reference alone.
  [[nodiscard]] double noise_floor_mm() const { return noise_floor_mm_; }

 private:
  void judge_points(const FoundArm& found, Score& score) const;
  void judge_intervals(const FoundArm& found, Score& score) const;

  Eigen::MatrixXd encoder_rad_;  // exact
  Eigen::MatrixXd shown_rad_;    // with noise
  std::vector<Eigen::Vector3d> true_mm_;
  std::vector<Eigen::Vector3d> reference_mm_;  // with noise
  std::vector<int> partner_;                   // the other end of each length
  double noise_floor_mm_ = 0.0;
};

}  // namespace armcal
