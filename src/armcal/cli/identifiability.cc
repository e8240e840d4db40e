// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/report/calibration_report.h"
#include "armcal/workflow/calibration_job.h"

namespace armcal::cli {
namespace {

int run_identifiability(const std::string& session, const Context& context) {
  InputFiles files(context.monitor);
  const Calibration look = look_at_session(load_session(files, session));
  context.emit(files.records(), files.diagnostics(), json_of_identifiability(look),
               text_of_identifiability(look));
  return kDone;
}

}  // namespace

Command identifiability_command() {
  const auto session = std::make_shared<std::string>();
  Command command;
  command.name = "identifiability";
  command.brief = "what a session can determine, and what it cannot see";
  command.description =
      "Rank, condition number and unseen directions of a session at its nominal arm, and the "
      "standard uncertainty that\n"
      "each parameter would have by the stated ones of the readings. Nothing is fitted.";
  command.arguments = {{"SESSION", "session file (*.session.toml)", session.get()}};
  command.examples = {"armcal identifiability examples/calibration/seats.session.toml"};
  command.run = [session](const Context& context) {
    return run_identifiability(*session, context);
  };
  return command;
}

}  // namespace armcal::cli
