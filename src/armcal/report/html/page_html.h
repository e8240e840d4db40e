// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// A page as one HTML file that needs nothing else: style, scripts and the result document are in
/// it. What it shows comes from report/html/page.mustache, which escapes every text.
///
/// A policy in its head lets the browser run only our own script, known by its hash, and fetch
/// nothing: a text that slipped through unescaped would still run nothing.
/// @param document  the result document (JSON) that the page was made from; `document_in_html`
/// gives it back
/// @param details  text of the details file that was used, which is kept in the same way
[[nodiscard]] std::string html_of(const Page& page, const Language& language,
                                  const std::string& document, const std::string& details = "");

/// The result document that is embedded in a report, byte for byte as it was put in. Nothing where
/// the text is no report of ours.
[[nodiscard]] std::optional<std::string> document_in_html(std::string_view html);

/// The SHA-256 that a report says its result has: another one than that of `document_in_html` where
/// it was changed after the report was made. Nothing in reports of versions that did not write it.
[[nodiscard]] std::optional<std::string> sha256_in_html(std::string_view html);

/// The code of the language of a report. Nothing where it is none of ours.
[[nodiscard]] std::optional<std::string> language_in_html(std::string_view html);

/// The text of the details file that a report was made with. Nothing where there was none.
[[nodiscard]] std::optional<std::string> details_in_html(std::string_view html);

/// Is the script (charts to zoom, the arm to turn) part of this build? Without Node it is not, and
/// reports show their drawings.
[[nodiscard]] bool reports_have_scripts();

}  // namespace armcal
