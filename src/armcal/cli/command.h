// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "armcal/cli/report_order.h"
#include "armcal/core/progress.h"
#include "armcal/io/output_file.h"
#include "armcal/report/document.h"

namespace armcal::cli {

/// Exit codes of the tool: a contract, tested, never changed (docs/commands/exit-codes.md).
enum ExitCode : int {
  kDone = 0,
  kDoesNotConform = 1,
  kWrongInput = 2,
  kUndecided = 3,
  kNumericalFailure = 4,
  kDeviceFailure = 5,
  kBug = 70,
  kInterrupted = 130,
};

/// Where a typed value goes.
using Target = std::variant<bool*, std::string*, std::optional<std::string>*,
                            std::optional<double>*, std::vector<std::string>*>;

/// What a number must be; it must be finite in any case. Counts are whole numbers from 1 to
/// 1,000,000, seeds whole ones from 0 to 2^53.
enum class NumberRange { any, positive, not_negative, count, seed };

/// One flag or positional argument. This one definition feeds parsing, help and the check of
/// mistyped flags.
struct Argument {
  std::string name;  ///< "ARM" (positional), "--scale", "-o,--output"
  std::string help;
  Target target;
  std::string value_name = {};            ///< "FILE"; for flags with a value
  NumberRange range = NumberRange::any;   ///< of a number
  std::vector<std::string> choices = {};  ///< the only values allowed; empty: any
  bool required = false;  ///< positionals are required unless their target is optional

  [[nodiscard]] bool is_positional() const { return name.front() != '-'; }
  /// Spellings of a flag: {"-o", "--output"}.
  [[nodiscard]] std::vector<std::string> spellings() const;
};

/// A count that was typed, or else.
[[nodiscard]] inline int count_or(const std::optional<double>& typed, int otherwise) {
  return typed ? static_cast<int>(*typed) : otherwise;
}
/// A seed that was typed, or else.
[[nodiscard]] inline std::uint64_t seed_or(const std::optional<double>& typed,
                                           std::uint64_t otherwise) {
  return typed ? static_cast<std::uint64_t>(*typed) : otherwise;
}
/// So many threads as were typed, or one for every core.
[[nodiscard]] int threads_of(const std::optional<double>& typed);

/// What a running command may use.
struct Context {
  std::ostream& out;  ///< the result, and nothing else
  std::ostream& err;  ///< warnings, progress
  Monitor monitor;
  bool json = false;
  bool quiet = false;
  Overwrite overwrite = Overwrite::refuse;
  std::string command;                    ///< "fit circle"
  std::vector<std::string> command_line;  ///< as typed, without the program's name
  ReportOrder report_order;
  ReportWriter* report = nullptr;  ///< where one is wanted

  /// Prints warnings to err, unless quiet.
  void warn(const Diagnostics& diagnostics) const;
  /// Is the document of the result wanted, to print or to report?
  [[nodiscard]] bool wants_document() const { return json || report != nullptr; }
  /// Prints warnings to err (unless quiet) and the result to out: `text`, or with --json the
  /// document; writes the page of the report where one is wanted (its PDF comes last, when the
  /// result is out).
  /// @param seed  where random numbers were drawn
  void emit(const std::vector<InputRecord>& inputs, const Diagnostics& diagnostics,
            const Json& json, const std::string& text,
            const std::optional<std::uint64_t>& seed = std::nullopt) const;
  /// The document of a result, as --json prints it.
  [[nodiscard]] std::string document(const std::vector<InputRecord>& inputs,
                                     const Diagnostics& diagnostics, const Json& json,
                                     const std::optional<std::uint64_t>& seed) const;
  /// Writes an output file. @throws InputError where it would overwrite one of the inputs, and as
  /// write_file
  void save(const std::string& path, const std::string& text,
            const std::vector<InputRecord>& inputs) const;
};

/// A verb of the tool: what it is called, what it takes, what it does.
struct Command {
  std::string name;
  std::string brief;        ///< one line
  std::string description;  ///< a paragraph for --help; may be empty
  std::vector<Argument> arguments;
  std::vector<std::string> examples;  ///< whole command lines that work in the repository
  std::function<int(const Context&)> run;
  std::vector<Command> subcommands = {};
};

/// The text of `armcal NAME --help`.
[[nodiscard]] std::string help_text(const Command& command, const std::string& full_name);

}  // namespace armcal::cli
