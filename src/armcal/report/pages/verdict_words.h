// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"
#include "armcal/verification/verdict.h"

namespace armcal {

/// The verdict under a key. @throws InputError for a word that is none
[[nodiscard]] Verdict verdict_in(const DocumentView& view, std::string_view key = "verdict");

[[nodiscard]] Tone tone_of(Verdict verdict);
/// "pass"
[[nodiscard]] std::string word_of(Verdict verdict, const Language& say);
/// The word with its sign; a dash where nothing was judged.
[[nodiscard]] Cell verdict_cell(Verdict verdict, const Language& say);
/// The word as it stands at the head of a page, with a sentence.
[[nodiscard]] Stamp stamp_of(Verdict verdict, std::string sentence, const Language& say);

/// Names one behind the other, with what the language sets between them.
/// @param separator  its key; that of names where none is said
[[nodiscard]] std::string listed(const std::vector<std::string>& names, const Language& say,
                                 const char* separator);
[[nodiscard]] std::string listed(const std::vector<std::string>& names, const Language& say);
/// Sentences one behind the other, as the language sets them.
[[nodiscard]] std::string run_on(const std::vector<std::string>& sentences, const Language& say);

/// A length or error in mm: four decimals, and more where two digits of its uncertainty need them
/// (GUM 7.2.6). A dash where there is none.
[[nodiscard]] std::string mm_text(const std::optional<double>& value_mm,
                                  const std::optional<double>& u_mm = {});
/// "88": a share in percent; a dash where there is none.
[[nodiscard]] std::string percent_text(const std::optional<double>& share, int decimals = 0);

}  // namespace armcal
