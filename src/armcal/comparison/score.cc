// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/score.h"

#include <algorithm>
#include <cmath>

#include "armcal/arm/estimability.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/geometry/registration.h"
#include "armcal/simulation/empty_group.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {
namespace {

// Measurements of the laboratory that no method uses.
constexpr int kPostures = 900001;
constexpr int kNoise = 900002;
constexpr Eigen::Index kPosturesForParameters = 150;

std::vector<Eigen::Vector3d> tips(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad) {
  const ForwardKinematics kinematics(arm);
  std::vector<Eigen::Vector3d> tips;
  for (const auto& posture : encoder_rad.colwise()) {
    tips.push_back(
        kinematics.tip_in_base({posture.data(), static_cast<std::size_t>(posture.size())}));
  }
  return tips;
}

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
  const std::vector<Eigen::Vector3d> found_mm = tips(found.arm, encoder_rad_);
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
  score.noise_ratio = rms(misses(tips(found.arm, shown_rad_), reference_mm_)) / noise_floor_mm_;
}

void Judge::judge_intervals(const FoundArm& found, Score& score) const {
  if (found.u.size() == 0) return;
  const ParameterTable table(found.arm);
  CalibrationOptions options;
  for (int i = 0; i < table.size(); ++i) {
    const bool is_free = std::find(found.free.begin(), found.free.end(), i) != found.free.end();
    if (!is_free) options.hold.push_back(table[i].name);
  }
  const Eigen::Index count = std::min(encoder_rad_.cols(), kPosturesForParameters);
  ObservationGroup group = empty_group(ReferenceKind::reference_points, "truth",
                                       static_cast<int>(count), found.arm.joint_count(), 0.0);
  group.encoder_rad = encoder_rad_.leftCols(count);
  group.place.assign(static_cast<std::size_t>(count), "truth");
  group.reference_mm.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    group.reference_mm.col(i) = true_mm_[static_cast<std::size_t>(i)];
  const Calibration truth = calibrate(found.arm, {&group, 1}, options);
  if (!truth.ok()) return;
  constexpr double k95 = 1.959963984540054;
  for (std::size_t i = 0; i < found.free.size(); ++i) {
    const int index = found.free[i];
    // What only moves the base, or what these parameters cannot tell apart, has no true value.
    if (std::find(truth.free.begin(), truth.free.end(), index) == truth.free.end()) continue;
    const double true_value = truth.parameters[static_cast<std::size_t>(index)].value;
    const double error = table[index].nominal - true_value;
    ++score.intervals;
    if (std::abs(error) <= k95 * found.u(static_cast<Eigen::Index>(i))) ++score.inside;
  }
}

}  // namespace armcal
