// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/choice_of_unknowns.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "armcal/arm/estimability.h"
#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/rank_analysis.h"

namespace armcal {
namespace {

// Readings and models are rounded; a column that sticks out by less than this is explained by the
// others.
constexpr double kRankTolerance = 1e-8;

std::string too_weak(const Parameter& parameter, double u) {
  // A parameter that is known no better than this moves readings by rounding only.
  constexpr double kAllButUnseen_mm = 1e4;
  constexpr double kAllButUnseen_rad = 6.0;
  const bool is_length = parameter.unit == ParameterUnit::mm;
  if (u > (is_length ? kAllButUnseen_mm : kAllButUnseen_rad)) {
    return fmt::format("no reading depends on {}", parameter.name);
  }
  return fmt::format("the readings see {} too weakly: its standard uncertainty would be {:.2g} {}",
                     parameter.name, is_length ? u : degrees_from_radians(u),
                     is_length ? "mm" : "deg");
}

// A frame that points of a line place can turn about that line unseen. Of the three turns that
// about the coordinate axis nearest to the line sticks out least of what shifts do, and is wanted
// least: another one held in its place would leave two that are nearly the same.
void put_weak_turns_last(const Eigen::MatrixXd& r, const Unknowns& unknowns,
                         std::vector<int>& order) {
  for (const Nuisance& nuisance : unknowns.nuisances()) {
    if (nuisance.kind != NuisanceKind::frame) continue;
    const auto first = static_cast<int>(nuisance.step);
    const Eigen::HouseholderQR<Eigen::MatrixXd> shifts(r.middleCols(first + 3, 3));
    Eigen::Vector3d sticks_out;
    for (int turn = 0; turn < 3; ++turn) {
      const Eigen::VectorXd rotated = shifts.householderQ().adjoint() * r.col(first + turn);
      sticks_out(turn) = rotated.tail(rotated.size() - 3).norm();
    }
    std::array turns{0, 1, 2};
    std::stable_sort(turns.begin(), turns.end(),
                     [&](int one, int other) { return sticks_out(one) > sticks_out(other); });
    const auto at = std::find(order.begin(), order.end(), first);
    for (int i = 0; i < 3; ++i) {
      *(at + i) = first + 3 + i;
      *(at + 3 + i) = first + turns[static_cast<std::size_t>(i)];
    }
  }
}

std::vector<int> order_of_wish(const Eigen::MatrixXd& r, const Unknowns& unknowns) {
  std::vector<int> order;
  for (int i = unknowns.arm_size(); i < unknowns.step_size(); ++i) order.push_back(i);
  put_weak_turns_last(r, unknowns, order);
  const ParameterTable table(unknowns.nominal());
  const auto& free = unknowns.free();
  for (const int index : wanted_order(unknowns.nominal(), table)) {
    const auto at = std::find(free.begin(), free.end(), index);
    if (at != free.end()) order.push_back(static_cast<int>(at - free.begin()));
  }
  return order;
}

// A free parameter that is known too badly to be of use: of those nearly as bad as the worst (they
// trade against each other), the one that is wanted least.
struct Weakest {
  int place = -1;  // among the kept columns, most wanted first
  double u = 0.0;
};
Weakest weakest_of(const Eigen::MatrixXd& kept, const std::vector<int>& columns,
                   const Unknowns& unknowns, const ParameterTable& table,
                   const CalibrationOptions& options) {
  const auto factor = inverse_factor(kept);
  if (!factor) return {};
  std::vector<double> u(columns.size(), 0.0);
  std::vector<double> ratio(columns.size(), 0.0);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] >= unknowns.arm_size()) continue;
    const Parameter& parameter = table[unknowns.free()[static_cast<std::size_t>(columns[i])]];
    const bool is_length = parameter.unit == ParameterUnit::mm;
    u[i] = factor->row(static_cast<Eigen::Index>(i)).norm();
    ratio[i] = u[i] / (is_length ? options.largest_useful_u_mm : options.largest_useful_u_rad);
  }
  constexpr double kNearlyAsBad = 0.1;
  const double bad = std::max(1.0, kNearlyAsBad * *std::max_element(ratio.begin(), ratio.end()));
  for (std::size_t i = columns.size(); i-- > 0;) {
    if (ratio[i] >= bad) return {static_cast<int>(i), u[i]};
  }
  return {};
}

