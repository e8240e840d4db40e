// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// The study of docs/theory/complete_symmetric_point.md: prints its tables. Everything is seeded;
// the same command gives the same figures.
//
//   half_turn_study rank|designs|comparison|trials|gross [SEEDS]

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/planning/d_optimal_exchange.h"
#include "armcal/planning/reliability.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/half_turn_trial.h"
#include "armcal/testing/wang2016_arm.h"

namespace {

using namespace armcal;
using testing::consistent_romer;

constexpr int kCandidates = 4000;
constexpr int kPairs = 1000;
constexpr double kU_mm = 0.005;
constexpr std::uint64_t kSeed = 1;

double grid_rad(int grid_deg) { return radians_from_degrees(grid_deg); }
std::string grid_name(int grid_deg) {
  return grid_deg == 0 ? "any angle" : fmt::format("multiples of {} deg", grid_deg);
}

HalfTurnWishes distances_alone(int readings, int grid_deg) {
  HalfTurnWishes wishes;
  wishes.readings = readings;
  wishes.room.grid_rad = grid_rad(grid_deg);
  wishes.u_encoder_rad = 0.0;
  wishes.least_redundancy = 0.0;
  return wishes;
}

// --- What half turns can see
// ----------------------------------------------------------------------

void print_rank_of(const char* name, const ArmModel& arm, const std::vector<int>& joints) {
  HalfTurnWishes wishes = distances_alone(40, 0);
  wishes.room.joints = joints;
  Rejections rejections;
  const auto turns = half_turn_candidates(arm, wishes.room, 1000, kSeed, rejections);
  const auto seen = determined_parameters(arm, readings_of(arm, turns, wishes));
  fmt::print("{:<12} {:<14} {:>9} {:>5} {:>8.1f}\n", name,
             joints.empty() ? "all" : fmt::format("{}", fmt::join(joints, " ")), turns.size(),
             seen.unknowns.size(), seen.condition_number);
}

void print_rank() {
  fmt::print("arm          joints turned  half turns  rank  condition\n");
  const ArmModel romer = consistent_romer();
  for (const std::vector<int>& joints :
       std::vector<std::vector<int>>{{}, {1}, {1, 2}, {2}, {1, 3, 5}, {3, 4, 5, 6}, {5}, {6}}) {
    print_rank_of("six joints", romer, joints);
  }
  const ArmModel seven = seven_joint_arm();
  for (const std::vector<int>& joints : std::vector<std::vector<int>>{{}, {1}, {1, 3, 5, 7}}) {
    print_rank_of("seven joints", seven, joints);
  }
}

// --- Designs
// --------------------------------------------------------------------------------------

// One observation after the other, each where the unknowns are determined worst so far.
std::vector<int> greedy_choice(const Eigen::MatrixXd& design, int count) {
  const Eigen::MatrixXd scaled = design * column_scales(design).cwiseInverse().asDiagonal();
  constexpr double kTrace = 1e-6;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(design.cols(), design.cols()) / kTrace;
  Eigen::VectorXd variance = scaled.rowwise().squaredNorm() / kTrace;
  std::vector<int> rows;
  while (static_cast<int>(rows.size()) < count) {
    Eigen::Index next = 0;
    for (const int row : rows) variance(row) = -1.0;
    variance.maxCoeff(&next);
    rows.push_back(static_cast<int>(next));
    const Eigen::VectorXd way = covariance * scaled.row(next).transpose();
    const double divisor = 1.0 + scaled.row(next).dot(way);
    variance.array() -= (scaled * way).array().square() / divisor;
    covariance -= way * way.transpose() / divisor;
  }
  return rows;
}

struct Figures {
  double length_error_um = 0.0;
  double least_redundancy = 0.0;
};

Figures greedy_figures(const ArmModel& arm, const HalfTurnWishes& wishes) {
  Rejections rejections;
  const auto turns = half_turn_candidates(arm, wishes.room, kCandidates, wishes.seed, rejections);
  const auto readings = readings_of(arm, turns, wishes);
  const auto unknowns = determined_parameters(arm, readings).unknowns;
  const Eigen::MatrixXd design = design_matrix(arm, readings)(Eigen::all, unknowns);
  const Eigen::MatrixXd chosen = design(greedy_choice(design, wishes.readings), Eigen::all);
  const auto factor = inverse_factor(chosen);
  const Eigen::MatrixXd covariance = *factor * factor->transpose();
  const auto pairs = random_pairs(arm, {}, kPairs, kSeed);
  return {1e3 * predicted_length_error_mm(arm, unknowns, covariance, pairs),
          reliability(chosen, covariance).redundancy.minCoeff()};
}

void print_designs() {
  fmt::print(
      "predicted rms length error in um / smallest redundancy number, distances of 5 um, exact "
      "encoders\n{:<20} {:<9}",
      "postures", "choice");
  const std::vector<int> counts = {24, 30, 40, 60};
  for (const int count : counts) fmt::print(" {:>12}", fmt::format("{} readings", count));
  fmt::print("\n");
  for (const int grid : {90, 45, 0}) {
    std::string greedy = fmt::format("{:<20} {:<9}", grid_name(grid), "greedy");
    std::string exchange = fmt::format("{:<20} {:<9}", grid_name(grid), "exchange");
    for (const int count : counts) {
      const HalfTurnWishes wishes = distances_alone(count, grid);
      const Figures first = greedy_figures(consistent_romer(), wishes);
      const HalfTurnPlan plan = plan_half_turns(consistent_romer(), wishes);
      const auto cell = [](double um, double redundancy) {
        return fmt::format(" {:>12}", fmt::format("{:.2f} / {:.2f}", um, redundancy));
      };
      greedy += cell(first.length_error_um, first.least_redundancy);
      exchange += cell(1e3 * plan.length_error_mm, plan.least_redundancy());
    }
    fmt::print("{}\n{}\n", greedy, exchange);
  }
}

// --- Against other ways
// ---------------------------------------------------------------------------

// Predicted rms length error of points in the unknown frame of a reference machine, 5 um per
// coordinate, at random postures.
double reference_points_um(const ArmModel& arm, const std::vector<int>& unknowns, int points,
                           std::uint64_t seed) {
  const ForwardKinematics kinematics(arm);
  const auto pairs = random_pairs(arm, {}, (points + 1) / 2, seed);
  const auto p = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd design(3 * points, p + 6);
  for (int i = 0; i < points; ++i) {
    const PosturePair& pair = pairs[static_cast<std::size_t>(i / 2)];
    const Eigen::VectorXd& posture = i % 2 == 0 ? pair.first_rad : pair.second_rad;
    const TipLinearisation at = kinematics.linearise(as_span(posture));
    design.block(3 * i, 0, 3, p) = at.J_tip_parameters(Eigen::all, unknowns);
    design.block(3 * i, p, 3, 3).setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      design.block(3 * i, p + 3 + axis, 3, 1) = Eigen::Vector3d::Unit(axis).cross(at.tip_mm);
    }
  }
  const auto factor = inverse_factor(design / kU_mm);
  if (!factor) return std::nan("");
  const Eigen::MatrixXd covariance = (*factor * factor->transpose()).topLeftCorner(p, p);
  return 1e3 *
         predicted_length_error_mm(arm, unknowns, covariance, random_pairs(arm, {}, kPairs, kSeed));
}

