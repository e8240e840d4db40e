// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "armcal/arm/estimability.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/spelling.h"
#include "armcal/identification/check_rows.h"
#include "armcal/identification/choice_of_unknowns.h"
#include "armcal/identification/coverage.h"
#include "armcal/identification/estimation_problem.h"
#include "armcal/identification/nuisance_values.h"
#include "armcal/identification/residual_statistics.h"
#include "armcal/identification/row_residuals.h"
#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

bool is_held_by_user(const std::string& name, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return matches_glob(name, pattern); });
}

std::optional<double> prior_u(const Parameter& parameter, const CalibrationOptions& options) {
  const auto own = options.prior_of.find(parameter.name);
  if (own != options.prior_of.end()) return own->second;
  if (parameter.unit == ParameterUnit::mm) return options.prior_length_mm;
  if (parameter.kind == ParameterKind::zero) return options.prior_zero_rad;
  if (parameter.harmonic > 0) return options.prior_harmonic_rad;
  return options.prior_twist_rad;
}

// One calibration in the making.
class Calibrator {
 public:
  Calibrator(const ArmModel& nominal, std::span<const ObservationGroup> groups,
             const CalibrationOptions& options)
      : groups_(groups),
        options_(options),
        nominal_(with_harmonics(nominal, options.harmonics)),
        table_(nominal_),
        unknowns_(nominal_, wanted()) {
    result_.nominal = unknowns_.nominal();
    result_.arm = unknowns_.nominal();
  }

  Calibration run() {
    if (!prepare() || !knows_scale() || !estimate()) return std::move(result_);
    finish();
    return std::move(result_);
  }

  Calibration look() {
    if (!prepare()) return std::move(result_);
    static_cast<void>(knows_scale());
    result_.unknowns = unknowns_.step_size();
    const EstimationProblem everything(pointers_, unknowns_, priors(unknowns_));
    choice_ = choose_unknowns(triangular_factor(everything, x_, options_.monitor), unknowns_,
                              options_, scale_is_known_);
    result_.rank = static_cast<int>(choice_.kept.size());
    result_.condition_number = choice_.condition_number;
    result_.unseen.insert(result_.unseen.end(), choice_.unseen.begin(), choice_.unseen.end());
    for (int i = 0; i < table_.size(); ++i) {
      std::optional<double> u;
      for (std::size_t k = 0; k < choice_.kept.size(); ++k) {
        const int column = choice_.kept[k];
        const bool is_this = column < unknowns_.arm_size() &&
                             unknowns_.free()[static_cast<std::size_t>(column)] == i;
        if (is_this) u = choice_.factor.row(static_cast<Eigen::Index>(k)).norm();
      }
      add_parameter(i, table_[i].nominal, u);
    }
    result_.status = CalibrationStatus::converged;
    return std::move(result_);
  }

 private:
  std::vector<int> wanted() {
    std::vector<int> free;
    for (int i = 0; i < table_.size(); ++i) {
      if (is_held_by_user(table_[i].name, options_.hold)) continue;
      if (!held_by_convention(nominal_, table_[i])) free.push_back(i);
    }
    return free;
  }

  bool fail(CalibrationStatus status, std::string detail = "") {
    result_.status = status;
    result_.detail = std::move(detail);
    return false;
  }

  bool prepare() {
    for (const ObservationGroup& group : groups_) {
      for (auto& residual : residuals_of(group, false, unknowns_))
        residuals_.push_back(std::move(residual));
    }
    if (residuals_.empty()) return fail(CalibrationStatus::no_readings);
    for (const auto& residual : residuals_) pointers_.push_back(residual.get());
    x_ = unknowns_.start();
    const ArmAt at{unknowns_.nominal(), TipRows(unknowns_.nominal(), unknowns_.columns())};
    const std::string problems = start_all(residuals_, at, unknowns_, x_);
    if (!problems.empty()) return fail(CalibrationStatus::cannot_start, problems);
    weigh_all(residuals_, unknowns_, x_);
    const auto before = residuals_of_observations(pointers_, unknowns_, x_);
    nominal_lengths_mm_ = lengths_of(before);
    places_at_start_ = x_.tail(x_.size() - unknowns_.arm_size());
    for (const ObservationGroup& group : groups_) {
      GroupResult each;
      each.name = group.name;
      each.kind = group.kind;
      each.nominal = statistics_of(before, group);
      result_.groups.push_back(each);
    }
    return true;
  }

