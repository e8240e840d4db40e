// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/document.h"
#include "armcal/report/html/page.h"

namespace armcal::testing {

/// The document that `armcal COMMAND --json` would print with these keys.
[[nodiscard]] Json document_of(const std::string& command, const Json& result);

/// The page of a document in a language.
[[nodiscard]] Page page_in(const std::string& language, const Json& document);

/// Every text of a page, one a line; drawings are left out.
[[nodiscard]] std::string words_of(const Page& page);

/// The section of an id; a test failure and an empty one where there is none.
[[nodiscard]] Section section_of(const Page& page, const std::string& id);

/// What holds for the page of any document: ids are unique; and however it was edited by hand: each
/// key in its turn is taken away, is of another type, a huge number or a hostile text. There is a
/// page in which that text is text, or an InputError that names the key. Of lists the first entries
/// are tried.
void expect_page_laws(const Json& document);

}  // namespace armcal::testing
