// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// A place in a file that a person wrote. Lines and columns count from 1; 0 means "the whole file"
/// or "the whole line".
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { warning, error };

/// One problem, addressed to the person who can mend it.
struct Diagnostic {
  Severity severity = Severity::error;
  SourcePosition where;
  std::string message;  ///< what is wrong, with the offending value
  std::string remedy;   ///< what to do about it; empty when the message says it all
};

/// `readings.csv:118:5: error: joint 4 angle "12.3.4" is not a number`, the remedy on a second
/// line.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// Collects every problem of a job, so that a person sees all of them at once.
///
/// Per file and severity only the first `kShownPerFile` are kept in full; the rest are counted, so
/// that a 200 MB file of nonsense costs neither memory nor a scrolled-away terminal.
class Diagnostics {
 public:
  static constexpr std::size_t kShownPerFile = 20;

  void error(SourcePosition where, std::string message, std::string remedy = {});
  void warning(SourcePosition where, std::string message, std::string remedy = {});
  void append(const Diagnostics& other);

  [[nodiscard]] bool has_errors() const { return error_count_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return error_count_; }
  /// True once so many errors of one file are counted that reading on tells nobody anything new.
  [[nodiscard]] bool is_hopeless(std::string_view file) const;

  /// What was kept, in the order in which it was found.
  [[nodiscard]] const std::vector<Diagnostic>& entries() const { return entries_; }
  [[nodiscard]] std::vector<Diagnostic> warnings() const;

  /// All kept entries, one after the other, and one line per file for those that were only counted.
  [[nodiscard]] std::string to_text() const;

 private:
  struct Count {
    std::size_t errors = 0;
    std::size_t warnings = 0;
  };
  void add(Diagnostic diagnostic);

  std::vector<Diagnostic> entries_;
  std::map<std::string, Count, std::less<>> counts_;
  std::size_t error_count_ = 0;
};

/// Thrown when input cannot be used; carries every problem found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Diagnostics diagnostics);
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// Thrown when the data are well formed but cannot answer the question: degenerate, unidentifiable,
/// no convergence. The message names the reason.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown when a file or device fails: it cannot be read or written.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace armcal
