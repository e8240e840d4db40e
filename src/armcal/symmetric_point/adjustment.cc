// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/adjustment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "armcal/arm/estimability.h"
#include "armcal/core/units.h"
#include "armcal/numerics/distributions.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/rank_analysis.h"
#include "armcal/numerics/small_least_squares.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

// Less than this share of a reading is checked: nothing but rounding stands behind it.
constexpr double kUnchecked = 1e-6;
// Tests whose statistics correlate so closely are one test.
constexpr double kSameTest = 0.9999;

// The readings as a problem in the chosen unknowns.
class Problem {
 public:
  Problem(const ArmModel& nominal, std::span<const SymmetricReading> readings)
      : nominal_(nominal), nominal_values_(parameter_values(nominal)), readings_(readings) {}

  [[nodiscard]] ArmModel arm_at(const std::vector<int>& unknowns, const Eigen::VectorXd& x) const {
    Eigen::VectorXd values = nominal_values_;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      values(unknowns[i]) = x(static_cast<Eigen::Index>(i));
    }
    return with_parameter_values(nominal_, values);
  }

  [[nodiscard]] Eigen::VectorXd start(const std::vector<int>& unknowns) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      x(static_cast<Eigen::Index>(i)) = nominal_values_(unknowns[i]);
    }
    return x;
  }

  void linearise(const ArmModel& arm, Eigen::VectorXd& residuals, Eigen::MatrixXd& design) const {
    const auto m = static_cast<Eigen::Index>(readings_.size());
    residuals.resize(m);
    design.resize(m, nominal_values_.size());
    for (Eigen::Index i = 0; i < m; ++i) {
      const SymmetricReading& reading = readings_[static_cast<std::size_t>(i)];
      const ReadingPrediction prediction = predict(arm, reading);
      residuals(i) = (reading.value - prediction.value) / reading.u;
      design.row(i) = prediction.gradient.transpose() / reading.u;
    }
  }

  [[nodiscard]] SmallSolution solve(const std::vector<int>& unknowns) const {
    double smallest_u = std::numeric_limits<double>::infinity();
    for (const SymmetricReading& reading : readings_) smallest_u = std::min(smallest_u, reading.u);
    SmallProblem problem;
    // Lengths inside an arm are computed to a few units in the last place of its reach.
    problem.residual_resolution =
        16.0 * std::numeric_limits<double>::epsilon() * reach_mm(nominal_) / smallest_u;
    problem.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) {
      Eigen::MatrixXd design;
      linearise(arm_at(unknowns, x), r, design);
      J = -design(Eigen::all, unknowns);
    };
    return solve_small_least_squares(problem, start(unknowns));
  }

 private:
  const ArmModel& nominal_;
  Eigen::VectorXd nominal_values_;
  std::span<const SymmetricReading> readings_;
};

// What the readings are taken for: lengths that this arm has by design, and zeros that are
// searched. An offset that is 0 by design moves the same readings, and would take the place of a
// length.
bool is_meant(const Parameter& parameter, std::span<const SymmetricReading> readings) {
  if (parameter.unit == ParameterUnit::mm) return parameter.nominal != 0.0;
  return parameter.kind == ParameterKind::zero &&
         std::any_of(readings.begin(), readings.end(), [&](const SymmetricReading& reading) {
           return reading.is_angle() && reading.joint == parameter.joint;
         });
}

std::vector<int> in_wanted_order(const ArmModel& arm, const ParameterTable& table,
                                 std::span<const SymmetricReading> readings,
                                 const std::vector<int>& asked) {
  std::vector<int> ordered;
  for (const int index : wanted_order(arm, table)) {
    if (std::find(asked.begin(), asked.end(), index) != asked.end()) ordered.push_back(index);
  }
  std::stable_partition(ordered.begin(), ordered.end(),
                        [&](int index) { return is_meant(table[index], readings); });
  return ordered;
}

