// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/io/arm_file.h"
#include "armcal/report/calibration_report.h"
#include "armcal/workflow/calibration_job.h"

namespace armcal::cli {
namespace {

struct CalibrateFlags {
  std::string session;
  std::optional<std::string> output;
  std::optional<std::string> save;
  bool allow_rank_deficient = false;
};

int run_calibrate(const CalibrateFlags& flags, const Context& context) {
  for (const auto& path : {flags.output, flags.save}) {
    if (path) check_may_write(*path, context.overwrite);
  }
  InputFiles files(context.monitor);
  LoadedSession loaded = load_session(files, flags.session);
  loaded.options.allow_rank_deficient = flags.allow_rank_deficient;
  const Calibration calibration = run_calibration(loaded);
  const Json json = json_result(calibration, loaded.groups, loaded.session.estimate);
  if (flags.output) {
    ArmModel arm = calibration.arm;
    arm.note = fmt::format("Identified from {} by armcal calibrate.", flags.session);
    context.save(*flags.output, arm_text(arm), files.records());
  }
  if (flags.save) {
    context.save(*flags.save,
                 context.document(files.records(), files.diagnostics(), json,
                                  loaded.session.estimate.check_seed),
                 files.records());
  }
  context.emit(files.records(), files.diagnostics(), json, text_result(calibration));
  return kDone;
}

}  // namespace

Command calibrate_command() {
  const auto flags = std::make_shared<CalibrateFlags>();
  Command command;
  command.name = "calibrate";
  command.brief = "least-squares identification of an arm from any mixture of references";
  command.description =
      "Reads a session (*.session.toml): an arm, tables of readings, and what each is held against "
      "- points of a\n"
      "reference machine, cones and seats, artefacts, lengths, half turns, spheres, planes. "
      "Estimates everything that\n"
      "the readings can determine, with standard uncertainties, and says what they cannot see.";
  command.arguments = {
      {"SESSION", "session file (*.session.toml)", &flags->session},
      {"-o,--output", "write the calibrated arm file here", &flags->output, "ARM"},
      {"--save", "write the calibration (JSON, with covariance) here, for predict and diff",
       &flags->save, "FILE"},
      {"--allow-rank-deficient",
       "where no reading knows how long a millimetre is, hold the longest length",
       &flags->allow_rank_deficient}};
  command.examples = {"armcal calibrate examples/calibration/tracker.session.toml",
                      "armcal calibrate examples/calibration/tracker.session.toml -o my.arm.toml "
                      "--save my.calibration.json"};
  command.run = [flags](const Context& context) { return run_calibrate(*flags, context); };
  return command;
}

}  // namespace armcal::cli
