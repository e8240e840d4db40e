// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "armcal/cli/commands.h"
#include "armcal/workflow/paper_demo.h"
#include "armcal/workflow/virtual_demo.h"

namespace armcal::cli {
namespace {

struct Flags {
  std::optional<std::string> story;
};

int run_demo(const Flags& flags, const Context& context) {
  if (flags.story == "virtual") {
    const VirtualDemo demo = run_virtual_demo();
    context.emit(demo.inputs, {}, demo.json, demo.text, demo.seed);
    return kDone;
  }
  const PaperDemo demo = run_paper_demo();
  context.emit(demo.inputs, {}, demo.json, demo.text);
  return kDone;
}

}  // namespace

Command demo_command() {
  const auto flags = std::make_shared<Flags>();
  Command command;
  command.name = "demo";
  command.brief = "figures in seconds, from examples built into the tool";
  command.description =
      "paper: the calibration of a ROMER Infinite 2.0 from the printed readings of Wang et al. "
      "2016, and the three\n"
      "contradictions that the program finds in them.\n"
      "virtual: an arm whose true geometry is known, calibrated with a cone, with a cone and a "
      "bar, "
      "and with a reference\n"
      "CMM; what the truth says of each.";
  command.arguments = {{"STORY",
                        "which one; paper if not given",
                        &flags->story,
                        "",
                        NumberRange::any,
                        {"paper", "virtual"}}};
  command.examples = {"armcal demo", "armcal demo paper --json", "armcal demo virtual"};
  command.run = [flags](const Context& context) { return run_demo(*flags, context); };
  return command;
}

}  // namespace armcal::cli
