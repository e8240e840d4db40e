// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "armcal/io/report_details_file.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// What a report is made of.
struct SavedResult {
  std::string document;   ///< JSON, byte for byte as it was
  ReportDetails details;  ///< of the report that held the document; else empty
};

/// What a file holds: what --json printed or --save wrote, or a report that has it in itself.
/// @throws InputError where it is neither
[[nodiscard]] SavedResult load_saved_result(InputFiles& files, const std::string& path);

/// @throws InputError with every problem of the details file
[[nodiscard]] ReportDetails load_report_details(InputFiles& files, const std::string& path);

/// A result document as an HTML report that needs no other file.
/// @param file      that the document came from, for messages
/// @param language  "en" or "zh"
/// @throws InputError where the document lacks what its page needs
[[nodiscard]] std::string html_report(const std::string& document, const std::string& file,
                                      std::string_view language, const ReportDetails& details);

}  // namespace armcal
