// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/objective.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/invariant.h"
#include "armcal/identification/estimation_problem.h"

namespace armcal {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

bool is_plain_seat(const ObservationGroup& group) {
  return group.kind == ReferenceKind::fixed_point && group.target.empty() &&
         group.offset_mm.isZero(0.0);
}

bool is_seat_or_length(const ObservationGroup& group) {
  return group.kind == ReferenceKind::fixed_point || group.kind == ReferenceKind::length;
}

template <class Use>
void for_each_fitted_row(const ObservationGroup& group, const Use& use) {
  for (Eigen::Index row = 0; row < group.count(); ++row) {
    if (!group.is_check[static_cast<std::size_t>(row)]) use(row);
  }
}

// In closed form only if no seat holds anything but the tip, and none ends two lengths.
bool can_be_closed(std::span<const ObservationGroup> groups) {
  std::map<std::string, int> ends;
  for (const ObservationGroup& group : groups) {
    if (group.kind == ReferenceKind::fixed_point && !is_plain_seat(group)) return false;
    if (group.kind == ReferenceKind::fixed_point) {
      for_each_fitted_row(group, [&](Eigen::Index row) {
        ends.try_emplace(group.place[static_cast<std::size_t>(row)], 0);
      });
    }
  }
  bool each_once = true;
  for (const ObservationGroup& group : groups) {
    if (group.kind != ReferenceKind::length) continue;
    for_each_fitted_row(group, [&](Eigen::Index row) {
      for (const auto* place : {&group.place, &group.place_to}) {
        const auto end = ends.find((*place)[static_cast<std::size_t>(row)]);
        // A length without its seat is told by the residual that knows about it.
        each_once = each_once && end != ends.end() && ++end->second == 1;
      }
    });
  }
  return each_once;
}

}  // namespace

ArmObjective::ArmObjective(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                           std::vector<int> parameters)
    : nominal_(nominal),
      nominal_values_(parameter_values(nominal)),
      parameters_(std::move(parameters)),
      nuisances_(nominal, {}) {
  const bool closed = can_be_closed(groups);
  if (closed) add_seats(groups);
  for (const ObservationGroup& group : groups) {
    if (closed && is_seat_or_length(group)) {
      if (group.kind == ReferenceKind::length) add_distances(group);
      continue;
    }
    for (auto& residual : residuals_of(group, false, nuisances_)) {
      others_.push_back(std::move(residual));
    }
  }
  if (seats_.empty() && others_.empty()) throw std::invalid_argument("there are no readings");
  std::string problem;
  static_cast<void>(of_others(nominal_, &problem));
  if (!problem.empty()) throw std::invalid_argument(problem);
}

void ArmObjective::add_seats(std::span<const ObservationGroup> groups) {
  struct Rows {
    std::vector<Eigen::VectorXd> encoder_rad;
    std::vector<double> u_mm;
  };
  std::map<std::string, Rows> seats;
  for (const ObservationGroup& group : groups) {
    if (group.kind != ReferenceKind::fixed_point) continue;
    for_each_fitted_row(group, [&](Eigen::Index row) {
      Rows& rows = seats[group.place[static_cast<std::size_t>(row)]];
      rows.encoder_rad.emplace_back(group.encoder_rad.col(row));
      rows.u_mm.push_back(group.u_mm(row));
    });
  }
  for (const auto& [name, rows] : seats) {
    const auto count = static_cast<Eigen::Index>(rows.u_mm.size());
    Eigen::MatrixXd encoder_rad(nominal_.joint_count(), count);
    Eigen::VectorXd weights(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      encoder_rad.col(i) = rows.encoder_rad[at];
      weights(i) = 1.0 / (rows.u_mm[at] * rows.u_mm[at]);
    }
    seats_.push_back({name, PosturePacks(encoder_rad), weights});
  }
}