void print_reference_points(const ArmModel& arm, const std::vector<int>& unknowns) {
  constexpr int kSets = 100;
  for (const int points : {30, 60}) {
    std::vector<double> um;
    for (int set = 0; set < kSets; ++set) {
      um.push_back(
          reference_points_um(arm, unknowns, points, static_cast<std::uint64_t>(100 + set)));
    }
    std::sort(um.begin(), um.end());
    fmt::print(
        "{} reference points, 5 um per coordinate, random postures: {:.1f} um (median of {} "
        "sets; best {:.1f}, worst {:.1f})\n",
        points, um[um.size() / 2], kSets, um.front(), um.back());
  }
}

struct ArmErrors {
  double nominal = 0.0, chain = 0.0, adjusted = 0.0, complete = 0.0;  // sums of squares, mm^2
};

// The paper's procedure on a built arm, with the same machine, beside the complete one.
void add_trial(const HalfTurnPlan& plan, std::uint64_t seed, const std::vector<PosturePair>& pairs,
               ArmErrors& sums) {
  const auto square = [](double value) { return value * value; };
  const auto complete = testing::carry_out_plan(plan, seed);
  ErrorSources errors;
  errors.encoder_noise.u_rad = radians_from_arcseconds(2.0);
  Laboratory laboratory(VirtualArm(plan.arm, complete.truth, errors, seed), seed);
  testing::HalfTurnTrial paper;
  paper.truth = complete.truth;
  SymmetricPractice practice;
  practice.u_point_mm = kU_mm * std::sqrt(2.5);
  practice.u_slip_rad = radians_from_arcseconds(5.0);
  practice.u_half_turn_rad = radians_from_degrees(1.0);
  paper.procedure = carry_out(laboratory, wang2016_procedure(), practice);
  const auto of_paper = testing::analysed(paper, plan.arm);
  sums.nominal += square(length_error_mm(plan.arm, complete.truth, pairs));
  if (of_paper.chain && of_paper.chain->complete) {
    sums.chain += square(length_error_mm(of_paper.chain->arm, complete.truth, pairs));
  }
  sums.adjusted += square(length_error_mm(of_paper.adjustment.arm, complete.truth, pairs));
  sums.complete += square(
      length_error_mm(testing::analysed(complete, plan.arm).adjustment.arm, complete.truth, pairs));
}

