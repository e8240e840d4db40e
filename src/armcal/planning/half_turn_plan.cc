// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/half_turn_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/planning/d_optimal_exchange.h"
#include "armcal/planning/half_turn_walk.h"
#include "armcal/planning/length_prediction.h"
#include "armcal/planning/reading_order.h"
#include "armcal/planning/reliability.h"
#include "armcal/symmetric_point/adjustment.h"
#include "armcal/symmetric_point/encoder_share.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

// Half turns of an arm without stops and with nothing around it: what could be seen at best.
constexpr int kFreeHalfTurns = 400;
constexpr int kPairs = 1000;

// Names of what a free arm would show and these half turns do not.
std::vector<std::string> unseen(const ArmModel& arm, const DeterminedParameters& seen,
                                const HalfTurnWishes& wishes) {
  ArmModel free = arm;
  for (Joint& joint : free.joints) {
    joint.min_rad = -std::numeric_limits<double>::infinity();
    joint.max_rad = std::numeric_limits<double>::infinity();
  }
  HalfTurnRoom room;
  room.grid_rad = 0.0;
  Rejections none;
  const auto turns = half_turn_candidates(free, room, kFreeHalfTurns, wishes.seed, none);
  const DeterminedParameters best = determined_parameters(arm, readings_of(arm, turns, wishes));
  const ParameterTable table(arm);
  std::vector<std::string> names;
  for (const int unknown : best.unknowns) {
    const auto& known = seen.unknowns;
    if (std::find(known.begin(), known.end(), unknown) == known.end()) {
      names.push_back(table[unknown].name);
    }
  }
  return best.unknowns.size() > seen.unknowns.size() ? names : std::vector<std::string>{};
}

std::string joints_of(const HalfTurnRoom& room) {
  if (room.joints.empty()) return "the half turns that are possible here";
  return fmt::format("half turns of joint{} {} alone", room.joints.size() == 1 ? "" : "s",
                     fmt::join(room.joints, ", "));
}

void check(const HalfTurnWishes& wishes) {
  if (wishes.readings < 1 || wishes.repeats < 1 || !(wishes.u_mm > 0.0)) {
    throw std::invalid_argument(
        fmt::format("a plan needs readings and repeats of at least 1 and an uncertainty above 0, "
                    "not {}, {} and {}",
                    wishes.readings, wishes.repeats, wishes.u_mm));
  }
}

// Table indices of what the candidates determine together; refuses where that is less than half
// turns can tell of this arm.
std::vector<int> seen_unknowns(const HalfTurnPlan& plan,
                               const std::vector<SymmetricReading>& candidates) {
  if (candidates.empty()) {
    throw ImpossiblePlan(fmt::format("no half turn is possible: {}", explain(plan.rejections)));
  }
  const DeterminedParameters seen = determined_parameters(plan.arm, candidates);
  if (const auto missing = unseen(plan.arm, seen, plan.wishes); !missing.empty()) {
    throw ImpossiblePlan(fmt::format("{} ({} found) do not determine {}; {}",
                                     joints_of(plan.wishes.room), plan.candidates,
                                     fmt::join(missing, ", "), explain(plan.rejections)));
  }
  return seen.unknowns;
}

void check_counts(const HalfTurnPlan& plan) {
  const HalfTurnWishes& wishes = plan.wishes;
  const int unknowns = plan.rank();
  if (wishes.readings < unknowns) {
    throw ImpossiblePlan(
        fmt::format("{} half turns cannot determine {} parameters\n  help: take at least {}, "
                    "better {}",
                    wishes.readings, unknowns, unknowns + 3, 2 * unknowns));
  }
  // Redundancy numbers add up to readings - unknowns.
  const double mean = static_cast<double>(wishes.readings - unknowns) / wishes.readings;
  if (wishes.least_redundancy > mean) {
    throw ImpossiblePlan(fmt::format(
        "{} half turns for {} parameters have redundancy numbers of {:.3f} on average: not all can "
        "be above {:.3f}\n  help: take at least {} half turns, or a lower --min-redundancy",
        wishes.readings, unknowns, mean, wishes.least_redundancy,
        static_cast<int>(std::ceil(unknowns / (1.0 - std::min(wishes.least_redundancy, 0.99))))));
  }
  if (plan.candidates < wishes.readings) {
    throw ImpossiblePlan(fmt::format("only {} different half turns are possible, {} are wanted: {}",
                                     plan.candidates, wishes.readings, explain(plan.rejections)));
  }
}

