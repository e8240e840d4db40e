// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/verify_to_standard.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/table_flags.h"
#include "armcal/report/verification_report.h"

namespace armcal::cli {
namespace {

struct StandardFlags {
  std::string file;
  std::optional<std::string> arm;
  std::optional<std::string> as_left;
  bool incomplete = false;
  TableFlags table;
};

int exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::fail:
      return kDoesNotConform;
    case Verdict::undecided:
      return kUndecided;
    case Verdict::pass:
    case Verdict::not_judged:
      break;
  }
  return kDone;
}

int run(VerificationStandard standard, const StandardFlags& flags, const Context& context) {
  InputFiles files(context.monitor);
  const Verification verification =
      run_verification(files, flags.file,
                       {standard, flags.arm, flags.as_left, flags.incomplete,
                        flags.table.keep_duplicates, flags.table.keep_zero_points});
  context.emit(files.records(), files.diagnostics(), json_result(verification),
               text_result(verification));
  return exit_code(verification.verdict());
}

}  // namespace

Command verify_to_standard(VerificationStandard standard) {
  const auto flags = std::make_shared<StandardFlags>();
  Command command;
  command.arguments = joined(
      {{"FILE", "verification file (*.verification.toml)", &flags->file},
       {"--arm", "arm as found: puts joint angles through this one instead of the file's",
        &flags->arm, "ARM"},
       {"--as-left",
        "arm as left: the same angles are put through it as well, and its verdict counts",
        &flags->as_left, "ARM"},
       {"--incomplete",
        "compute what readings give that are fewer than the standard asks for; without its symbols",
        &flags->incomplete}},
      flags->table.for_suspects());
  command.run = [standard, flags](const Context& context) {
    return run(standard, *flags, context);
  };
  return command;
}

}  // namespace armcal::cli
