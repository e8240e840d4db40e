// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/calibration_job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "armcal/core/spelling.h"
#include "armcal/io/observation_tables.h"
#include "armcal/observations/check_split.h"

namespace armcal {
namespace {

// Joints that stand still leave their zeros, and more, to chance.
void check_movement(const std::vector<ObservationGroup>& groups, const Session& session,
                    int joint_count, Diagnostics& diagnostics) {
  constexpr double kStill_rad = 1e-6;
  Eigen::VectorXd low = Eigen::VectorXd::Constant(joint_count, 1e300);
  Eigen::VectorXd high = -low;
  for (const ObservationGroup& group : groups) {
    for (const Eigen::MatrixXd* angles : {&group.encoder_rad, &group.encoder_end_rad}) {
      if (angles->cols() == 0) continue;
      low = low.cwiseMin(angles->rowwise().minCoeff());
      high = high.cwiseMax(angles->rowwise().maxCoeff());
    }
  }
  std::vector<int> still;
  for (int joint = 0; joint < joint_count; ++joint) {
    if (high(joint) - low(joint) < kStill_rad) still.push_back(joint + 1);
  }
  if (still.empty()) return;
  const bool all = static_cast<int>(still.size()) == joint_count;
  diagnostics.error(
      {session.file, 0, 0},
      all ? std::string("no joint moves in any reading")
          : fmt::format("joint{} {} never move{} in any reading", still.size() > 1 ? "s" : "",
                        fmt::join(still, ", "), still.size() > 1 ? "" : "s"),
      all ? "are the angles in the right columns?"
          : "move every joint, or describe the arm without the joints that stand still");
}

}  // namespace

CalibrationOptions calibration_options(const SessionEstimate& estimate) {
  CalibrationOptions options;
  options.hold = estimate.hold;
  options.harmonics = estimate.harmonics;
  options.prior_length_mm = estimate.prior_length_mm;
  options.prior_zero_rad = estimate.prior_zero_rad;
  options.prior_twist_rad = estimate.prior_twist_rad;
  options.prior_harmonic_rad = estimate.prior_harmonic_rad;
  options.prior_of = estimate.prior_of;
  if (estimate.loss == "huber") options.loss = RobustLoss::huber;
  if (estimate.loss == "cauchy") options.loss = RobustLoss::cauchy;
  return options;
}

void check_estimate(const SessionEstimate& estimate, const std::string& file, const ArmModel& arm,
                    Diagnostics& diagnostics) {
  const ParameterTable table(with_harmonics(arm, estimate.harmonics));
  for (const std::string& pattern : estimate.hold) {
    if (!table.matching(pattern).empty()) continue;
    diagnostics.error({file, 0, 0}, fmt::format("hold: no parameter matches \"{}\"", pattern),
                      did_you_mean(pattern, table.names()));
  }
  for (const auto& [name, u] : estimate.prior_of) {
    if (table.find(name)) continue;
    diagnostics.error({file, 0, 0}, fmt::format("prior: no parameter is called \"{}\"", name),
                      did_you_mean(name, table.names()));
  }
}

LoadedSession load_session(InputFiles& files, const std::string& path) {
  const auto text = files.text(path, kLargestConfiguration_bytes);
  files.require_good();
  auto session = read_session_file(*text, files.diagnostics());
  files.require_good();
  const auto arm = files.arm(session->arm_file);
  files.require_good();
  check_estimate(session->estimate, path, *arm, files.diagnostics());
  LoadedSession loaded{std::move(*session), *arm, {}, {}};
  for (const SessionGroup& group : loaded.session.groups) {
    const auto table = group.file.empty() ? std::nullopt : files.table(group.file, group.table);
    const auto artefact =
        group.artefact_file.empty() ? std::nullopt : files.table(group.artefact_file, {});
    const bool read = (group.file.empty() || table) && (group.artefact_file.empty() || artefact);
    if (!read) continue;
    auto readings =
        observation_group(group, table ? &*table : nullptr, artefact ? &*artefact : nullptr,
                          arm->joint_count(), files.diagnostics());
    if (readings) loaded.groups.push_back(std::move(*readings));
  }
  files.require_good();
  check_movement(loaded.groups, loaded.session, arm->joint_count(), files.diagnostics());
  files.require_good();
  hold_out(loaded.groups, loaded.session.estimate.check_fraction,
           loaded.session.estimate.check_seed);
  loaded.options = calibration_options(loaded.session.estimate);
  loaded.options.monitor = files.monitor();
  return loaded;
}

Calibration look_at_session(const LoadedSession& loaded) {
  Calibration look = identifiability(loaded.arm, loaded.groups, loaded.options);
  if (look.ok()) return look;
  throw NumericalError(fmt::format("{}: {}", loaded.session.file,
                                   look.detail.empty() ? explain(look.status) : look.detail));
}

Calibration run_calibration(const LoadedSession& loaded) {
  Calibration calibration = calibrate(loaded.arm, loaded.groups, loaded.options);
  if (calibration.ok()) return calibration;
  std::string reason(explain(calibration.status));
  if (!calibration.detail.empty()) reason = calibration.detail;
  if (calibration.status == CalibrationStatus::no_convergence) {
    reason += fmt::format(" ({})", to_string(calibration.termination));
  }
  if (calibration.status == CalibrationStatus::scale_unknown) {
    reason +=
        "; add a calibrated length or a prior, or hold one length with --allow-rank-deficient";
  }
  throw NumericalError(fmt::format("{}: {}", loaded.session.file, reason));
}

}  // namespace armcal
