// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "armcal/cli/commands.h"
#include "armcal/workflow/paper_demo.h"

namespace armcal::cli {
namespace {

struct Flags {
  std::optional<std::string> story;
};

int run_demo(const Context& context) {
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
      "contradictions that the program finds in them.";
  command.arguments = {
      {"STORY", "which one; paper if not given", &flags->story, "", false, {"paper"}}};
  command.examples = {"armcal demo", "armcal demo paper --json"};
  command.run = [flags](const Context& context) { return run_demo(context); };
  return command;
}

}  // namespace armcal::cli
