// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/app.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <new>
#include <ostream>
#include <stdexcept>

#include "armcal/cli/command_line.h"
#include "armcal/cli/commands.h"
#include "armcal/cli/progress_bar.h"
#include "armcal/core/diagnostics.h"
#include "armcal/core/version.h"
#include "armcal/report/html/language.h"

namespace armcal::cli {
namespace {

// What belongs to every verb.
struct CommonFlags {
  bool json = false;
  bool force = false;
  bool quiet = false;
  bool version = false;
  std::string color = "auto";
  ReportOrder report;
};

Command tool(CommonFlags& flags) {
  Command root;
  root.name = "armcal";
  root.brief = "calibrate and verify articulated measuring arms";
  root.description =
      "stdout carries the result only; warnings and progress go to stderr. Exit codes: 0 done, 1 "
      "does not\n"
      "conform, 2 wrong input, 3 undecided, 4 numerical failure, 5 device failure, 130 "
      "interrupted.";
  root.arguments = {
      {"--json", "print one JSON object instead of text", &flags.json},
      {"--force", "overwrite output files", &flags.force},
      {"--quiet", "no warnings, no progress", &flags.quiet},
      {"--color",
       "colour messages",
       &flags.color,
       "WHEN",
       NumberRange::any,
       {"auto", "always", "never"}},
      {"--version", "print the version", &flags.version},
      {"--report", "write the result as a report of one HTML file", &flags.report.html, "HTML"},
      {"--pdf", "the same on paper (needs Chromium)", &flags.report.pdf, "PDF"},
      {"--lang", "language of the report", &flags.report.language, "LANG", NumberRange::any,
       Language::codes()},
      {"--details", "what the report says beside the result: customer, item, references (TOML)",
       &flags.report.details_file, "FILE"},
  };
  root.subcommands = all_commands();
  root.examples = {"armcal demo paper",
                   "armcal fk examples/arms/puma-560.arm.toml examples/angles/six-joints.csv",
                   "armcal symmetric-point examples/wang2016/as-printed.symmetric.toml"};
  return root;
}

bool wants_color(const CommonFlags& flags, const Console& console) {
  if (flags.color != "auto") return flags.color == "always";
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return console.err_is_terminal && !dumb && std::getenv("NO_COLOR") == nullptr;
}

// "error:" in red, "warning:" in yellow, "help:" in blue.
std::string colored(std::string text, bool color) {
  if (!color) return text;
  const auto paint = [&](std::string_view word, std::string_view code) {
    for (std::size_t at = text.find(word); at != std::string::npos;) {
      const std::string painted = fmt::format("\x1b[{}m{}\x1b[0m", code, word);
      text.replace(at, word.size(), painted);
      at = text.find(word, at + painted.size());
    }
  };
  paint("error:", "1;31");
  paint("warning:", "1;33");
  paint("help:", "36");
  return text;
}

class Failure {
 public:
  Failure(const Console& console, const CommonFlags& flags, std::string command)
      : console_(console), flags_(flags), command_(std::move(command)) {}

  void result_is_out() { is_result_out_ = true; }
  [[nodiscard]] bool is_result_out() const { return is_result_out_; }

  // Words on err; with --json also an object on out, so that a program need not read prose: not a
  // second one where the result is out already.
  [[nodiscard]] int report(int code, const std::string& message,
                           const Diagnostics& diagnostics = {}) const {
    console_.err << colored(message, wants_color(flags_, console_));
    if (flags_.json && !is_result_out_) {
      console_.out << json_error({command_, {}, {}, std::nullopt, diagnostics}, code, message);
    }
    return code;
  }