void ArmObjective::add_distances(const ObservationGroup& group) {
  const auto seat_named = [&](const std::string& name) {
    const auto at = std::find_if(seats_.begin(), seats_.end(),
                                 [&](const Seat& seat) { return seat.name == name; });
    ARMCAL_INVARIANT(at != seats_.end());
    return static_cast<std::size_t>(at - seats_.begin());
  };
  for_each_fitted_row(group, [&](Eigen::Index row) {
    const auto at = static_cast<std::size_t>(row);
    distances_.push_back({seat_named(group.place[at]), seat_named(group.place_to[at]),
                          group.value_mm(row), group.u_mm(row)});
  });
}

Eigen::VectorXd ArmObjective::start() const { return nominal_values_(parameters_); }

ArmModel ArmObjective::arm(const Eigen::VectorXd& values) const {
  ARMCAL_INVARIANT(values.size() == static_cast<Eigen::Index>(parameters_.size()));
  Eigen::VectorXd all = nominal_values_;
  all(parameters_) = values;
  return with_parameter_values(nominal_, all);
}

double ArmObjective::operator()(const Eigen::VectorXd& values) const {
  const ArmModel candidate = arm(values);
  return of_seats(candidate) + of_others(candidate, nullptr);
}

double ArmObjective::of_seats(const ArmModel& arm) const {
  if (seats_.empty()) return 0.0;
  const TipRows kinematics(arm, {});
  double sum = 0.0;
  Eigen::Matrix3Xd means(3, static_cast<Eigen::Index>(seats_.size()));
  Eigen::VectorXd mobility(means.cols());  // variance of a coordinate of the mean
  Eigen::Matrix3Xd tips;
  for (std::size_t i = 0; i < seats_.size(); ++i) {
    const Seat& seat = seats_[i];
    const auto at = static_cast<Eigen::Index>(i);
    tips.resize(3, seat.postures.count());
    kinematics.fill(seat.postures, 0, seat.postures.count(), {.tips = tips.data()});
    mobility(at) = 1.0 / seat.weights.sum();
    means.col(at) = mobility(at) * (tips * seat.weights);
    sum += (tips.colwise() - means.col(at)).colwise().squaredNorm() * seat.weights;
  }
  // Seats that a length pulls move along the line between them, each as far as its weight lets it:
  // the least of d1^2/m1 + d2^2/m2 + (D - d1 - d2 - L)^2/u^2 over d1, d2 is
  // (D - L)^2 / (u^2 + m1 + m2).
  for (const Distance& each : distances_) {
    const auto from = static_cast<Eigen::Index>(each.from);
    const auto to = static_cast<Eigen::Index>(each.to);
    const double missing = (means.col(from) - means.col(to)).norm() - each.length_mm;
    sum += missing * missing / (each.u_mm * each.u_mm + mobility(from) + mobility(to));
  }
  return sum;
}

double ArmObjective::of_others(const ArmModel& arm, std::string* problem) const {
  if (others_.empty()) return 0.0;
  Unknowns unknowns(arm, {});
  for (const Nuisance& nuisance : nuisances_.nuisances())
    unknowns.add(nuisance.name, nuisance.kind);
  Eigen::VectorXd x = unknowns.start();
  const ArmAt at{arm, TipRows(arm, {})};
  const std::string refusal = start_all(others_, at, unknowns, x);
  if (problem != nullptr) *problem = refusal;
  if (!refusal.empty()) return kNowhere;
  std::vector<const Residual*> residuals;
  for (const auto& residual : others_) residuals.push_back(residual.get());
  const EstimationProblem fit(residuals, unknowns, {});
  if (fit.unknown_count() == 0) return residuals_at(fit, x).squaredNorm();
  const LeastSquaresSolution placed =
      solve_least_squares(fit, x, {.residual_resolution = fit.residual_resolution()});
  const bool at_rest = placed.termination == Termination::converged ||
                       placed.termination == Termination::rank_deficient ||
                       placed.termination == Termination::no_decrease;
  return at_rest ? placed.cost : kNowhere;
}

}  // namespace armcal
