// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/check_rows.h"

#include "armcal/identification/estimation_problem.h"

namespace armcal {
namespace {

// Finds nuisances from the residuals, the arm and the nuisances in `kept` staying. Lengths only
// judge: they would pull the points towards their own value.
std::optional<Eigen::VectorXd> found_anew(const std::vector<std::unique_ptr<Residual>>& all,
                                          Unknowns& unknowns, Eigen::VectorXd x,
                                          const std::vector<bool>& kept, const Monitor& monitor) {
  const ArmModel arm = unknowns.arm_at(x);
  const ArmAt at{arm, TipRows(arm, {})};
  for (std::size_t id = 0; id < kept.size(); ++id)
    unknowns[static_cast<int>(id)].started = kept[id];
  std::vector<const Residual*> placing;
  for (const auto& residual : all) {
    if (residual->group().kind == ReferenceKind::length) continue;
    if (residual->start(at, unknowns, x)) return std::nullopt;
    placing.push_back(residual.get());
  }
  std::vector<int> held;
  for (std::size_t id = 0; id < kept.size(); ++id) {
    const Nuisance& nuisance = unknowns[static_cast<int>(id)];
    const auto size = static_cast<int>(step_names(nuisance).size());
    for (int i = 0; kept[id] && i < size; ++i) held.push_back(static_cast<int>(nuisance.step) + i);
  }
  const EstimationProblem problem(placing, unknowns, {}, held);
  if (problem.unknown_count() == 0) return x;
  weigh_all(all, unknowns, x);
  LeastSquaresOptions options;
  options.monitor = monitor;
  options.residual_resolution = problem.residual_resolution();
  const LeastSquaresSolution solution = solve_least_squares(problem, x, options);
  if (solution.termination != Termination::converged) return std::nullopt;
  return solution.x;
}

bool is_place(const Nuisance& nuisance) { return nuisance.name.rfind("target.", 0) != 0; }

}  // namespace

CheckRows check_rows_of(std::span<const ObservationGroup> groups, const Unknowns& fitted,
                        const Eigen::VectorXd& x, const Monitor& monitor) {
  CheckRows check{{}, Unknowns(fitted.arm_at(x), {}), {}, std::nullopt};
  for (const Nuisance& nuisance : fitted.nuisances()) {
    const int id = check.unknowns.add(nuisance.name, nuisance.kind);
    check.unknowns[id].pivot_mm = nuisance.pivot_mm;
  }
  for (const ObservationGroup& group : groups) {
    for (auto& residual : residuals_of(group, true, check.unknowns)) {
      check.residuals.push_back(std::move(residual));
    }
  }
  if (check.residuals.empty()) return check;
  const std::size_t known = fitted.nuisances().size();
  const std::size_t all = check.unknowns.nuisances().size();
  Eigen::VectorXd start = check.unknowns.start();
  start.head(x.size() - fitted.arm_size()) = x.tail(x.size() - fitted.arm_size());

  std::vector<bool> used(all, false);
  for (const auto& residual : check.residuals) {
    for (const int id : residual->nuisances()) used[static_cast<std::size_t>(id)] = true;
  }
  std::vector<bool> keep_known(all);
  std::vector<bool> keep_targets(all);
  for (std::size_t id = 0; id < all; ++id) {
    keep_known[id] = id < known;
    keep_targets[id] = !used[id] || (id < known && !is_place(check.unknowns[static_cast<int>(id)]));
  }
  Unknowns again = check.unknowns;
  const auto as_fitted = found_anew(check.residuals, check.unknowns, start, keep_known, monitor);
  check.x = as_fitted.value_or(start);
  if (!as_fitted) check.residuals.clear();
  auto registered = found_anew(check.residuals, again, start, keep_targets, monitor);
  if (registered && as_fitted) check.registered = std::move(registered);
  weigh_all(check.residuals, check.unknowns, check.x);
  return check;
}

std::optional<Eigen::VectorXd> start_of_check_rows(const CheckRows& check, const ArmModel& nominal,
                                                   const Eigen::VectorXd& fitted_places,
                                                   std::size_t fitted_nuisances) {
  Unknowns unknowns = check.unknowns;
  Eigen::VectorXd x = unknowns.start();
  x.head(fitted_places.size()) = fitted_places;
  for (std::size_t id = 0; id < unknowns.nuisances().size(); ++id)
    unknowns[static_cast<int>(id)].started = id < fitted_nuisances;
  const ArmAt at{nominal, TipRows(nominal, {})};
  if (!start_all(check.residuals, at, unknowns, x).empty()) return std::nullopt;
  return x;
}

}  // namespace armcal
