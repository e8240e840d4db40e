// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "armcal/cli/commands.h"
#include "armcal/workflow/paper_demo.h"
#include "armcal/workflow/programs.h"
#include "armcal/workflow/virtual_demo.h"

namespace armcal::cli {
namespace {

struct DemoFlags {
  std::optional<std::string> story;
  bool open = false;
};

// The demo's own file, made anew by every run, in a folder that nobody else may write to.
std::string path_of_report(const std::string& story) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("armcal-demo-{}", getuid());
  struct stat found = {};
  const bool is_made = mkdir(folder.c_str(), 0700) == 0;
  const bool is_ours = lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
                       found.st_uid == getuid() && (found.st_mode & 022) == 0;
  if (!is_made && !is_ours) {
    throw FileError(
        fmt::format("{} is not a folder of yours alone: say --report FILE", folder.string()));
  }
  return (folder / (story + ".html")).string();
}

// @param ending  below the text
void tell(const std::string& story, const Context& context, const std::string& ending) {
  if (story == "virtual") {
    const VirtualDemo demo = run_virtual_demo();
    context.emit(demo.inputs, {}, demo.json, demo.text + ending, demo.seed);
  } else {
    const PaperDemo demo = run_paper_demo();
    context.emit(demo.inputs, {}, demo.json, demo.text + ending);
  }
}

int run_demo(const DemoFlags& flags, const Context& context) {
  const std::string story = flags.story.value_or("paper");
  std::optional<ReportWriter> own;
  Context reporting = context;
  if (reporting.report == nullptr) {
    reporting.report = &own.emplace(context.report_order, context.overwrite, context.monitor);
    context.warn(own->diagnostics());
  }
  std::string ending;
  if (!reporting.report->page_path()) {
    reporting.report->place_page(path_of_report(story));
    ending = fmt::format("\nReport: {}\n", *reporting.report->page_path());
    reporting.quiet = context.quiet || !context.json;  // the text itself ends with the path
  }
  tell(story, reporting, ending);
  if (flags.open) open_in_browser(*reporting.report->page_path());
  return kDone;
}

}  // namespace

Command demo_command() {
  const auto flags = std::make_shared<DemoFlags>();
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
      "CMM; what the truth says of each.\n"
      "Each also writes its report, by default to a folder for temporary files, and ends with the "
      "path.";
  command.arguments = {{"STORY",
                        "which one; paper if not given",
                        &flags->story,
                        "",
                        NumberRange::any,
                        {"paper", "virtual"}},
                       {"--open", "open the report in a browser", &flags->open}};
  command.examples = {"armcal demo", "armcal demo paper --json", "armcal demo virtual"};
  command.run = [flags](const Context& context) { return run_demo(*flags, context); };
  return command;
}

}  // namespace armcal::cli
