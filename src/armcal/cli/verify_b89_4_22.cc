// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/verify_commands.h"
#include "armcal/cli/verify_to_standard.h"

namespace armcal::cli {

Command verify_b89_4_22_command() {
  Command command = verify_to_standard(VerificationStandard::b89_4_22);
  command.name = "b89.4.22";
  command.brief = "the tests of ASME B89.4.22: sphere, single point, twenty lengths";
  command.description =
      "Runs the tests of ASME B89.4.22 that FILE names: effective diameter, single-point "
      "articulation, volumetric lengths;\n"
      "and the makers' half range per axis where FILE asks for it, under that name. Exit codes as "
      "of iso10360-12.";
  command.examples = {"armcal verify b89.4.22 examples/verification/long-scale.verification.toml"};
  return command;
}

}  // namespace armcal::cli
