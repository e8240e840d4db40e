// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/verify_commands.h"
#include "armcal/cli/verify_to_standard.h"

namespace armcal::cli {

Command verify_iso10360_12_command() {
  Command command = verify_to_standard(VerificationStandard::iso10360_12);
  command.name = "iso10360-12";
  command.brief = "the tests of ISO 10360-12: probing, articulated location, lengths";
  command.description =
      "Runs the tests of ISO 10360-12 that FILE names: probing size and form, articulated location "
      "error, length errors.\n"
      "Each value is held against its MPE with the uncertainty of the test and the decision rule "
      "of "
      "FILE. Exit code 0 where\n"
      "all pass, 1 where one fails, 3 where one is undecided.";
  command.examples = {
      "armcal verify iso10360-12 examples/verification/reverification.verification.toml"};
  return command;
}

}  // namespace armcal::cli