void check_limits(const ChosenObservations& chosen, const HalfTurnWishes& wishes) {
  if (chosen.rows.empty()) {
    throw ImpossiblePlan("no choice of half turns determines all parameters");
  }
  if (chosen.keeps_limits) return;
  if (chosen.least_redundancy < wishes.least_redundancy) {
    throw ImpossiblePlan(
        fmt::format("no choice of {} half turns was found with every redundancy number above "
                    "{:.3f}; the best has {:.3f}\n  help: take more half turns, or a lower "
                    "--min-redundancy",
                    wishes.readings, wishes.least_redundancy, chosen.least_redundancy));
  }
  throw ImpossiblePlan(
      fmt::format("no choice of {} half turns was found in which an error of {} mm of any single "
                  "reading is found and named; the best leaves {:.3f} mm\n  help: take more half "
                  "turns, repeat the encoder readings, or lower their uncertainty",
                  wishes.readings, wishes.largest_unnamed_mm, chosen.largest_unnamed));
}

Eigen::VectorXd uncertainties(const std::vector<SymmetricReading>& readings) {
  Eigen::VectorXd u(static_cast<Eigen::Index>(readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    u(static_cast<Eigen::Index>(i)) = readings[i].u;
  }
  return u;
}

std::vector<HalfTurn> choose(const HalfTurnPlan& plan, const std::vector<HalfTurn>& candidates,
                             const std::vector<SymmetricReading>& readings,
                             const Monitor& monitor) {
  const HalfTurnWishes& wishes = plan.wishes;
  ExchangeOptions exchange;
  exchange.observations = wishes.readings;
  exchange.limits = {wishes.least_redundancy, wishes.largest_unnamed_mm};
  exchange.starts = wishes.starts;
  exchange.seed = wishes.seed;
  exchange.threads = wishes.threads;
  exchange.monitor = monitor;
  const Eigen::MatrixXd design = design_matrix(plan.arm, readings)(Eigen::all, plan.unknowns);
  const ChosenObservations chosen = choose_observations(design, uncertainties(readings), exchange);
  check_limits(chosen, wishes);
  std::vector<HalfTurn> turns;
  for (const int row : chosen.rows) turns.push_back(candidates[static_cast<std::size_t>(row)]);
  return turns;
}

std::vector<HalfTurn> in_order(const std::vector<HalfTurn>& turns, const Monitor& monitor) {
  std::vector<HalfTurn> ordered;
  for (const int place : reading_order(turns, monitor)) {
    ordered.push_back(turns[static_cast<std::size_t>(place)]);
  }
  return ordered;
}

// Leaves joints where they are; by how much a reading may lose in precision by that is `slack`.
std::vector<HalfTurn> walk(const ArmModel& arm, const HalfTurnWishes& wishes,
                           const std::vector<HalfTurn>& ordered, double slack) {
  const auto u = [&](const HalfTurn& turn) { return readings_of(arm, {turn}, wishes).front().u; };
  return walk_through(arm, wishes.room, ordered,
                      [&](const HalfTurn& tried, const HalfTurn& planned) {
                        constexpr double kRounding = 1e-9;
                        return u(tried) <= (1.0 + slack + kRounding) * u(planned);
                      });
}

void predict_result(HalfTurnPlan& plan, const std::vector<HalfTurn>& turns) {
  const ParameterTable table(plan.arm);
  const auto readings = readings_of(plan.arm, turns, plan.wishes);
  const Eigen::MatrixXd design = design_matrix(plan.arm, readings)(Eigen::all, plan.unknowns);
  const auto factor = inverse_factor(design);
  if (!factor) throw ImpossiblePlan("no choice of half turns determines all parameters");
  plan.covariance = *factor * factor->transpose();
  const Eigen::VectorXd singular =
      singular_value_decomposition(design * column_scales(design).cwiseInverse().asDiagonal())
          .values;
  plan.condition_number = singular(0) / singular(singular.size() - 1);
  plan.parameters.clear();
  for (int i = 0; i < plan.rank(); ++i) {
    const Parameter& parameter = table[plan.unknowns[static_cast<std::size_t>(i)]];
    plan.parameters.push_back(
        {parameter.name, parameter.unit == ParameterUnit::rad, std::sqrt(plan.covariance(i, i))});
  }
  const Reliability analysis = reliability(design, plan.covariance);
  plan.readings.clear();
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    plan.readings.push_back({readings[i].name, turns[i], readings[i].value, readings[i].u,
                             analysis.redundancy(place), readings[i].u * analysis.detectable(place),
                             readings[i].u * analysis.nameable(place)});
  }
  plan.joints_set = joints_moved(turns);
}

