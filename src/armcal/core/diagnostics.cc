// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/diagnostics.h"

#include <fmt/format.h>

#include <utility>

namespace armcal {
namespace {

// Beyond this many errors a file is not what the reader was told it is.
constexpr std::size_t kHopelessErrors = 1000;

std::string_view name(Severity severity) {
  return severity == Severity::error ? "error" : "warning";
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  const SourcePosition& where = diagnostic.where;
  std::string text;
  if (!where.file.empty()) text += where.file + ":";
  if (where.line > 0) text += fmt::format("{}:", where.line);
  if (where.line > 0 && where.column > 0) text += fmt::format("{}:", where.column);
  if (!text.empty()) text += " ";
  text += fmt::format("{}: {}", name(diagnostic.severity), diagnostic.message);
  if (!diagnostic.remedy.empty()) text += fmt::format("\n  help: {}", diagnostic.remedy);
  return text;
}

void Diagnostics::error(SourcePosition where, std::string message, std::string remedy) {
  add({Severity::error, std::move(where), std::move(message), std::move(remedy)});
}

void Diagnostics::warning(SourcePosition where, std::string message, std::string remedy) {
  add({Severity::warning, std::move(where), std::move(message), std::move(remedy)});
}

void Diagnostics::append(const Diagnostics& other) {
  for (const Diagnostic& entry : other.entries_) add(entry);
  for (const auto& [file, count] : other.counts_) {
    Count kept;
    for (const Diagnostic& entry : other.entries_) {
      if (entry.where.file != file) continue;
      ++(entry.severity == Severity::error ? kept.errors : kept.warnings);
    }
    const std::size_t hidden_errors = count.errors - kept.errors;
    counts_[file].errors += hidden_errors;
    counts_[file].warnings += count.warnings - kept.warnings;
    error_count_ += hidden_errors;
  }
}

void Diagnostics::add(Diagnostic diagnostic) {
  Count& count = counts_[diagnostic.where.file];
  std::size_t& same_kind = diagnostic.severity == Severity::error ? count.errors : count.warnings;
  ++same_kind;
  if (diagnostic.severity == Severity::error) ++error_count_;
  if (same_kind <= kShownPerFile) entries_.push_back(std::move(diagnostic));
}

bool Diagnostics::is_hopeless(std::string_view file) const {
  const auto found = counts_.find(file);
  return found != counts_.end() && found->second.errors >= kHopelessErrors;
}

std::vector<Diagnostic> Diagnostics::warnings() const {
  std::vector<Diagnostic> result;
  for (const Diagnostic& entry : entries_) {
    if (entry.severity == Severity::warning) result.push_back(entry);
  }
  return result;
}

std::string Diagnostics::to_text() const {
  std::string text;
  for (const Diagnostic& entry : entries_) text += to_string(entry) + "\n";
  for (const auto& [file, count] : counts_) {
    const std::string prefix = file.empty() ? "" : file + ": ";
    if (count.errors >= kHopelessErrors) {
      text += fmt::format("{}error: more than {} errors: gave up reading\n", prefix,
                          kHopelessErrors - 1);
    } else if (count.errors > kShownPerFile) {
      text +=
          fmt::format("{}error: {} more errors not shown\n", prefix, count.errors - kShownPerFile);
    }
    if (count.warnings > kShownPerFile) {
      text += fmt::format("{}warning: {} more warnings not shown\n", prefix,
                          count.warnings - kShownPerFile);
    }
  }
  return text;
}

InputError::InputError(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.to_text()), diagnostics_(std::move(diagnostics)) {}

}  // namespace armcal