// Of the wanted parameters, those that this design can determine; in words why not the others.
DeterminedParameters choose_unknowns(const ArmModel& arm, const Eigen::MatrixXd& design,
                                     std::vector<int> wanted, const ParameterTable& table,
                                     const AdjustmentOptions& options) {
  DeterminedParameters choice;
  for (;;) {
    const Eigen::MatrixXd part = design(Eigen::all, wanted);
    std::vector<int> order(wanted.size());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      order[i] = static_cast<int>(i);
      names.push_back(table[wanted[i]].name);
    }
    const RankAnalysis analysis = analyse_rank(part, order);
    choice.condition_number = analysis.condition_number;
    choice.unknowns.clear();
    for (const int place : analysis.basis) {
      choice.unknowns.push_back(wanted[static_cast<std::size_t>(place)]);
    }
    // A parameter that data see too weakly to be of use would be returned with metres of
    // uncertainty.
    const auto factor = inverse_factor(design(Eigen::all, choice.unknowns));
    int weakest = -1;
    double weakest_u = 0.0;
    for (std::size_t i = 0; factor && i < choice.unknowns.size(); ++i) {
      const double u = factor->row(static_cast<Eigen::Index>(i)).norm();
      const bool is_length = table[choice.unknowns[i]].unit == ParameterUnit::mm;
      const double limit = is_length ? options.largest_useful_u_mm : options.largest_useful_u_rad;
      if (u > limit) {
        weakest = choice.unknowns[i];  // the last of them is the one wanted least
        weakest_u = u;
      }
    }
    if (weakest < 0) {
      for (const DependentColumn& dependent : analysis.dependent) {
        HeldParameter held;
        held.name = names[static_cast<std::size_t>(dependent.column)];
        held.reason = describe(dependent, analysis, names);
        for (std::size_t i = 0; i < analysis.basis.size(); ++i) {
          held.like.emplace_back(names[static_cast<std::size_t>(analysis.basis[i])],
                                 dependent.weights(static_cast<Eigen::Index>(i)));
        }
        choice.held.push_back(std::move(held));
      }
      for (const int place : analysis.unseen) {
        const std::string& name = names[static_cast<std::size_t>(place)];
        choice.held.push_back({name, "no reading depends on " + name, {}});
      }
      return choice;
    }
    const bool is_length = table[weakest].unit == ParameterUnit::mm;
    const auto convention = held_by_convention(arm, table[weakest]);
    choice.held.push_back(
        {table[weakest].name,
         convention
             ? fmt::format("{} stays nominal {}", table[weakest].name, *convention)
             : fmt::format(
                   "the readings see {} too weakly: its standard uncertainty would be {:.2g} {}",
                   table[weakest].name, is_length ? weakest_u : degrees_from_radians(weakest_u),
                   is_length ? "mm" : "deg"),
         {}});
    std::erase(wanted, weakest);
  }
}

// Does the earlier choice still do at the adjusted arm? Where the new one sees no more, it may
// trade a well-determined parameter for one of nearly the same effect (an offset along an axis that
// is not quite parallel to another) and be as good as singular; then the earlier one stays.
bool still_determined(const Eigen::MatrixXd& design, DeterminedParameters& choice,
                      const DeterminedParameters& next) {
  if (next.unknowns.size() != choice.unknowns.size()) return false;
  const Eigen::MatrixXd part = design(Eigen::all, choice.unknowns);
  std::vector<int> order(choice.unknowns.size());
  std::iota(order.begin(), order.end(), 0);
  const RankAnalysis analysis = analyse_rank(part, order);
  constexpr double kMuchWorse = 10.0;
  const bool is_singular = analysis.rank < static_cast<int>(order.size());
  if (is_singular || analysis.condition_number > kMuchWorse * next.condition_number) return false;
  choice.condition_number = analysis.condition_number;
  return true;
}

