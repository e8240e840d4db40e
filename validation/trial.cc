// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "trial.h"

#include <cmath>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/random.h"
#include "estimate.h"

namespace armcal::validation {
namespace {

constexpr int kPredictedTips = 4;
constexpr int kHeldOutPoints = 20;
constexpr std::uint64_t kPilot = 1'000'000;  // streams of the plan, after those of trials

// Harmonics that eccentric scales have.
int harmonics_of(const Scenario& scenario) { return scenario.eccentricity.is_on() ? 2 : 0; }

// The nominal arm with errors of the usual size in the chosen parameters.
ArmModel true_arm(const Scenario& scenario, const ArmModel& drawing, const std::vector<int>& free,
                  RandomStream& random) {
  const ParameterTable table(drawing);
  const ArmModel built = drawn_arm(drawing, GeometryErrors::typical(), random);
  const Eigen::VectorXd drawn =
      parameter_values(with_eccentric_scales(built, scenario.eccentricity, random));
  Eigen::VectorXd values = table.nominal();
  for (const int index : free) values(index) = drawn(index);
  return with_parameter_values(drawing, values);
}

Laboratory laboratory_of(const Scenario& scenario, const ArmModel& truth, std::uint64_t seed) {
  ErrorSources errors;
  errors.encoder_noise.u_rad = scenario.u_encoder_rad;
  return Laboratory(VirtualArm(scenario.nominal, truth, errors, seed), seed);
}

std::vector<ObservationGroup> readings(const Plan& plan, Laboratory& laboratory) {
  auto groups = plan.scenario->measure(laboratory);
  for (ObservationGroup& group : groups) {
    group.u_mm /= plan.noise_factor;
    group.u_encoder_rad = plan.scenario->u_encoder_rad / plan.noise_factor;
  }
  return groups;
}

std::span<const double> span_of(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

void compare_parameters(const Plan& plan, const Estimate& estimated, const ArmModel& truth,
                        Trial& trial) {
  const Eigen::VectorXd difference = parameter_values(estimated.arm) - parameter_values(truth);
  for (std::size_t i = 0; i < plan.free.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    trial.error.push_back(difference(plan.free[i]));
    trial.u.push_back(std::sqrt(estimated.covariance(place, place)));
  }
}

void compare_tips(const Plan& plan, const Estimate& estimated, const ArmModel& truth,
                  Trial& trial) {
  const ForwardKinematics calibrated(estimated.arm);
  const ForwardKinematics real(truth);
  for (const auto& column : plan.postures_rad.colwise()) {
    const Eigen::VectorXd posture = column;
    const Eigen::Vector3d error =
        calibrated.tip_in_base(span_of(posture)) - real.tip_in_base(span_of(posture));
    const Eigen::Matrix3d covariance =
        tip_covariance(estimated.arm, estimated.free, estimated.covariance, span_of(posture));
    for (Eigen::Index c = 0; c < 3; ++c) {
      trial.error.push_back(error(c));
      trial.u.push_back(std::sqrt(covariance(c, c)));
    }
  }
}

void measure_held_out_points(const Scenario& scenario, const Estimate& estimated,
                             Laboratory& laboratory, Trial& trial) {
  const ForwardKinematics calibrated(estimated.arm);
  const ForwardKinematics real(laboratory.arm().truth());
  laboratory.begin(1);
  for (int i = 0; i < kHeldOutPoints; ++i) {
    const TakenReading taken = laboratory.take(laboratory.free_posture());
    const Eigen::Vector3d reference = taken.tip_mm + laboratory.noise(scenario.u_held_out_mm);
    const auto shown = span_of(taken.encoder_rad);
    trial.squares_mm2 += (calibrated.tip_in_base(shown) - reference).squaredNorm();
    trial.squares_floor_mm2 += (real.tip_in_base(shown) - reference).squaredNorm();
  }
}

}  // namespace

Plan plan_of(const Scenario& scenario, std::uint64_t seed, double noise_factor) {
  Plan plan{.scenario = &scenario, .seed = seed, .noise_factor = noise_factor};
  plan.drawing = with_harmonics(scenario.nominal, harmonics_of(scenario));
  const ParameterTable table(plan.drawing);
  std::vector<int> everything;
  for (int i = 0; i < table.size(); ++i) everything.push_back(i);
  RandomStream random(seed, kPilot);
  Laboratory pilot =
      laboratory_of(scenario, true_arm(scenario, plan.drawing, everything, random), random.bits());
  Scenario complete = scenario;
  complete.options.harmonics = harmonics_of(scenario);
  const Estimate estimated = estimate(complete, readings(plan, pilot));
  if (!estimated.ok) throw std::runtime_error(scenario.name + ": " + estimated.problem);
  plan.free = estimated.free;
  plan.postures_rad.resize(scenario.nominal.joint_count(), kPredictedTips);
  for (int i = 0; i < kPredictedTips; ++i) plan.postures_rad.col(i) = pilot.free_posture();
  for (const int index : plan.free) plan.names.push_back(table[index].name);
  plan.parameter_count = plan.names.size();
  for (int i = 0; i < kPredictedTips; ++i) {
    for (const char axis : {'x', 'y', 'z'}) {
      plan.names.push_back("tip " + std::to_string(i + 1) + ' ' + axis);
    }
  }
  return plan;
}

Trial run_trial(const Plan& plan, int number) {
  RandomStream random(plan.seed, static_cast<std::uint64_t>(number));
  const Scenario& scenario = *plan.scenario;
  const ArmModel truth = true_arm(scenario, plan.drawing, plan.free, random);
  Laboratory laboratory = laboratory_of(scenario, truth, random.bits());
  Trial trial;
  const Estimate estimated = estimate(scenario, readings(plan, laboratory));
  if (!estimated.ok) {
    trial.problem = estimated.problem;
    return trial;
  }
  trial.chi_squared = estimated.chi_squared;
  trial.degrees_of_freedom = estimated.degrees_of_freedom;
  trial.says_scatter = estimated.says_scatter;
  measure_held_out_points(scenario, estimated, laboratory, trial);
  if (!scenario.model_is_complete) return trial;
  trial.same_unknowns = estimated.free == plan.free;
  if (!trial.same_unknowns) return trial;
  compare_parameters(plan, estimated, truth, trial);
  compare_tips(plan, estimated, truth, trial);
  return trial;
}

}  // namespace armcal::validation
