// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/circle_points.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "armcal/arm/arm_from_axes.h"
#include "armcal/arm/encoder.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// Beyond these the arm is not the nominal one with errors, but another.
constexpr double kUnlike_rad = radians_from_degrees(10.0);
constexpr double kUnlikeOfReach = 0.1;

void check(const ArmModel& nominal, const ObservationGroup& arcs) {
  const auto rows = static_cast<std::size_t>(arcs.count());
  const bool is_right = arcs.kind == ReferenceKind::reference_points && arcs.joint.size() == rows &&
                        arcs.encoder_rad.rows() == nominal.joint_count();
  if (!is_right) {
    throw std::invalid_argument(fmt::format(
        "circle points are reference points of an arm of {} joints, each with the joint that "
        "turns; \"{}\" has {} encoder columns and {} joints for {} rows",
        nominal.joint_count(), arcs.name, arcs.encoder_rad.rows(), arcs.joint.size(), rows));
  }
  for (const int joint : arcs.joint) {
    if (joint >= 1 && joint <= nominal.joint_count()) continue;
    throw std::invalid_argument(
        fmt::format("an arm of {} joints has no joint {}", nominal.joint_count(), joint));
  }
  for (const std::string& place : arcs.place) {
    if (place == arcs.place.front()) continue;
    throw std::invalid_argument(fmt::format(
        "circle points are of one set-up, not of \"{}\" and \"{}\"", arcs.place.front(), place));
  }
}

// The arm with the other counting direction of some joints, as a set of bits. The scale of an
// encoder errs where it errs, whichever way it is counted.
ArmModel with_reversed(ArmModel arm, unsigned joints) {
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if ((joints >> i & 1U) == 0) continue;
    arm.joints[i].direction = -arm.joints[i].direction;
    for (Harmonic& harmonic : arm.joints[i].harmonics) {
      harmonic = {-harmonic.cos_rad, -harmonic.sin_rad};
    }
  }
  return arm;
}

// How far the numbers of an arm are from those of another: rad, and mm in units of the reach.
double distance_between(const ArmModel& arm, const ArmModel& other) {
  const ParameterTable table(other);
  const Eigen::VectorXd values = parameter_values(arm);
  const double reach = reach_mm(other);
  double distance = 0.0;
  for (int p = 0; p < table.size(); ++p) {
    const double off = std::abs(values(p) - table[p].nominal);
    distance += table[p].unit == ParameterUnit::mm ? off / reach : off;
  }
  return distance;
}

// What is too far from the nominal arm to be its error, in words. Zeros may be anywhere: some
// encoders have none.
std::optional<std::string> unlike(const ArmModel& arm, const ArmModel& nominal) {
  const ParameterTable table(nominal);
  const Eigen::VectorXd values = parameter_values(arm);
  for (int p = 0; p < table.size(); ++p) {
    const double off = std::abs(values(p) - table[p].nominal);
    const bool is_twist =
        table[p].kind == ParameterKind::alpha || table[p].kind == ParameterKind::beta;
    if (table[p].unit == ParameterUnit::mm && off > kUnlikeOfReach * reach_mm(nominal)) {
      return fmt::format("{} comes out as {:.1f} mm, nominal are {:.1f} mm", table[p].name,
                         values(p), table[p].nominal);
    }
    if (is_twist && off > kUnlike_rad) {
      return fmt::format("{} comes out as {:.2f} deg, nominal are {:.2f} deg", table[p].name,
                         degrees_from_radians(values(p)), degrees_from_radians(table[p].nominal));
    }
  }
  return std::nullopt;
}

// One analysis in the making.
class Analyser {
 public:
  Analyser(const ArmModel& nominal, const ObservationGroup& group,
           const CirclePointOptions& options)
      : nominal_(nominal), group_(group), options_(options), arcs_(nominal.joints.size()) {
    result_.arm = nominal;
  }

  CirclePointAnalysis run() {
    find_home();
    if (sort_rows() && stood_still() && fit_axes() && place_tip() && make_arm()) judge();
    return std::move(result_);
  }

 private:
  bool fail(CirclePointStatus status, std::string detail) {
    result_.status = status;
    result_.detail = std::move(detail);
    return false;
  }

  /// @param use  called with row and the place of the joint that turns
  template <class Use>
  void for_each_row(const Use& use) const {
    for (Eigen::Index row = 0; row < group_.count(); ++row) {
      const auto at = static_cast<std::size_t>(row);
      if (!group_.is_check[at]) use(row, group_.joint[at] - 1);
    }
  }

  // The mean reading of each joint while others turn.
  void find_home() {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(nominal_.joint_count());
    Eigen::VectorXd count = sum;
    for_each_row([&](Eigen::Index row, Eigen::Index turning) {
      for (Eigen::Index j = 0; j < sum.size(); ++j) {
        if (j == turning) continue;
        sum(j) += group_.encoder_rad(j, row);
        count(j) += 1.0;
      }
    });
    result_.home_rad = sum.cwiseQuotient(count.cwiseMax(1.0));
  }

