// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "armcal/geometry/registration.h"
#include "armcal/io/symmetric_point_file.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/observations/empty_group.h"
#include "armcal/workflow/calibration_job.h"
#include "armcal/workflow/enough_readings.h"

namespace armcal {
namespace {

constexpr int kCheckMeasurement = 0;  // those of the scenario count from 1
constexpr int kPostures = 200;        // over which tips of arms are compared

class Simulator {
 public:
  Simulator(const LoadedScenario& loaded, std::uint64_t seed)
      : loaded_(loaded), scenario_(loaded.scenario), laboratory_(arm_of(loaded, seed), seed) {
    laboratory_.seconds_per_reading = scenario_.seconds_per_reading;
    result_.seed = seed;
    result_.nominal = laboratory_.arm().nominal();
    result_.truth = laboratory_.arm().truth();
  }

  Simulation run(const Monitor& monitor) {
    check_estimate(scenario_.estimate, scenario_.file, loaded_.nominal, diagnostics_);
    for (std::size_t i = 0; i < scenario_.measurements.size(); ++i) {
      const PlannedMeasurement& planned = scenario_.measurements[i];
      monitor.report("measuring " + name_of(planned.measurement),
                     static_cast<double>(i) / static_cast<double>(scenario_.measurements.size()));
      laboratory_.begin(static_cast<int>(i) + 1);
      attempt(planned);
    }
    laboratory_.begin(kCheckMeasurement);
    attempt_check();
    require_good();
    tell_encoder_noise();
    put_on_platform();
    check_count();
    require_good();
    return std::move(result_);
  }

 private:
  static VirtualArm arm_of(const LoadedScenario& loaded, std::uint64_t seed) {
    const SimulationScenario& scenario = loaded.scenario;
    if (loaded.truth) {
      return {loaded.nominal, *loaded.truth, scenario.errors, seed, scenario.surroundings};
    }
    return {loaded.nominal, scenario.errors, seed, scenario.surroundings};
  }

  void require_good() const {
    if (diagnostics_.has_errors()) throw InputError(diagnostics_);
  }

  void attempt(const PlannedMeasurement& planned) {
    try {
      std::visit([&](const auto& options) { take(options, planned.where); }, planned.measurement);
    } catch (const Impossible& reason) {
      diagnostics_.error(planned.where, reason.what());
    }
  }

  template <class Options>
  void take(const Options& options, const SourcePosition& where) {
    if constexpr (requires { options.joints; }) {
      for (const int joint : options.joints) {
        if (joint <= loaded_.nominal.joint_count()) continue;
        diagnostics_.error(where, fmt::format("joint {} of an arm with {} joints", joint,
                                              loaded_.nominal.joint_count()));
        return;
      }
    }
    for (ObservationGroup& group : measure(laboratory_, options)) {
      result_.groups.push_back(std::move(group));
    }
  }

  void take(const SymmetricPoint& options, const SourcePosition& where) {
    SymmetricPointProcedure plan = loaded_.plans.at(options.name);
    for (SymmetricReading& reading : plan.readings) {
      if (reading.where.file.empty()) reading.where = where;
    }
    if (!check_against_arm(plan, loaded_.nominal, diagnostics_)) return;
    result_.procedures.push_back({options.name, carry_out(laboratory_, plan, options.practice)});
  }

  // Also where nothing is to be checked: the floor is known from the same postures.
  void attempt_check() {
    const int count = scenario_.check ? scenario_.check->points : kPostures;
    const double u_mm = scenario_.check ? scenario_.check->u_mm : 0.0;
    ObservationGroup check = empty_group(ReferenceKind::reference_points, "check", count,
                                         result_.truth.joint_count(), u_mm);
    check.is_check.assign(check.is_check.size(), true);
    check.place.assign(check.is_check.size(), "check");
    check.reference_mm.resize(3, count);
    std::vector<Eigen::VectorXd> postures;
    std::vector<Eigen::Vector3d> tips_mm;
    try {
      for (Eigen::Index i = 0; i < count; ++i) {
        postures.push_back(laboratory_.free_posture());
        const TakenReading taken = laboratory_.take(postures.back());
        tips_mm.push_back(taken.tip_mm);
        check.encoder_rad.col(i) = taken.encoder_rad;
        check.reference_mm.col(i) = taken.tip_mm + laboratory_.noise(u_mm);
      }
    } catch (const Impossible& reason) {
      diagnostics_.error(scenario_.check ? scenario_.check->where : whole_file(), reason.what());
      return;
    }
    if (scenario_.check) result_.check = std::move(check);
    result_.floor_mm = floor_mm(postures);
    result_.drawing_error_mm = drawing_error_mm(postures, tips_mm);
  }

