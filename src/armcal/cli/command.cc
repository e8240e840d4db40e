// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>
#include <thread>

namespace armcal::cli {
namespace {

// "  name   help", the names padded to one width.
std::string listing(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::size_t width = 0;
  for (const auto& [name, help] : rows) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, help] : rows) text += fmt::format("  {:<{}}  {}\n", name, width, help);
  return text;
}

std::string flag_text(const Argument& argument) {
  std::string text = fmt::format("{}", fmt::join(argument.spellings(), ", "));
  if (!std::holds_alternative<bool*>(argument.target)) text += " " + argument.value_name;
  return text;
}

std::string help_of(const Argument& argument) {
  if (argument.choices.empty()) return argument.help;
  return fmt::format("{} ({})", argument.help, fmt::join(argument.choices, ", "));
}

bool is_optional(const Argument& argument) {
  return std::holds_alternative<std::optional<std::string>*>(argument.target);
}

}  // namespace

std::vector<std::string> Argument::spellings() const {
  const std::size_t comma = name.find(',');
  if (comma == std::string::npos) return {name};
  return {name.substr(0, comma), name.substr(comma + 1)};
}

void Context::warn(const Diagnostics& diagnostics) const {
  if (quiet) return;
  for (const Diagnostic& warning : diagnostics.warnings()) err << to_string(warning) << "\n";
}

void Context::emit(const std::vector<InputRecord>& inputs, const Diagnostics& diagnostics,
                   const Json& json_result, const std::string& text,
                   const std::optional<std::uint64_t>& seed) const {
  warn(diagnostics);
  if (!wants_document()) {
    out << text;
    return;
  }
  const std::string result = document(inputs, diagnostics, json_result, seed);
  if (report != nullptr) {
    report->make(result, "this result", inputs);
    report->write_page();
  }
  out << (json ? result : text);
  if (report != nullptr && report->page_path() && !quiet) {
    err << "report: " << *report->page_path() << "\n";
  }
}

std::string Context::document(const std::vector<InputRecord>& inputs,
                              const Diagnostics& diagnostics, const Json& json_result,
                              const std::optional<std::uint64_t>& seed) const {
  return json_document({command, command_line, inputs, seed, diagnostics}, json_result);
}

void Context::save(const std::string& path, const std::string& text,
                   const std::vector<InputRecord>& inputs) const {
  require_no_input(path, inputs);
  write_file(path, text, overwrite);
}

std::string help_text(const Command& command, const std::string& full_name) {
  std::string usage = full_name;
  std::vector<std::pair<std::string, std::string>> positionals;
  std::vector<std::pair<std::string, std::string>> flags;
  for (const Argument& argument : command.arguments) {
    if (argument.is_positional()) {
      usage += is_optional(argument) ? fmt::format(" [{}]", argument.name) : " " + argument.name;
      positionals.emplace_back(argument.name, help_of(argument));
    } else {
      if (argument.required)
        usage += fmt::format(" {} {}", argument.spellings().back(), argument.value_name);
      flags.emplace_back(flag_text(argument), help_of(argument));
    }
  }
  std::vector<std::pair<std::string, std::string>> verbs;
  for (const Command& verb : command.subcommands) verbs.emplace_back(verb.name, verb.brief);
  if (!verbs.empty()) usage += " COMMAND";

  std::string text =
      fmt::format("{}: {}\n\nUsage: {} [options]\n", full_name, command.brief, usage);
  if (!command.description.empty()) text += "\n" + command.description + "\n";
  if (!verbs.empty()) text += "\nCommands\n" + listing(verbs);
  if (!positionals.empty()) text += "\nArguments\n" + listing(positionals);
  if (!flags.empty()) text += "\nOptions\n" + listing(flags);
  if (!command.examples.empty()) {
    text += "\nExamples\n";
    for (const std::string& example : command.examples) text += "  " + example + "\n";
  }
  return text;
}

int threads_of(const std::optional<double>& typed) {
  return count_or(typed, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

}  // namespace armcal::cli