 private:
  const Console& console_;
  const CommonFlags& flags_;
  std::string command_;
  bool is_result_out_ = false;
};

// Flags of a report that has no place, or none that it can go to.
void check_report_flags(const ReportOrder& order, const std::string& verb) {
  const auto is_standard_output = [](const auto& path) { return path && *path == "-"; };
  if (is_standard_output(order.html) || is_standard_output(order.pdf)) {
    throw std::invalid_argument(
        is_standard_output(order.pdf)
            ? "--pdf -: standard output is for the result\n  help: name a file: --pdf FILE.pdf"
            : "--report -: standard output is for the result\n  help: name a file: --report "
              "FILE.html");
  }
  const bool makes_its_own = verb == "report" || verb == "demo";
  if (order.is_placed() || makes_its_own) return;
  for (const auto& [flag, is_given] : {std::pair{"--details", order.details_file.has_value()},
                                       std::pair{"--lang", order.language.has_value()}}) {
    if (!is_given) continue;
    throw std::invalid_argument(
        fmt::format("{} is for a report: say --report FILE or --pdf FILE too", flag));
  }
}

extern "C" void end_as_bug(int /*signal*/) { _exit(kBug); }

}  // namespace

void end_with_exit_code_on_abort() { std::signal(SIGABRT, end_as_bug); }

int run(std::span<const std::string> arguments, const Console& console) {
  CommonFlags flags;
  const Command root = tool(flags);
  const ParsedCommandLine parsed = parse_command_line(root, arguments);
  // A line that cannot be parsed may still have asked for JSON.
  flags.json =
      flags.json || std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  const std::string verb =
      parsed.full_name == root.name ? "" : parsed.full_name.substr(root.name.size() + 1);
  Failure failure(console, flags, verb);
  if (!parsed.help.empty()) {
    console.out << parsed.help;
    return kDone;
  }
  if (flags.version) {
    console.out << "armcal " << kVersion << "\n";
    return kDone;
  }
  if (!parsed.error.empty()) {
    if (arguments.empty()) {
      console.err << help_text(root, root.name);
      return kWrongInput;
    }
    return failure.report(kWrongInput, fmt::format("error: {}\n", parsed.error));
  }

  ProgressBar bar(console.err);
  Monitor monitor{{}, console.stop};
  if (console.err_is_terminal && !flags.quiet) {
    monitor.on_progress = [&](const Progress& progress) { bar.show(progress); };
  }
  Context context{console.out, console.err,
                  monitor,     flags.json,
                  flags.quiet, flags.force ? Overwrite::allow : Overwrite::refuse,
                  verb,        {arguments.begin(), arguments.end()},
                  flags.report};
  try {
    check_report_flags(flags.report, verb);
    std::optional<ReportWriter> report;
    if (flags.report.is_placed() && verb != "report") {
      report.emplace(flags.report, context.overwrite, monitor);
      context.report = &*report;
      context.warn(report->diagnostics());
    }
    const int code = parsed.command->run(context);
    console.out.flush();
    if (!console.out)
      return failure.report(kDeviceFailure, "error: cannot write to standard output\n");
    failure.result_is_out();
    if (report && report->pdf_path()) {
      report->print();
      if (!flags.quiet) console.err << "report: " << *report->pdf_path() << "\n";
    }
    return code;
  } catch (const InputError& error) {
    bar.wipe();
    return failure.report(kWrongInput, error.what(), error.diagnostics());
  } catch (const NumericalError& error) {
    bar.wipe();
    return failure.report(kNumericalFailure, fmt::format("error: {}\n", error.what()));
  } catch (const FileError& error) {
    bar.wipe();
    return failure.report(kDeviceFailure, fmt::format("error: {}\n", error.what()));
  } catch (const Interrupted&) {
    bar.wipe();
    return failure.report(kInterrupted, failure.is_result_out()
                                            ? "interrupted: the PDF was not written\n"
                                            : "interrupted: nothing was written\n");
  } catch (const std::invalid_argument& error) {
    bar.wipe();
    return failure.report(kWrongInput, fmt::format("error: {}\n", error.what()));
  } catch (const std::bad_alloc&) {
    bar.wipe();
    return failure.report(kDeviceFailure, "error: out of memory\n");
  } catch (const std::exception& error) {
    bar.wipe();
    return failure.report(
        kBug, fmt::format("error: a bug in armcal: {}\n  help: please report it with the "
                          "command and the files that led here\n",
                          error.what()));
  }
}

}  // namespace armcal::cli