// Column of the kept length with the largest nominal value, or -1.
int longest_length(const std::vector<int>& kept, const Unknowns& unknowns,
                   const ParameterTable& table) {
  int longest = -1;
  double length = 0.0;
  for (const int column : kept) {
    if (column >= unknowns.arm_size()) continue;
    const Parameter& parameter = table[unknowns.free()[static_cast<std::size_t>(column)]];
    if (parameter.unit != ParameterUnit::mm || std::abs(parameter.nominal) <= length) continue;
    longest = column;
    length = std::abs(parameter.nominal);
  }
  return longest;
}

}  // namespace

ChoiceOfUnknowns choose_unknowns(const Eigen::MatrixXd& r, const Unknowns& unknowns,
                                 const CalibrationOptions& options, bool scale_is_known) {
  const ParameterTable table(unknowns.nominal());
  const std::vector<std::string> all_names = unknowns.names();
  std::vector<int> wanted = order_of_wish(r, unknowns);
  ChoiceOfUnknowns choice;
  for (;;) {
    std::vector<int> order(wanted.size());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      order[i] = static_cast<int>(i);
      names.push_back(all_names[static_cast<std::size_t>(wanted[i])]);
    }
    const RankAnalysis analysis = analyse_rank(r(Eigen::all, wanted), order, kRankTolerance);
    std::vector<int> kept;
    for (const int place : analysis.basis) kept.push_back(wanted[static_cast<std::size_t>(place)]);
    if (!scale_is_known) {
      // What depends on the longest length must not take its place once it is held.
      for (const DependentColumn& dependent : analysis.dependent) {
        const std::size_t place = static_cast<std::size_t>(dependent.column);
        choice.unseen.push_back({names[place], describe(dependent, analysis, names), {}});
      }
      std::erase_if(wanted, [&](int column) {
        return std::find(kept.begin(), kept.end(), column) == kept.end();
      });
      const int longest = longest_length(kept, unknowns, table);
      if (longest >= 0) {
        const std::string& name = all_names[static_cast<std::size_t>(longest)];
        choice.unseen.insert(
            choice.unseen.begin(),
            {name,
             fmt::format("no reading knows how long a millimetre is: {} held, the longest", name),
             {}});
        std::erase(wanted, longest);
      }
      scale_is_known = true;
      continue;
    }
    const Weakest weakest = weakest_of(r(Eigen::all, kept), kept, unknowns, table, options);
    if (weakest.place >= 0) {
      const int column = kept[static_cast<std::size_t>(weakest.place)];
      const Parameter& parameter = table[unknowns.free()[static_cast<std::size_t>(column)]];
      choice.unseen.push_back({parameter.name, too_weak(parameter, weakest.u), {}});
      std::erase(wanted, column);
      continue;
    }
    choice.condition_number = analysis.condition_number;
    choice.kept = kept;
    choice.factor = inverse_factor(r(Eigen::all, kept)).value_or(Eigen::MatrixXd());
    for (const DependentColumn& dependent : analysis.dependent) {
      UnseenDirection unseen;
      unseen.held = names[static_cast<std::size_t>(dependent.column)];
      unseen.description = describe(dependent, analysis, names);
      for (std::size_t i = 0; i < analysis.basis.size(); ++i) {
        const double weight = dependent.weights(static_cast<Eigen::Index>(i));
        if (weight != 0.0) {
          unseen.combination.emplace_back(names[static_cast<std::size_t>(analysis.basis[i])],
                                          weight);
        }
      }
      choice.unseen.push_back(std::move(unseen));
    }
    for (const int place : analysis.unseen) {
      const std::string& name = names[static_cast<std::size_t>(place)];
      choice.unseen.push_back({name, fmt::format("no reading depends on {}", name), {}});
    }
    for (int column = 0; column < unknowns.step_size(); ++column) {
      const bool stays = std::find(kept.begin(), kept.end(), column) != kept.end();
      if (column < unknowns.arm_size()) {
        if (stays) choice.free.push_back(unknowns.free()[static_cast<std::size_t>(column)]);
      } else if (!stays) {
        choice.held_steps.push_back(column);
      }
    }
    return choice;
  }
}

}  // namespace armcal
