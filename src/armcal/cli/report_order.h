// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/core/progress.h"
#include "armcal/io/output_file.h"
#include "armcal/io/report_details_file.h"
#include "armcal/report/document.h"

namespace armcal::cli {

/// What a user wants of a report, beside or instead of what is printed.
struct ReportOrder {
  std::optional<std::string> html;      ///< path
  std::optional<std::string> pdf;       ///< path
  std::optional<std::string> language;  ///< "en" where none is named
  std::optional<std::string> details_file;

  [[nodiscard]] bool is_placed() const { return html || pdf; }
};

/// A report that can be written: what it needs beside the result is there, and its files may be
/// written. Made before long work begins.
class ReportWriter {
 public:
  /// @param kept  details where the order names no file of them
  /// @throws InputError for details that cannot be read and files that are there already; FileError
  /// where their folder is not, or a PDF is wanted and nothing prints; std::invalid_argument where
  /// page and PDF are one file
  ReportWriter(ReportOrder order, Overwrite overwrite, const Monitor& monitor,
               ReportDetails kept = {});

  /// Warnings about the details.
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

  /// Wants a page, too: one of our own, which may be there already.
  void place_page(std::string path);

  /// Makes the page of a result. Nothing is written yet.
  /// @param file    that the document came from, for messages
  /// @param inputs  files of the result
  /// @throws InputError where a file of the report is one of the inputs or the details, and as
  /// html_report
  void make(const std::string& document, const std::string& file,
            std::span<const InputRecord> inputs);
  /// The page that was made.
  [[nodiscard]] const std::string& page() const { return html_; }
  /// Writes it, where that is wanted.
  void write_page() const;
  /// Prints it, where that is. @throws as print_as_pdf
  void print() const;

  [[nodiscard]] const std::optional<std::string>& page_path() const { return order_.html; }
  [[nodiscard]] const std::optional<std::string>& pdf_path() const { return order_.pdf; }
  /// Of both.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  ReportOrder order_;
  Overwrite overwrite_;
  Overwrite overwrite_page_;
  Monitor monitor_;
  ReportDetails details_;
  std::vector<InputRecord> details_records_;
  Diagnostics diagnostics_;
  std::string browser_;
  std::string html_;
};

}  // namespace armcal::cli