// Statistics of every reading from the whitened residuals and the whitened design of the unknowns.
void test_readings(Adjustment& result, std::span<const SymmetricReading> readings,
                   const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian,
                   const Eigen::MatrixXd& factor, const AdjustmentOptions& options) {
  const Eigen::MatrixXd half_hat = jacobian * factor;  // hat matrix = half_hat * half_hat^T
  const Eigen::Index m = residuals.size();
  const Eigen::MatrixXd residual_cofactor =
      Eigen::MatrixXd::Identity(m, m) - half_hat * half_hat.transpose();
  const double detectable =
      normal_quantile(1.0 - options.significance / 2.0) + normal_quantile(options.power);
  for (Eigen::Index i = 0; i < m; ++i) {
    const SymmetricReading& reading = readings[static_cast<std::size_t>(i)];
    AdjustedReading adjusted;
    adjusted.name = reading.name;
    adjusted.is_angle = reading.is_angle();
    adjusted.value = reading.value;
    adjusted.u = reading.u;
    adjusted.residual = residuals(i) * reading.u;
    adjusted.predicted = reading.value - adjusted.residual;
    const double redundancy = std::clamp(residual_cofactor(i, i), 0.0, 1.0);
    if (redundancy > kUnchecked) {
      adjusted.redundancy = redundancy;
      adjusted.smallest_detectable = detectable * reading.u / std::sqrt(redundancy);
      adjusted.normalised = residuals(i) / std::sqrt(redundancy);
      adjusted.estimated_error = adjusted.residual / redundancy;
      for (Eigen::Index j = 0; j < m; ++j) {
        const double other = residual_cofactor(j, j);
        if (j == i || other <= kUnchecked) continue;
        const double correlation = residual_cofactor(i, j) / std::sqrt(redundancy * other);
        if (std::abs(correlation) > kSameTest) {
          adjusted.inseparable_from.push_back(readings[static_cast<std::size_t>(j)].name);
        }
      }
    }
    result.readings.push_back(std::move(adjusted));
  }
}

// Place of the reading with the largest normalised residual above the critical value, or -1.
int most_suspect(const Adjustment& result) {
  int suspect = -1;
  double largest = result.critical_value;
  for (std::size_t i = 0; i < result.readings.size(); ++i) {
    const auto& normalised = result.readings[i].normalised;
    if (normalised && std::abs(*normalised) > largest) {
      largest = std::abs(*normalised);
      suspect = static_cast<int>(i);
    }
  }
  return suspect;
}

Adjustment adjust_once(const ArmModel& nominal, std::span<const SymmetricReading> readings,
                       const AdjustmentOptions& options) {
  Adjustment result;
  result.arm = nominal;
  result.critical_value = normal_quantile(1.0 - options.significance / 2.0);
  if (readings.empty()) return result;
  const ParameterTable table(nominal);
  const Problem problem(nominal, readings);

  Eigen::VectorXd residuals;
  Eigen::MatrixXd design;
  problem.linearise(nominal, residuals, design);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (!std::isfinite(residuals(row)) || !design.row(row).allFinite()) {
      result.status = AdjustmentStatus::not_defined;
      result.detail = readings[i].name;
      return result;
    }
  }
  // Which parameters are determined is asked at the nominal arm and again at the adjusted one:
  // symmetries of a nominal arm hide what the real one shows, and the other way round.
  const std::vector<int> wanted = in_wanted_order(nominal, table, readings, options.unknowns);
  DeterminedParameters choice;
  SmallSolution solution;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const DeterminedParameters next = choose_unknowns(nominal, design, wanted, table, options);
    if (round > 0 && still_determined(design, choice, next)) break;
    choice = next;
    if (choice.unknowns.empty()) {
      result.status = AdjustmentStatus::nothing_determined;
      result.undetermined = choice.held;
      return result;
    }
    solution = problem.solve(choice.unknowns);
    result.iterations += solution.iterations;
    if (!solution.ok()) {
      result.status = AdjustmentStatus::no_convergence;
      return result;
    }
    problem.linearise(problem.arm_at(choice.unknowns, solution.x), residuals, design);
  }
  result.unknowns = choice.unknowns;
  result.undetermined = choice.held;
  result.condition_number = choice.condition_number;
  const Eigen::MatrixXd jacobian = design(Eigen::all, result.unknowns);
  const auto factor = inverse_factor(jacobian);
  if (!factor || solution.x.size() != jacobian.cols()) {
    result.status = AdjustmentStatus::no_convergence;
    return result;
  }
  result.status = AdjustmentStatus::converged;
  result.values = solution.x;
  result.arm = problem.arm_at(result.unknowns, solution.x);
  result.covariance = *factor * factor->transpose();
  for (const int index : result.unknowns) result.unknown_names.push_back(table[index].name);
  test_readings(result, readings, residuals, jacobian, *factor, options);
  result.chi_squared = residuals.squaredNorm();
  result.degrees_of_freedom = static_cast<int>(residuals.size() - jacobian.cols());
  if (result.degrees_of_freedom > 0) {
    result.chi_squared_probability =
        chi_squared_survival(result.chi_squared, result.degrees_of_freedom);
  }
  return result;
}

}  // namespace

