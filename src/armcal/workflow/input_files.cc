// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/input_files.h"

#include <filesystem>

#include "armcal/io/arm_file.h"
#include "armcal/io/sha256.h"
#include "armcal/workflow/embedded_files.h"

namespace armcal {

std::optional<TextFile> InputFiles::text(const std::string& path, std::uint64_t largest_bytes) {
  std::optional<TextFile> file;
  if (source_ == FileSource::embedded) {
    if (const auto embedded = find_embedded_file(path)) {
      file = TextFile{path, std::string(embedded->text), "UTF-8", sha256_hex(embedded->text)};
    } else {
      diagnostics_.error({path, 0, 0}, "is not among the built-in examples");
    }
  } else {
    file = read_text_file(path, largest_bytes, diagnostics_, monitor_);
  }
  if (file) records_.push_back({file->path, file->sha256});
  return file;
}

std::optional<ArmModel> InputFiles::arm(const std::string& path) {
  const auto file = text(path, kLargestConfiguration_bytes);
  return file ? read_arm(*file, diagnostics_) : std::nullopt;
}

std::optional<CsvTable> InputFiles::table(const std::string& path, const TableOptions& options) {
  auto file = text(path, kLargestTable_bytes);
  return file ? CsvTable::parse(std::move(*file), options.map, diagnostics_, monitor_,
                                options.unmatched)
              : std::nullopt;
}

std::optional<PointReadings> InputFiles::points(const std::string& path,
                                                const TableOptions& options) {
  const auto csv = table(path, options);
  return csv ? point_readings(*csv, options, diagnostics_) : std::nullopt;
}

std::optional<JointReadings> InputFiles::joints(const std::string& path, int joint_count,
                                                const TableOptions& options) {
  const auto csv = table(path, options);
  return csv ? joint_readings(*csv, joint_count, options, diagnostics_) : std::nullopt;
}

void InputFiles::require_good() const {
  if (diagnostics_.has_errors()) throw InputError(diagnostics_);
}

void require_no_input(const std::string& path, std::span<const InputRecord> inputs) {
  for (const InputRecord& input : inputs) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(path, input.path, ignored)) continue;
    Diagnostics diagnostics;
    diagnostics.error({path, 0, 0}, "is an input of this very command: it is not overwritten",
                      "choose another name for the output");
    throw InputError(diagnostics);
  }
}

}  // namespace armcal
