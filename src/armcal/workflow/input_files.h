// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/diagnostics.h"
#include "armcal/core/progress.h"
#include "armcal/io/reading_tables.h"
#include "armcal/io/text_file.h"
#include "armcal/observations/readings.h"
#include "armcal/report/document.h"

namespace armcal {

enum class FileSource {
  disk,
  embedded,  ///< the examples built into the library, by their path in the repository
};

/// The files of one job: reads them, remembers what was read for the report, collects every
/// problem.
class InputFiles {
 public:
  explicit InputFiles(Monitor monitor = {}, FileSource source = FileSource::disk)
      : monitor_(std::move(monitor)), source_(source) {}

  // Each returns nothing after an error; the problems of all files are thrown together by
  // `require_good`.
  [[nodiscard]] std::optional<TextFile> text(const std::string& path, std::uint64_t largest_bytes);
  [[nodiscard]] std::optional<ArmModel> arm(const std::string& path);
  [[nodiscard]] std::optional<CsvTable> table(const std::string& path, const TableOptions& options);
  [[nodiscard]] std::optional<PointReadings> points(const std::string& path,
                                                    const TableOptions& options);
  [[nodiscard]] std::optional<JointReadings> joints(const std::string& path, int joint_count,
                                                    const TableOptions& options);

  /// @throws InputError with every problem so far
  void require_good() const;

  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  [[nodiscard]] const Monitor& monitor() const { return monitor_; }
  [[nodiscard]] const std::vector<InputRecord>& records() const { return records_; }

 private:
  Monitor monitor_;
  FileSource source_;
  Diagnostics diagnostics_;
  std::vector<InputRecord> records_;
};

/// @throws InputError where the path is that of one of these files, which is not overwritten
void require_no_input(const std::string& path, std::span<const InputRecord> inputs);

}  // namespace armcal
