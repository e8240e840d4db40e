// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/io/output_file.h"
#include "armcal/io/report_details_file.h"
#include "armcal/report/document.h"

namespace armcal::cli {

/// What a user wants of a report, beside or instead of what is printed.
struct ReportOrder {
  std::optional<std::string> html;  ///< path
  std::optional<std::string> pdf;   ///< path
  std::string language = "en";
  std::optional<std::string> details_file;

  [[nodiscard]] bool is_placed() const { return html || pdf; }
};

/// A report that can be written: what it needs beside the result is there, and its files may be
/// written. Made before long work begins.
class ReportWriter {
 public:
  /// @throws InputError for details that cannot be read and files that are there already; FileError
  /// where a PDF is wanted and nothing prints
  /// @param kept  details where the order names no file of them
  ReportWriter(ReportOrder order, Overwrite overwrite, const Monitor& monitor,
               ReportDetails kept = {});

  /// Writes it. @param file  that the document came from, for messages
  /// @throws InputError where a file of the report is one of the inputs, and as html_report
  void write(const std::string& document, const std::string& file) const;
  /// Paths that are written.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  ReportOrder order_;
  Overwrite overwrite_;
  Monitor monitor_;
  ReportDetails details_;
  std::string browser_;
};

}  // namespace armcal::cli
