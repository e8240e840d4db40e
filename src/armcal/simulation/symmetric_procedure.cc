// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/symmetric_procedure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armcal {
namespace {

constexpr double kNoiselessU_mm = 0.001;  // weights must be finite
constexpr double kRounding_rad = 1e-9;    // of a plan that goes to a stop

// Takes the points of one reading, in the frame in which the reference machine stands for it.
class Gesture {
 public:
  Gesture(Laboratory& laboratory, const SymmetricReading& reading,
          const SymmetricPractice& practice)
      : laboratory_(laboratory),
        practice_(practice),
        reading_(reading),
        reference_from_base_(laboratory.convenient_place(0.0)) {
    raw_.file = reading.name + ".csv";
    std::replace(raw_.file.begin(), raw_.file.end(), ' ', '-');
    raw_.encoder_rad.resize(laboratory.arm().truth().joint_count(), 0);
  }

  RawSymmetricPoints carried_out() {
    switch (reading_.kind) {
      case SymmetricKind::reversal:
        turn_by_half();
        break;
      case SymmetricKind::circle_radius:
        sweep(set_by_hand(reading_.posture_rad), reading_.joint);
        break;
      case SymmetricKind::zero_search:
        search_zero();
        break;
    }
    return std::move(raw_);
  }

 private:
  void turn_by_half() {
    const Eigen::Index joint = reading_.joint - 1;
    Eigen::VectorXd planned_end = reading_.posture_rad;
    planned_end(joint) += planned_turn();
    require_free(planned_end, kRounding_rad);
    const Eigen::VectorXd before = set_by_hand(reading_.posture_rad);
    Eigen::VectorXd after = before + errors(practice_.u_slip_rad);
    after(joint) =
        before(joint) + planned_turn() + practice_.u_half_turn_rad * laboratory_.random().normal();
    after = short_of_stops(after);
    require_free(after);
    for (const char end : {'A', 'B'}) {
      for (int i = 0; i < practice_.repeats; ++i) {
        take(end == 'A' ? before : after);
        raw_.end.push_back(end);
      }
    }
  }

  // A plan that gives no end means half a turn to the side that the stops leave.
  [[nodiscard]] double planned_turn() const {
    using std::numbers::pi;
    const Eigen::Index joint = reading_.joint - 1;
    if (reading_.posture_end_rad.size() > 0) {
      return reading_.posture_end_rad(joint) - reading_.posture_rad(joint);
    }
    const Joint& stops = laboratory_.arm().truth().joints[static_cast<std::size_t>(joint)];
    const double start = reading_.posture_rad(joint);
    const bool only_back =
        start + pi > stops.max_rad + kRounding_rad && start - pi > stops.min_rad - kRounding_rad;
    return only_back ? -pi : pi;
  }

  void search_zero() {
    const Eigen::VectorXd middle = set_by_hand(reading_.posture_rad);
    const int sweeping = reading_.sweep > 0 ? reading_.sweep : reading_.joint - 1;
    const auto settings =
        range_about(middle, reading_.joint, practice_.zero_range_rad, practice_.zero_settings);
    for (const double setting : settings) {
      Eigen::VectorXd posture = middle;
      posture(reading_.joint - 1) = setting;
      const std::size_t first = raw_.points_mm.size();
      sweep(posture, sweeping);
      for (std::size_t i = first; i < raw_.points_mm.size(); ++i) {
        raw_.setting_rad.push_back(
            raw_.encoder_rad(reading_.joint - 1, static_cast<Eigen::Index>(i)));
      }
    }
  }

  // Points of the circle of the tip while one joint turns.
  void sweep(const Eigen::VectorXd& middle, int joint) {
    for (const double angle : range_about(middle, joint, practice_.arc_rad, practice_.arc_points)) {
      Eigen::VectorXd posture = middle;
      posture(joint - 1) = angle;
      require_free(posture);
      take(posture);
    }
  }

  // Equal steps of a joint over a range about where it stands, shifted and at last shortened where
  // it has stops.
  [[nodiscard]] std::vector<double> range_about(const Eigen::VectorXd& posture, int joint,
                                                double range_rad, int count) const {
    const Joint& stops = laboratory_.arm().truth().joints[static_cast<std::size_t>(joint - 1)];
    double low = posture(joint - 1) - range_rad / 2.0;
    low = std::max(std::min(low, stops.max_rad - range_rad), stops.min_rad);
    const double high = std::min(low + range_rad, stops.max_rad);
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
      angles.push_back(low + (high - low) * i / std::max(count - 1, 1));
    }
    return angles;
  }