  // A fixed point fits an arm of any size, best one of size zero: unless something knows a length,
  // stop.
  bool knows_scale() {
    for (const Residual* residual : pointers_) {
      if (residual->knows_scale()) return true;
    }
    for (int i = 0; i < table_.size(); ++i) {
      const Parameter& parameter = table_[i];
      if (parameter.unit != ParameterUnit::mm || held_by_convention(nominal_, parameter)) continue;
      const auto& free = unknowns_.free();
      const bool is_free = std::find(free.begin(), free.end(), i) != free.end();
      if (parameter.nominal != 0.0 && (!is_free || prior_u(parameter, options_))) return true;
    }
    scale_is_known_ = false;
    return options_.allow_rank_deficient || fail(CalibrationStatus::scale_unknown);
  }

  void use(Unknowns next) {
    x_ = next.state_from(unknowns_, x_);
    unknowns_ = std::move(next);
  }

  // Priors of the free parameters, by place among the unknowns.
  [[nodiscard]] std::vector<Prior> priors(const Unknowns& unknowns) const {
    std::vector<Prior> priors;
    for (std::size_t i = 0; i < unknowns.free().size(); ++i) {
      const Parameter& parameter = table_[unknowns.free()[i]];
      if (const auto u = prior_u(parameter, options_)) {
        priors.push_back({static_cast<int>(i), parameter.nominal, *u});
      }
    }
    return priors;
  }

  bool estimate() {
    const Unknowns all = unknowns_;
    result_.unknowns = all.step_size();
    // Harmonics are small: with the geometry far off they would fit its error, and keep it.
    std::vector<int> geometry;
    for (const int index : all.free()) {
      if (table_[index].harmonic == 0) geometry.push_back(index);
    }
    if (geometry.size() < all.free().size()) {
      stage_ = "geometry";
      if (!refine(all.with_free(geometry))) return false;
    }
    stage_ = "all";
    return refine(all);
  }

  // What is determined is asked at the nominal arm and again at the adjusted one: symmetries of a
  // nominal arm hide what the real one shows, and the other way round. Weights that depend on the
  // arm are taken anew with it, so with them there is a second solution at least.
  bool refine(const Unknowns& all) {
    constexpr int kRounds = 4;
    const int least_solutions = has_uncertain_encoders() ? 2 : 1;
    for (int round = 0; round < kRounds; ++round) {
      weigh_all(residuals_, unknowns_, x_);
      const Eigen::VectorXd here = all.state_from(unknowns_, x_);
      const EstimationProblem everything(pointers_, all, priors(all));
      const ChoiceOfUnknowns next = choose_unknowns(
          triangular_factor(everything, here, options_.monitor), all, options_, scale_is_known_);
      const bool settled = round >= least_solutions && next.free == choice_.free &&
                           next.held_steps.size() == choice_.held_steps.size();
      if (settled) return true;
      choice_ = next;
      use(all.with_free(choice_.free));
      held_steps_.clear();
      for (const int step : choice_.held_steps)
        held_steps_.push_back(step - all.arm_size() + unknowns_.arm_size());
      if (!solve()) return false;
    }
    return true;
  }

  [[nodiscard]] bool has_uncertain_encoders() const {
    return std::any_of(groups_.begin(), groups_.end(),
                       [](const ObservationGroup& group) { return group.u_encoder_rad > 0.0; });
  }

  bool solve() {
    const EstimationProblem problem(pointers_, unknowns_, priors(unknowns_), held_steps_);
    if (problem.unknown_count() == 0) return fail(CalibrationStatus::nothing_determined);
    LeastSquaresOptions options;
    options.loss = options_.loss;
    options.residual_resolution = problem.residual_resolution();
    options.threads = options_.threads;
    options.monitor = options_.monitor;
    solution_ = solve_least_squares(problem, x_, options);
    active_ = problem.active();
    result_.termination = solution_.termination;
    result_.iterations += solution_.iterations;
    result_.convergence.push_back({stage_, problem.unknown_count(), solution_.costs});
    if (solution_.termination != Termination::converged)
      return fail(CalibrationStatus::no_convergence);
    x_ = solution_.x;
    return true;
  }

