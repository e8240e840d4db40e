// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/score.h"

#include <algorithm>
#include <cmath>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/comparison/true_values.h"
#include "armcal/geometry/registration.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {
namespace {

// Measurements of the laboratory that no method uses.
constexpr int kPostures = 900001;
constexpr int kNoise = 900002;
constexpr Eigen::Index kPosturesForParameters = 150;

// Distances that remain after the best rigid registration.
std::vector<double> misses(const std::vector<Eigen::Vector3d>& found,
                           const std::vector<Eigen::Vector3d>& wanted) {
  const Registration registration = register_points(found, wanted);
  std::vector<double> misses;
  for (std::size_t i = 0; i < found.size(); ++i) {
    misses.push_back((wanted[i] - registration.target_from_source * found[i]).norm());
  }
  return misses;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

Judge::Judge(const VirtualArm& arm, double u_reference_mm, std::uint64_t seed, int postures)
    : encoder_rad_(arm.truth().joint_count(), postures), shown_rad_(encoder_rad_) {
  Laboratory laboratory(arm, seed);
  laboratory.begin(kPostures);
  const auto count = static_cast<std::uint64_t>(postures);
  for (int i = 0; i < postures; ++i) {
    encoder_rad_.col(i) = laboratory.free_posture();
    true_mm_.push_back(arm.tip(encoder_rad_.col(i)));
    const auto step = 1 + laboratory.random().below(count - 1);
    partner_.push_back(static_cast<int>((static_cast<std::uint64_t>(i) + step) % count));
  }
  laboratory.begin(kNoise);
  std::vector<Eigen::Vector3d> shown_tips;
  for (int i = 0; i < postures; ++i) {
    shown_rad_.col(i) = arm.shown(encoder_rad_.col(i), laboratory.random());
    shown_tips.push_back(arm.tip(shown_rad_.col(i)));
    reference_mm_.push_back(true_mm_[static_cast<std::size_t>(i)] +
                            laboratory.noise(u_reference_mm));
  }
  noise_floor_mm_ = rms(misses(shown_tips, reference_mm_));
}

Score Judge::score(const FoundArm& found) const {
  Score score;
  judge_points(found, score);
  judge_intervals(found, score);
  return score;
}

void Judge::judge_points(const FoundArm& found, Score& score) const {
  const std::vector<Eigen::Vector3d> found_mm = tips_in_base(found.arm, encoder_rad_);
  const std::vector<double> points = misses(found_mm, true_mm_);
  score.point_rms_mm = rms(points);
  score.point_max_mm = *std::max_element(points.begin(), points.end());
  for (const double miss : points) score.point_mean_mm += miss / static_cast<double>(points.size());
  std::vector<double> lengths;
  for (std::size_t i = 0; i < found_mm.size(); ++i) {
    const auto j = static_cast<std::size_t>(partner_[i]);
    lengths.push_back((found_mm[i] - found_mm[j]).norm() - (true_mm_[i] - true_mm_[j]).norm());
  }
  score.length_rms_mm = rms(lengths);
  score.noise_ratio =
      rms(misses(tips_in_base(found.arm, shown_rad_), reference_mm_)) / noise_floor_mm_;
}

void Judge::judge_intervals(const FoundArm& found, Score& score) const {
  if (found.u.size() == 0) return;
  const Eigen::Index count = std::min(encoder_rad_.cols(), kPosturesForParameters);
  const Eigen::VectorXd truth =
      true_values(found.arm, found.free, encoder_rad_.leftCols(count),
                  std::span(true_mm_).first(static_cast<std::size_t>(count)));
  const IntervalCount judged = count_intervals(found.arm, found.free, found.u, truth);
  score.intervals = judged.count;
  score.inside = judged.inside;
}

}  // namespace armcal
