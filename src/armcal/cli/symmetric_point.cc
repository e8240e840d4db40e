// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/io/arm_file.h"
#include "armcal/report/symmetric_point_report.h"
#include "armcal/workflow/symmetric_point_job.h"

namespace armcal::cli {
namespace {

struct SymmetricPointFlags {
  std::string readings;
  std::optional<std::string> compare;
  std::optional<std::string> output;
  TableFlags table;
};

int run_symmetric_point_command(const SymmetricPointFlags& flags, const Context& context) {
  if (flags.output) check_may_write(*flags.output, context.overwrite);
  InputFiles files(context.monitor);
  const auto analysis =
      run_symmetric_point(files, flags.readings, flags.compare, flags.table.options());
  if (flags.output) {
    ArmModel arm = analysis.adjustment.arm;
    arm.note = fmt::format("Adjusted from {} by armcal symmetric-point.", flags.readings);
    context.save(*flags.output, arm_text(arm), files.records());
  }
  context.emit(files.records(), files.diagnostics(), json_result(analysis), text_result(analysis));
  return analysis.is_consistent() ? kDone : kDoesNotConform;
}

}  // namespace

Command symmetric_point_command() {
  const auto flags = std::make_shared<SymmetricPointFlags>();
  Command command;
  command.name = "symmetric-point";
  command.brief = "calibrate an arm from half turns: chain, adjustment, consistency, leakage";
  command.description =
      "Reads a procedure (*.symmetric.toml): distances between the tip's places before and after "
      "half turns of locked\n"
      "joints, circle radii and zero searches, reduced or as raw points. Solves the chain of "
      "equations, adjusts all\n"
      "readings together, tests each against the others, holds published results (claims) against "
      "them, and shows how\n"
      "errors of what is assumed leak into the result. Exit code 1 where readings or claims "
      "contradict each other.";
  command.arguments = joined(
      {{"READINGS", "procedure file (*.symmetric.toml)", &flags->readings},
       {"--compare", "hold the lengths of this arm against the readings", &flags->compare, "ARM"},
       {"-o,--output", "write the adjusted arm file here", &flags->output, "FILE"}},
      joined(flags->table.for_angles(), flags->table.for_suspects()));
  command.examples = {"armcal symmetric-point examples/wang2016/as-printed.symmetric.toml",
                      "armcal symmetric-point examples/wang2016/as-meant.symmetric.toml --json -o "
                      "calibrated.arm.toml",
                      "armcal symmetric-point examples/wang2016/as-meant.symmetric.toml --compare "
                      "examples/arms/romer-infinite-2.0-as-printed.arm.toml"};
  command.run = [flags](const Context& context) {
    return run_symmetric_point_command(*flags, context);
  };
  return command;
}

}  // namespace armcal::cli