void print_paper(const ArmModel& arm) {
  auto readings = testing::wang2016_readings();
  const auto seen = determined_parameters(arm, readings);
  const ParameterTable table(arm);
  std::vector<std::string> names;
  for (const int unknown : seen.unknowns) names.push_back(table[unknown].name);
  fmt::print("the paper's six readings: rank {} of 21 ({})\n", seen.unknowns.size(),
             fmt::join(names, ", "));
}

void print_comparison(int seeds) {
  const ArmModel arm = consistent_romer();
  const HalfTurnPlan plan = plan_half_turns(arm, distances_alone(40, 45));
  fmt::print("40 half turns, multiples of 45 deg, distances of 5 um: {:.1f} um\n",
             1e3 * plan.length_error_mm);
  print_reference_points(arm, plan.unknowns);
  print_paper(arm);
  HalfTurnWishes wishes;
  const HalfTurnPlan real = plan_half_turns(arm, wishes);
  const auto pairs = random_pairs(arm, {}, kPairs, kSeed + 1);
  ArmErrors sums;
  for (int seed = 1; seed <= seeds; ++seed) {
    add_trial(real, static_cast<std::uint64_t>(seed), pairs, sums);
  }
  const auto rms = [&](double sum) { return std::sqrt(sum / seeds); };
  fmt::print("rms length error on unseen postures, {} built arms, mm\n", seeds);
  fmt::print("  nominal arm                         {:.4f}\n", rms(sums.nominal));
  fmt::print("  the paper's chain                   {:.4f}\n", rms(sums.chain));
  fmt::print("  its readings adjusted together      {:.4f}\n", rms(sums.adjusted));
  fmt::print("  complete calibration, 40 half turns {:.4f}\n", rms(sums.complete));
}

// --- Carried out
// ----------------------------------------------------------------------------------