std::string_view explain(AdjustmentStatus status) {
  switch (status) {
    case AdjustmentStatus::converged:
      return "converged";
    case AdjustmentStatus::no_readings:
      return "there are no readings";
    case AdjustmentStatus::nothing_determined:
      return "the readings determine none of the parameters asked for";
    case AdjustmentStatus::not_defined:
      return "a reading does not exist on the nominal arm (tip on the axis of the joint, or no "
             "extremum)";
    case AdjustmentStatus::no_convergence:
      return "the adjustment did not converge";
  }
  return "unknown";
}

bool Adjustment::has_flagged() const {
  return std::any_of(readings.begin(), readings.end(),
                     [](const AdjustedReading& reading) { return reading.flagged; });
}

double Adjustment::u(Eigen::Index place) const { return std::sqrt(covariance(place, place)); }

Adjustment adjust(const ArmModel& nominal, std::span<const SymmetricReading> readings,
                  const AdjustmentOptions& options) {
  Adjustment result = adjust_once(nominal, readings, options);
  if (!result.ok()) return result;
  // Data snooping, one reading at a time: a gross error spills into the residuals of others, so
  // each is judged only after the worst one has been set aside.
  std::vector<SymmetricReading> kept(readings.begin(), readings.end());
  std::vector<std::size_t> original(readings.size());
  for (std::size_t i = 0; i < original.size(); ++i) original[i] = i;
  Adjustment current = result;
  for (;;) {
    const int suspect = most_suspect(current);
    if (suspect < 0) break;
    const auto place = static_cast<std::size_t>(suspect);
    result.readings[original[place]].flagged = true;
    const AdjustedReading& reading = current.readings[place];
    if (!reading.inseparable_from.empty()) {
      // One check, several readings: all are named, none can be acquitted by removing another.
      for (AdjustedReading& other : result.readings) {
        const auto& same = reading.inseparable_from;
        if (std::find(same.begin(), same.end(), other.name) != same.end()) other.flagged = true;
      }
      break;
    }
    kept.erase(kept.begin() + suspect);
    original.erase(original.begin() + suspect);
    current = adjust_once(nominal, kept, options);
    if (!current.ok()) break;
  }
  return result;
}

DeterminedParameters determined_parameters(const ArmModel& arm,
                                           std::span<const SymmetricReading> readings) {
  AdjustmentOptions everything;
  everything.unknowns.resize(static_cast<std::size_t>(ParameterTable(arm).size()));
  std::iota(everything.unknowns.begin(), everything.unknowns.end(), 0);
  return determined_parameters(arm, readings, everything);
}

DeterminedParameters determined_parameters(const ArmModel& arm,
                                           std::span<const SymmetricReading> readings,
                                           const AdjustmentOptions& options) {
  const ParameterTable table(arm);
  return choose_unknowns(arm, design_matrix(arm, readings),
                         in_wanted_order(arm, table, readings, options.unknowns), table, options);
}

Eigen::MatrixXd design_matrix(const ArmModel& arm, std::span<const SymmetricReading> readings) {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd design;
  Problem(arm, readings).linearise(arm, residuals, design);
  return design;
}

}  // namespace armcal