bool keeps_limits(const HalfTurnPlan& plan) {
  return plan.least_redundancy() >= plan.wishes.least_redundancy &&
         plan.largest_unnamed_mm() <= plan.wishes.largest_unnamed_mm;
}

}  // namespace

double HalfTurnPlan::least_redundancy() const {
  double least = 1.0;
  for (const PlannedReading& reading : readings) least = std::min(least, reading.redundancy);
  return least;
}

double HalfTurnPlan::largest_unnamed_mm() const {
  double largest = 0.0;
  for (const PlannedReading& reading : readings) largest = std::max(largest, reading.nameable_mm);
  return largest;
}

SymmetricPointProcedure procedure_of(const HalfTurnPlan& plan) {
  SymmetricPointProcedure procedure;
  procedure.unknowns = {"*"};
  procedure.u_encoder_rad = plan.wishes.u_encoder_rad;
  for (const PlannedReading& planned : plan.readings) {
    SymmetricReading reading;
    reading.name = planned.name;
    reading.kind = SymmetricKind::reversal;
    reading.joint = planned.turn.joint;
    reading.posture_rad = planned.turn.posture_rad;
    reading.posture_end_rad = planned.turn.posture_end_rad;
    procedure.readings.push_back(std::move(reading));
  }
  return procedure;
}

std::vector<SymmetricReading> readings_of(const ArmModel& arm, const std::vector<HalfTurn>& turns,
                                          const HalfTurnWishes& wishes) {
  std::vector<SymmetricReading> readings;
  for (const HalfTurn& turn : turns) {
    SymmetricReading reading;
    reading.name = fmt::format("h{:02}", readings.size() + 1);
    reading.kind = SymmetricKind::reversal;
    reading.joint = turn.joint;
    reading.posture_rad = turn.posture_rad;
    reading.posture_end_rad = turn.posture_end_rad;
    reading.value = predict(arm, reading).value;
    reading.u = std::hypot(wishes.u_mm, u_from_encoders(arm, reading, wishes.u_encoder_rad,
                                                        {wishes.repeats, wishes.repeats}));
    reading.reduced = true;
    readings.push_back(std::move(reading));
  }
  return readings;
}

HalfTurnPlan plan_half_turns(const ArmModel& arm, const HalfTurnWishes& wishes,
                             const Monitor& monitor) {
  check(wishes);
  HalfTurnPlan plan;
  plan.arm = arm;
  plan.wishes = wishes;
  const auto candidates = half_turn_candidates(arm, wishes.room, wishes.candidates, wishes.seed,
                                               plan.rejections, monitor);
  plan.candidates = static_cast<int>(candidates.size());
  const auto readings = readings_of(arm, candidates, wishes);
  plan.unknowns = seen_unknowns(plan, readings);
  check_counts(plan);
  const auto ordered = in_order(choose(plan, candidates, readings, monitor), monitor);
  // Joints that stay where they are change the levers of the encoders: within limits, or not at
  // all.
  constexpr double kSlack = 0.05;
  constexpr double kNoWalk = -1.0;
  for (const double slack : {kSlack, 0.0, kNoWalk}) {
    predict_result(plan, walk(arm, wishes, ordered, slack));
    if (keeps_limits(plan)) break;
  }
  plan.length_error_mm = predicted_length_error_mm(
      arm, plan.unknowns, plan.covariance, random_pairs(arm, wishes.room, kPairs, wishes.seed));
  return plan;
}

}  // namespace armcal
