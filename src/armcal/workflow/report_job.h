// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "armcal/io/report_details_file.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// What a report is made of.
struct SavedResult {
  std::string document;  ///< JSON, byte for byte as it was
  // Of the report that held the document, where one did:
  std::optional<TextFile> details;      ///< the details that it was made with
  std::optional<std::string> language;  ///< "en" or "zh"
};

/// What a file holds: what --json printed or --save wrote, or a report that has it in itself. A
/// result that was changed after its report was made is a warning.
/// @throws InputError where it is neither
[[nodiscard]] SavedResult load_saved_result(InputFiles& files, const std::string& path);

/// The details that came with a result; empty where none did.
/// @throws InputError where they are not such as are read today
[[nodiscard]] ReportDetails kept_details(InputFiles& files, const SavedResult& saved);

/// @throws InputError with every problem of the details file
[[nodiscard]] ReportDetails load_report_details(InputFiles& files, const std::string& path);

/// A result document as an HTML report that needs no other file.
/// @param file      that the document came from, for messages
/// @param language  "en" or "zh"
/// @throws InputError where the document lacks what its page needs
[[nodiscard]] std::string html_report(const std::string& document, const std::string& file,
                                      std::string_view language, const ReportDetails& details);

}  // namespace armcal