  [[nodiscard]] double u_encoder_rad() const {
    return scenario_.errors.encoder_noise.u_reading_rad();
  }

  void tell_encoder_noise() {
    for (ObservationGroup& group : result_.groups) {
      if (group.encoder_rad.cols() > 0) group.u_encoder_rad = u_encoder_rad();
    }
    if (result_.check) result_.check->u_encoder_rad = u_encoder_rad();
  }

  [[nodiscard]] double floor_mm(const std::vector<Eigen::VectorXd>& postures) const {
    const ForwardKinematics kinematics(result_.truth);
    double sum_mm2 = 0.0;
    for (const Eigen::VectorXd& posture : postures) {
      sum_mm2 += kinematics.linearise(as_span(posture)).J_tip_encoder.squaredNorm();
    }
    return u_encoder_rad() * std::sqrt(sum_mm2 / static_cast<double>(postures.size()));
  }

  [[nodiscard]] double drawing_error_mm(const std::vector<Eigen::VectorXd>& postures,
                                        const std::vector<Eigen::Vector3d>& tips_mm) const {
    const ForwardKinematics drawing(result_.nominal);
    std::vector<Eigen::Vector3d> drawn_mm;
    for (const Eigen::VectorXd& posture : postures) {
      drawn_mm.push_back(drawing.tip_in_base(as_span(posture)));
    }
    return register_points(drawn_mm, tips_mm).rms_mm;
  }

  [[nodiscard]] SourcePosition whole_file() const { return {scenario_.file, 0, 0}; }

  // What was measured without turning the platform was measured at index 0.
  void put_on_platform() {
    for (const PlannedMeasurement& planned : scenario_.measurements) {
      const auto* platform = std::get_if<IndexedPlatform>(&planned.measurement);
      if (platform == nullptr) continue;
      result_.nominal = on_platform(result_.nominal, *platform);
      result_.truth = on_platform(result_.truth, *platform);
      for (ObservationGroup& group : result_.groups) lift(group);
      if (result_.check) lift(*result_.check);
    }
  }

  void lift(ObservationGroup& group) const {
    const int joint_count = result_.truth.joint_count();
    if (group.encoder_rad.rows() == joint_count) return;  // read with the platform
    for (int& joint : group.joint) ++joint;
    for (Eigen::MatrixXd* angles : {&group.encoder_rad, &group.encoder_end_rad}) {
      if (angles->cols() == 0) continue;
      Eigen::MatrixXd lifted = Eigen::MatrixXd::Zero(joint_count, angles->cols());
      lifted.bottomRows(angles->rows()) = *angles;
      *angles = std::move(lifted);
    }
  }

  void check_count() {
    const auto problem =
        too_few_readings(result_.groups, result_.nominal, calibration_options(scenario_.estimate));
    if (!problem) return;
    diagnostics_.error(whole_file(), *problem,
                       "measure more, or hold parameters: [estimate] hold = [\"..\"]");
  }

  const LoadedScenario& loaded_;
  const SimulationScenario& scenario_;
  Laboratory laboratory_;
  Diagnostics diagnostics_;
  Simulation result_;
};

}  // namespace

Simulation simulate(const LoadedScenario& loaded, std::uint64_t seed, const Monitor& monitor) {
  return Simulator(loaded, seed).run(monitor);
}

}  // namespace armcal