  void finish() {
    result_.status = CalibrationStatus::converged;
    result_.arm = unknowns_.arm_at(x_);
    result_.free = unknowns_.free();
    result_.rank = static_cast<int>(active_.size());
    result_.condition_number = choice_.condition_number;
    result_.unseen = choice_.unseen;
    const EstimationProblem problem(pointers_, unknowns_, {});
    // A robust loss keeps rows that do not belong to the others from widening everything.
    result_.chi_squared = options_.loss == RobustLoss::none
                              ? residuals_at(problem, x_).squaredNorm()
                              : solution_.cost;
    Eigen::Index rows = 0;
    for (const Residual* residual : pointers_)
      rows += residual->count() * residual->rows_per_observation();
    result_.degrees_of_freedom =
        static_cast<int>(rows) - result_.rank + static_cast<int>(priors(unknowns_).size());
    if (result_.degrees_of_freedom > 0) {
      result_.sigma0 = std::sqrt(result_.chi_squared / result_.degrees_of_freedom);
      result_.chi_squared_probability =
          chi_squared_survival(result_.chi_squared, result_.degrees_of_freedom);
    }
    finish_parameters();
    result_.nuisances = nuisance_values(unknowns_, x_, widening() * factor_of_all());
    finish_residuals();
  }

  // What a reading scatters by, in units of what was stated.
  [[nodiscard]] double scatter() const {
    return result_.degrees_of_freedom > 0 ? result_.sigma0 : 1.0;
  }
  // Residuals that scatter more than stated are believed (Birge), less is luck.
  [[nodiscard]] double widening() const { return std::max(1.0, scatter()); }

  void finish_parameters() {
    const Eigen::Index arm_size = unknowns_.arm_size();
    const Eigen::MatrixXd factor = solution_.inverse_factor.topRows(arm_size);
    result_.covariance = widening() * widening() * factor * factor.transpose();
    const Eigen::VectorXd values = parameter_values(result_.arm);
    for (int i = 0; i < table_.size(); ++i) {
      const auto at = std::find(result_.free.begin(), result_.free.end(), i);
      std::optional<double> u;
      if (at != result_.free.end()) u = factor.row(at - result_.free.begin()).norm();
      add_parameter(i, values(i), u);
    }
  }

  /// @param u  by the stated uncertainties; nothing for a parameter that is held
  void add_parameter(int index, double value, const std::optional<double>& u) {
    const Parameter& parameter = table_[index];
    CalibratedParameter each;
    each.name = parameter.name;
    each.unit = parameter.unit;
    each.nominal = parameter.nominal;
    each.value = value;
    if (u) {
      each.u = widening() * *u;
      const auto prior = prior_u(parameter, options_);
      each.status = prior ? ParameterStatus::prior : ParameterStatus::free;
      each.data_share = prior ? std::clamp(1.0 - *u * *u / (*prior * *prior), 0.0, 1.0) : 1.0;
    } else {
      each.reason = reason_for(each.name);
    }
    result_.parameters.push_back(std::move(each));
  }

  [[nodiscard]] std::string reason_for(const std::string& name) const {
    for (const UnseenDirection& unseen : result_.unseen) {
      if (unseen.held == name) return unseen.description;
    }
    for (int i = 0; i < table_.size(); ++i) {
      if (table_[i].name != name || is_held_by_user(name, options_.hold)) continue;
      if (const auto convention = held_by_convention(nominal_, table_[i])) return *convention;
    }
    return "held by the user";
  }

  void flag(const std::vector<ObservationResidual>& residuals, bool is_check) {
    for (FlaggedRow& row : flagged_rows(residuals, is_check))
      result_.flagged.push_back(std::move(row));
  }

  void finish_residuals() {
    const auto fitted = residuals_of_observations(pointers_, unknowns_, x_);
    for (std::size_t g = 0; g < groups_.size(); ++g)
      result_.groups[g].fit = statistics_of(fitted, groups_[g]);
    flag(fitted, false);
    result_.residuals = row_residuals(fitted, nominal_lengths_mm_, unknowns_, x_, groups_);
    const CheckRows check = check_rows_of(groups_, unknowns_, x_, options_.monitor);
    if (!check.residuals.empty()) finish_check(check);
    sort_rows(result_.residuals);
  }

