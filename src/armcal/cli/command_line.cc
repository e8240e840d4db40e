// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "armcal/core/spelling.h"

namespace armcal::cli {
namespace {

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

const Command* find(const std::vector<Command>& commands, std::string_view name) {
  for (const Command& command : commands) {
    if (command.name == name) return &command;
  }
  return nullptr;
}

std::vector<std::string> flags_of(const Command& command, const Command& root) {
  std::vector<std::string> flags = {"-h", "--help"};
  for (const Command* one : {&command, &root}) {
    for (const Argument& argument : one->arguments) {
      if (argument.is_positional()) continue;
      for (const std::string& spelling : argument.spellings()) flags.push_back(spelling);
    }
  }
  return flags;
}

// "-o" and "--scale", but neither "-" nor "-0.5".
bool looks_like_flag(const std::string& argument) {
  if (argument.size() < 2 || argument.front() != '-') return false;
  const char second = argument[1];
  return second != '.' && !(second >= '0' && second <= '9');
}

// CLI11 takes an unknown flag for a value when a positional is still open; so flags are checked
// before.
std::string check_flags(std::span<const std::string> arguments,
                        const std::vector<std::string>& flags, const std::string& full_name) {
  for (const std::string& argument : arguments) {
    if (argument == "--") return {};
    if (!looks_like_flag(argument)) continue;
    const bool is_long = argument.starts_with("--");
    const std::string name =
        is_long ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
    if (std::find(flags.begin(), flags.end(), name) == flags.end()) {
      return fmt::format("{}: unknown option {}\n  help: {}{}", full_name, name,
                         did_you_mean(name, flags),
                         is_long ? "" : " (a file of that name is written ./" + argument + ")");
    }
  }
  return {};
}

// CLI11 takes --scale=2 for a count of flags.
std::string check_switches(std::span<const std::string> arguments,
                           const std::vector<const Argument*>& known) {
  for (const std::string& typed : arguments) {
    if (typed == "--") return {};
    const std::size_t equals = typed.find('=');
    if (!typed.starts_with("--") || equals == std::string::npos) continue;
    for (const Argument* argument : known) {
      const bool is_switch = std::holds_alternative<bool*>(argument->target);
      if (is_switch && argument->spellings().back() == typed.substr(0, equals)) {
        return fmt::format("{} takes no value", typed.substr(0, equals));
      }
    }
  }
  return {};
}

// Numbers that parse and still are none that a measurement can have.
std::string check_numbers(const std::vector<const Argument*>& known) {
  for (const Argument* argument : known) {
    const auto* target = std::get_if<std::optional<double>*>(&argument->target);
    if (target == nullptr || !(*target)->has_value()) continue;
    const double value = ***target;
    const std::string typed = fmt::format("{} {}", argument->spellings().back(), value);
    if (!std::isfinite(value)) return fmt::format("{}: must be a finite number", typed);
    if (argument->range == NumberRange::positive && !(value > 0.0)) {
      return fmt::format("{}: must be larger than 0", typed);
    }
    if (argument->range == NumberRange::not_negative && value < 0.0) {
      return fmt::format("{}: must not be negative", typed);
    }
    const bool is_seed = argument->range == NumberRange::seed;
    if (!is_seed && argument->range != NumberRange::count) continue;
    const double least = is_seed ? 0.0 : 1.0;
    const double most = is_seed ? 9007199254740992.0 : 1e6;  // numbers are exact up to 2^53
    if (value != std::floor(value) || value < least || value > most) {
      return fmt::format("{}: must be a whole number from {} to {}", typed, least,
                         is_seed ? "2^53" : "1000000");
    }
  }
  return {};
}

// CLI11 wants names of positionals without dots and in its own spelling.
std::string positional_key(const Argument& argument) {
  std::string key = argument.name;
  std::transform(key.begin(), key.end(), key.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  std::erase(key, '.');
  return key;
}

void add_argument(CLI::App& app, const Argument& argument) {
  const std::string name = argument.is_positional() ? positional_key(argument) : argument.name;
  CLI::Option* option = std::visit(
      [&](auto* target) -> CLI::Option* {
        using T = std::remove_pointer_t<decltype(target)>;
        if constexpr (std::is_same_v<T, bool>) {
          return app.add_flag(name, *target);
        } else {
          return app.add_option(name, *target);
        }
      },
      argument.target);
  const bool optional_positional =
      std::holds_alternative<std::optional<std::string>*>(argument.target);
  if (argument.required || (argument.is_positional() && !optional_positional)) option->required();
  if (!argument.choices.empty()) {
    option->check([&argument](const std::string& value) -> std::string {
      const auto& choices = argument.choices;
      if (std::find(choices.begin(), choices.end(), value) != choices.end()) return {};
      const std::string said = fmt::format("\"{}\" is none of {}", value, fmt::join(choices, ", "));
      const std::string hint = did_you_mean(value, choices);
      // Without a near one it names them all, which is done already.
      return hint.starts_with("known:") ? said : fmt::format("{}; {}", said, hint);
    });
  }
}

// What CLI11 says, in our words and with the names that the help shows.
std::string reworded(const std::vector<const Argument*>& arguments, const CLI::ParseError& error) {
  std::string text = error.what();
  for (const Argument* argument : arguments) {
    const std::string key =
        argument->is_positional() ? positional_key(*argument) : argument->spellings().back();
    const std::string shown = argument->is_positional() ? argument->name : key;
    if (error.get_name() == "RequiredError" && text.starts_with(key + " ")) {
      return argument->is_positional()
                 ? fmt::format("{} is missing", shown)
                 : fmt::format("{} {} must be given", shown, argument->value_name);
    }
    if (error.get_name() == "ConversionError" && text.find(key + " = ") != std::string::npos) {
      return fmt::format("{} \"{}\" is not a number", shown, text.substr(text.find(" = ") + 3));
    }
    if (error.get_name() == "ValidationError" && text.starts_with(key + ": ")) {
      return shown + text.substr(key.size());
    }
  }
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    return fmt::format("too many arguments: {}", text.substr(text.find(": ") + 2));
  }
  return text;
}

std::string usage_hint(const std::string& full_name) {
  return fmt::format("\n  help: {} --help shows what it takes", full_name);
}

}  // namespace

ParsedCommandLine parse_command_line(const Command& root, std::span<const std::string> arguments) {
  ParsedCommandLine parsed;
  parsed.full_name = root.name;
  const Command* command = &root;
  std::vector<std::string> rest;
  bool help = false;
  // Verbs first: they may stand behind flags of the tool itself (armcal --json fk ..).
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "-h" || argument == "--help") {
      help = true;
    } else if (!command->subcommands.empty() && !argument.starts_with('-')) {
      const Command* verb = find(command->subcommands, argument);
      if (verb == nullptr) {
        const auto names = names_of(command->subcommands);
        parsed.error = fmt::format("{}: unknown command \"{}\"\n  help: {}", parsed.full_name,
                                   argument, did_you_mean(argument, names));
        return parsed;
      }
      command = verb;
      parsed.full_name += " " + verb->name;
    } else {
      rest.push_back(argument);
    }
  }
  if (help) {
    parsed.help = help_text(*command, parsed.full_name);
    return parsed;
  }
  parsed.error = check_flags(rest, flags_of(*command, root), parsed.full_name);
  if (!parsed.error.empty()) return parsed;

  std::vector<const Argument*> known;
  for (const Argument& argument : command->arguments) known.push_back(&argument);
  if (command != &root) {
    for (const Argument& argument : root.arguments) known.push_back(&argument);
  }
  const auto wrong = [&](const std::string& what) {
    parsed.error = fmt::format("{}: {}{}", parsed.full_name, what, usage_hint(parsed.full_name));
    return parsed;
  };
  if (const std::string what = check_switches(rest, known); !what.empty()) return wrong(what);
  CLI::App app;
  app.set_help_flag();
  for (const Argument* argument : known) add_argument(app, *argument);
  try {
    std::reverse(rest.begin(), rest.end());  // CLI11 takes a vector from its back
    app.parse(rest);
  } catch (const CLI::ParseError& error) {
    return wrong(reworded(known, error));
  }
  if (const std::string what = check_numbers(known); !what.empty()) return wrong(what);
  if (!command->subcommands.empty() && !command->run) {
    parsed.error = fmt::format("{}: a command is missing\n  help: known: {}", parsed.full_name,
                               fmt::join(names_of(command->subcommands), ", "));
    return parsed;
  }
  parsed.command = command;
  return parsed;
}

}  // namespace armcal::cli
