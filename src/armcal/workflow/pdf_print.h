// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/core/progress.h"
#include "armcal/io/output_file.h"

namespace armcal {

/// The browser that prints: what ARMCAL_BROWSER names, else the first of chromium,
/// chromium-browser, google-chrome that PATH has. @throws FileError where there is none, with what
/// to do
[[nodiscard]] std::string printing_browser();

/// An HTML report on paper, as PDF: page numbers, no cut tables, fonts embedded.
/// @param html  the report itself @param browser  from `printing_browser`
/// @throws FileError where the browser fails or takes longer than two minutes, with its last words;
/// Interrupted; InputError as write_file
void print_as_pdf(const std::string& html, const std::string& browser, const std::string& pdf_path,
                  Overwrite overwrite, const Monitor& monitor);

}  // namespace armcal