void print_trials_of(const char* name, const ArmModel& arm, const HalfTurnWishes& wishes,
                     int seeds) {
  const HalfTurnPlan plan = plan_half_turns(arm, wishes);
  const auto pairs = random_pairs(arm, wishes.room, kPairs, kSeed + 1);
  std::vector<double> ratios;
  double squares = 0.0;
  double chi_squared = 0.0;
  int freedom = 0;
  int flagged = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto trial = testing::carry_out_plan(plan, static_cast<std::uint64_t>(seed));
    const auto analysis = testing::analysed(trial, arm);
    const double error = length_error_mm(analysis.adjustment.arm, trial.truth, pairs);
    ratios.push_back(error / plan.length_error_mm);
    squares += ratios.back() * ratios.back();
    chi_squared += analysis.adjustment.chi_squared;
    freedom += analysis.adjustment.degrees_of_freedom;
    for (const AdjustedReading& reading : analysis.adjustment.readings) flagged += reading.flagged;
  }
  std::sort(ratios.begin(), ratios.end());
  const auto count = static_cast<double>(seeds);
  fmt::print("{:<12} {:<19} {:>8} {:>9.2f} {:>7.3f} {:>7.2f} {:>7.2f} {:>8.3f} {:>11.2f}\n", name,
             grid_name(static_cast<int>(std::lround(degrees_from_radians(wishes.room.grid_rad)))),
             wishes.readings, 1e3 * plan.length_error_mm, std::sqrt(squares / count),
             ratios[ratios.size() / 2], ratios[ratios.size() * 95 / 100], chi_squared / freedom,
             100.0 * flagged / (count * wishes.readings));
}

void print_trials(int seeds) {
  fmt::print("{} built arms each: length error on unseen postures over the predicted one\n", seeds);
  fmt::print(
      "arm          postures            readings  predicted    rms  median    95 %  chi2/dof "
      " flagged in %\n");
  for (const int grid : {90, 45, 0}) {
    for (const int readings : {30, 40, 60}) {
      HalfTurnWishes wishes;
      wishes.readings = readings;
      wishes.room.grid_rad = grid_rad(grid);
      print_trials_of("six joints", consistent_romer(), wishes, seeds);
    }
  }
  HalfTurnWishes wishes;
  wishes.readings = 50;
  print_trials_of("seven joints", seven_joint_arm(), wishes, seeds);
}

// --- Gross errors
// ---------------------------------------------------------------------------------

void print_gross_of(const HalfTurnPlan& plan, double error_mm, int seeds) {
  int total = 0;
  int found = 0;
  int named = 0;
  int named_alone = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto clean = testing::carry_out_plan(plan, static_cast<std::uint64_t>(5000 + seed));
    for (std::size_t i = 0; i < plan.readings.size(); ++i) {
      auto wrong = clean;
      testing::falsify(wrong.procedure.readings[i], seed % 2 == 0 ? error_mm : -error_mm);
      const auto& readings = testing::analysed(wrong, plan.arm).adjustment.readings;
      const auto flags = std::count_if(readings.begin(), readings.end(),
                                       [](const AdjustedReading& each) { return each.flagged; });
      ++total;
      found += flags > 0;
      named += readings[i].flagged;
      named_alone += readings[i].flagged && flags == 1;
    }
  }
  const auto share = [&](int count) { return 100.0 * count / total; };
  fmt::print("{:>8} {:>14.3f} {:>9.3f} {:>6} {:>9.2f} {:>9.2f} {:>9.2f}\n", plan.readings.size(),
             plan.largest_unnamed_mm(), error_mm, total, share(found), share(named),
             share(named_alone));
}

void print_gross(int seeds) {
  fmt::print(
      "a gross error in every single reading, {} built arms each; multiples of 45 deg\n"
      "readings  named by plan  error mm  tried   found %   named %   alone %\n",
      seeds);
  for (const int readings : {30, 40, 60}) {
    HalfTurnWishes wishes;
    wishes.readings = readings;
    if (readings >= 40) wishes.largest_unnamed_mm = 0.1;
    const HalfTurnPlan plan = plan_half_turns(consistent_romer(), wishes);
    for (const double error_mm : {0.05, 0.1}) print_gross_of(plan, error_mm, seeds);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::string part = count > 1 ? arguments[1] : "";
  const int seeds = count > 2 ? std::atoi(arguments[2]) : 200;
  if (part == "rank") {
    print_rank();
  } else if (part == "designs") {
    print_designs();
  } else if (part == "comparison" && seeds > 0) {
    print_comparison(seeds);
  } else if (part == "trials" && seeds > 0) {
    print_trials(seeds);
  } else if (part == "gross" && seeds > 0) {
    print_gross(seeds);
  } else {
    fmt::print(stderr, "half_turn_study rank|designs|comparison|trials|gross [SEEDS]\n");
    return 2;
  }
  return 0;
}