  void finish_check(const CheckRows& check) {
    std::vector<const Residual*> pointers;
    for (const auto& residual : check.residuals) pointers.push_back(residual.get());
    const auto held_out = residuals_of_observations(pointers, check.unknowns, check.x);
    flag(held_out, true);
    std::vector<ObservationResidual> before;
    const auto start =
        start_of_check_rows(check, nominal_, places_at_start_, unknowns_.nuisances().size());
    if (start) before = residuals_of_observations(pointers, nominal_, check.unknowns, *start);
    std::vector<ObservationResidual> registered;
    if (check.registered)
      registered = residuals_of_observations(pointers, check.unknowns, *check.registered);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      GroupResult& group = result_.groups[g];
      group.check = statistics_if_any(held_out, groups_[g]);
      group.check_nominal = statistics_if_any(before, groups_[g]);
      group.check_registered = statistics_if_any(registered, groups_[g]);
    }
    const auto rows = row_residuals(held_out, lengths_of(before), check.unknowns, check.x, groups_);
    result_.residuals.insert(result_.residuals.end(), rows.begin(), rows.end());
    const Coverage coverage = coverage_of(check, unknowns_, factor_of_all(), scatter());
    result_.check_count = coverage.count;
    if (coverage.count > 0) {
      result_.check_coverage =
          static_cast<double>(coverage.inside) / static_cast<double>(coverage.count);
    }
  }

  [[nodiscard]] static std::optional<ResidualStatistics> statistics_if_any(
      const std::vector<ObservationResidual>& residuals, const ObservationGroup& group) {
    const ResidualStatistics statistics = statistics_of(residuals, group);
    if (statistics.count == 0) return std::nullopt;
    return statistics;
  }

  // Rows: all unknowns, zero where one is held. W W^T is their covariance, not widened.
  [[nodiscard]] Eigen::MatrixXd factor_of_all() const {
    Eigen::MatrixXd W =
        Eigen::MatrixXd::Zero(unknowns_.step_size(), solution_.inverse_factor.cols());
    for (std::size_t i = 0; i < active_.size(); ++i) {
      W.row(active_[i]) = solution_.inverse_factor.row(static_cast<Eigen::Index>(i));
    }
    return W;
  }

  std::span<const ObservationGroup> groups_;
  const CalibrationOptions& options_;
  ArmModel nominal_;
  ParameterTable table_;
  Unknowns unknowns_;
  Calibration result_;
  std::vector<std::unique_ptr<Residual>> residuals_;
  std::vector<const Residual*> pointers_;
  Eigen::VectorXd x_;
  std::vector<double> nominal_lengths_mm_;  // of fitted rows, in the order of the residuals
  Eigen::VectorXd places_at_start_;         // start values of the nuisances
  const char* stage_ = "all";
  ChoiceOfUnknowns choice_;
  std::vector<int> held_steps_;
  bool scale_is_known_ = true;
  LeastSquaresSolution solution_;
  std::vector<int> active_;
};

}  // namespace

std::string_view explain(CalibrationStatus status) {
  switch (status) {
    case CalibrationStatus::converged:
      return "converged";
    case CalibrationStatus::no_readings:
      return "there are no readings to fit";
    case CalibrationStatus::cannot_start:
      return "something cannot be placed";
    case CalibrationStatus::scale_unknown:
      return "no reading knows how long a millimetre is: fixed points, planes and spheres of "
             "unknown size fit an arm "
             "of any size alike";
    case CalibrationStatus::nothing_determined:
      return "the readings determine no parameter";
    case CalibrationStatus::no_convergence:
      return "the identification did not converge";
  }
  return "unknown";
}

Calibration identifiability(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                            const CalibrationOptions& options) {
  return Calibrator(nominal, groups, options).look();
}

Calibration calibrate(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                      const CalibrationOptions& options) {
  return Calibrator(nominal, groups, options).run();
}

Eigen::Matrix3d tip_covariance(const ArmModel& arm, const std::vector<int>& free,
                               const Eigen::MatrixXd& covariance,
                               std::span<const double> encoder_rad) {
  const TipLinearisation at = ForwardKinematics(arm).linearise(encoder_rad);
  Eigen::Matrix3Xd J(3, static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    J.col(static_cast<Eigen::Index>(i)) = at.J_tip_parameters.col(free[i]);
  }
  return J * covariance * J.transpose();
}

}  // namespace armcal