  [[nodiscard]] Eigen::VectorXd set_by_hand(const Eigen::VectorXd& planned) {
    require_free(planned, kRounding_rad);
    const Eigen::VectorXd posture = short_of_stops(planned + errors(practice_.u_posture_rad));
    require_free(posture);
    return posture;
  }

  [[nodiscard]] Eigen::VectorXd errors(double u_rad) {
    Eigen::VectorXd errors(laboratory_.arm().truth().joint_count());
    for (double& error : errors) error = u_rad * laboratory_.random().normal();
    return errors;
  }

  // A hand sets no joint beyond its stops; nor does a plan, but for rounding.
  [[nodiscard]] Eigen::VectorXd short_of_stops(Eigen::VectorXd posture,
                                               double beyond_rad = HUGE_VAL) const {
    const auto& joints = laboratory_.arm().truth().joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      double& angle = posture(static_cast<Eigen::Index>(i));
      const double stopped = std::clamp(angle, joints[i].min_rad, joints[i].max_rad);
      if (std::abs(angle - stopped) <= beyond_rad) angle = stopped;
    }
    return posture;
  }

  void require_free(const Eigen::VectorXd& posture, double beyond_rad = 0.0) const {
    const Eigen::VectorXd within = short_of_stops(posture, beyond_rad);
    if (const auto obstacle = laboratory_.arm().obstacle(within)) {
      throw Impossible(fmt::format("reading \"{}\" cannot be taken: {}", reading_.name, *obstacle));
    }
  }

  void take(const Eigen::VectorXd& posture) {
    const TakenReading taken = laboratory_.take(posture);
    raw_.points_mm.emplace_back(reference_from_base_ * taken.tip_mm +
                                laboratory_.noise(practice_.u_point_mm));
    const Eigen::Index column = raw_.encoder_rad.cols();
    raw_.encoder_rad.conservativeResize(Eigen::NoChange, column + 1);
    raw_.encoder_rad.col(column) = taken.encoder_rad;
    raw_.lines.push_back(static_cast<int>(column) + 2);
  }

  Laboratory& laboratory_;
  const SymmetricPractice& practice_;
  const SymmetricReading& reading_;
  RigidTransform reference_from_base_;
  RawSymmetricPoints raw_;
};

Eigen::VectorXd degrees(std::initializer_list<double> angles) {
  Eigen::VectorXd posture(static_cast<Eigen::Index>(angles.size()));
  std::transform(angles.begin(), angles.end(), posture.begin(), radians_from_degrees);
  return posture;
}

SymmetricReading planned(std::string name, SymmetricKind kind, int joint,
                         const Eigen::VectorXd& posture_rad, std::string solves = {}) {
  SymmetricReading reading;
  reading.name = std::move(name);
  reading.kind = kind;
  reading.joint = joint;
  reading.posture_rad = posture_rad;
  reading.posture_end_rad = posture_rad;
  if (kind == SymmetricKind::reversal) reading.posture_end_rad(joint - 1) += std::numbers::pi;
  if (kind == SymmetricKind::zero_search) reading.sweep = joint - 1;
  reading.solves = std::move(solves);
  return reading;
}

}  // namespace

SymmetricPointProcedure carry_out(Laboratory& laboratory, const SymmetricPointProcedure& plan,
                                  const SymmetricPractice& practice) {
  SymmetricPointProcedure done = plan;
  for (SymmetricReading& reading : done.readings) {
    reading.raw = Gesture(laboratory, reading, practice).carried_out();
    reading.value = 0.0;
    reading.reduced = false;
    reading.u = practice.u_point_mm > 0.0 ? 0.0 : kNoiselessU_mm;
  }
  return done;
}

SymmetricPointProcedure wang2016_procedure() {
  using enum SymmetricKind;
  const Eigen::VectorXd straight = degrees({0, 0, 0, 0, 0, 0});
  SymmetricPointProcedure procedure;
  procedure.readings = {
      planned("zero 6", zero_search, 6, straight),
      planned("zero 4", zero_search, 4, degrees({0, 0, 0, 0, 0, -90})),
      planned("zero 2", zero_search, 2, degrees({0, 0, 0, 90, 180, -90})),
      planned("l_PP1", reversal, 5, degrees({0, 0, 0, 0, 0, -90}), "b7"),
      planned("l_PP2", reversal, 5, straight, "a7"),
      planned("l_PP3", reversal, 3, straight, "a5"),
      planned("l_PP4", reversal, 3, degrees({0, 0, 0, 90, 0, -90}), "b5"),
      planned("l_PP5", reversal, 1, degrees({0, 90, 0, 90, 180, -90}), "b3"),
      planned("R", circle_radius, 6, straight),
  };
  procedure.unknowns = {"a5", "a7", "b3", "b5", "b7", "zero2", "zero4"};
  return procedure;
}

}  // namespace armcal