  bool sort_rows() {
    for_each_row([&](Eigen::Index row, Eigen::Index turning) {
      const auto at = static_cast<std::size_t>(turning);
      const Joint& joint = nominal_.joints[at];
      const double turned = joint_angle(joint, group_.encoder_rad(turning, row)) -
                            joint_angle(joint, result_.home_rad(turning));
      arcs_[at].points_mm.emplace_back(group_.reference_mm.col(row));
      arcs_[at].turned_rad.push_back(joint.direction * turned);
      arcs_[at].u_mm += group_.u_mm(row) * group_.u_mm(row);
    });
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const std::size_t points = arcs_[i].points_mm.size();
      arcs_[i].joint = static_cast<int>(i) + 1;
      arcs_[i].u_mm = std::sqrt(arcs_[i].u_mm / static_cast<double>(points));
      if (points >= 3) continue;
      return fail(CirclePointStatus::joint_without_arc,
                  fmt::format("joint {} has {} points; a circle needs three", i + 1, points));
    }
    return true;
  }

  bool stood_still() {
    std::string detail;
    double largest = options_.locked_rad;
    for_each_row([&](Eigen::Index row, Eigen::Index turning) {
      for (Eigen::Index j = 0; j < result_.home_rad.size(); ++j) {
        const double off = std::abs(group_.encoder_rad(j, row) - result_.home_rad(j));
        if (j == turning || off <= largest) continue;
        largest = off;
        detail = fmt::format("in line {}, where joint {} turns, joint {} is {:.3f} deg from home",
                             group_.lines[static_cast<std::size_t>(row)], turning + 1, j + 1,
                             degrees_from_radians(off));
      }
    });
    return detail.empty() || fail(CirclePointStatus::other_joint_moved, detail);
  }

  bool fit_axes() {
    for (const JointArc& arc : arcs_) {
      CircleAxis fit = axis_of(arc, options_.largest_u_direction_rad);
      if (!fit.ok()) return fail(fit.status, fit.detail);
      result_.axes.push_back(fit.axis);
    }
    return true;
  }

  bool place_tip() {
    std::vector<Eigen::Vector3d> tips;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      tips.push_back(tip_at_home(arcs_[i], result_.axes[i]));
      const double weight =
          static_cast<double>(arcs_[i].points_mm.size()) / (arcs_[i].u_mm * arcs_[i].u_mm);
      sum += weight * tips.back();
      weights += weight;
    }
    result_.tip_at_home_mm = sum / weights;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const double off = (tips[i] - result_.tip_at_home_mm).norm();
      if (off <= options_.largest_disagreement_mm) continue;
      return fail(CirclePointStatus::arcs_disagree,
                  fmt::format("the points of joint {} put the tip at home {:.3f} mm from where all "
                              "together put it",
                              i + 1, off));
    }
    return true;
  }

  // The axes with the senses in which the arm's angles grow.
  [[nodiscard]] AxesAtPosture axes_of(const ArmModel& arm) const {
    AxesAtPosture at{{}, result_.tip_at_home_mm, result_.home_rad};
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      at.axes.push_back(
          {result_.axes[i].center_mm, arm.joints[i].direction * result_.axes[i].direction});
    }
    return at;
  }

  // An axis and its opposite are one line: of all counting directions that make an arm, those
  // whose numbers are nearest to the nominal arm's.
  bool make_arm() {
    std::optional<ArmFromAxes> best;
    unsigned reversed = 0;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned joints = 0; joints < 1U << arcs_.size(); ++joints) {
      const ArmModel pattern = with_reversed(nominal_, joints);
      const auto candidate = arm_from_axes(pattern, axes_of(pattern));
      if (!candidate) continue;
      const double distance = distance_between(candidate->arm, pattern);
      if (distance >= least) continue;
      least = distance;
      best = candidate;
      reversed = joints;
    }
    if (!best) {
      return fail(CirclePointStatus::unlike_nominal,
                  "no link of the nominal arm joins the axes as they were measured");
    }
    result_.arm = best->arm;
    result_.reference_from_base = best->frame_from_base;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      if ((reversed >> i & 1U) != 0) result_.reversed.push_back(static_cast<int>(i) + 1);
    }
    const auto problem = unlike(result_.arm, nominal_);
    return !problem || fail(CirclePointStatus::unlike_nominal, *problem);
  }

  void judge() {
    result_.status = CirclePointStatus::found;
    const ForwardKinematics kinematics(result_.arm);
    double squares = 0.0;
    double count = 0.0;
    for_each_row([&](Eigen::Index row, Eigen::Index) {
      const Eigen::VectorXd e = group_.encoder_rad.col(row);
      const Eigen::Vector3d tip = kinematics.tip_in_base(as_span(e));
      squares += (result_.reference_from_base * tip - group_.reference_mm.col(row)).squaredNorm();
      count += 1.0;
    });
    result_.rms_mm = std::sqrt(squares / count);
  }

  const ArmModel& nominal_;
  const ObservationGroup& group_;
  const CirclePointOptions& options_;
  std::vector<JointArc> arcs_;
  CirclePointAnalysis result_;
};

}  // namespace

CirclePointAnalysis analyse_circle_points(const ArmModel& nominal, const ObservationGroup& arcs,
                                          const CirclePointOptions& options) {
  check(nominal, arcs);
  return Analyser(nominal, arcs, options).run();
}

}  // namespace armcal
