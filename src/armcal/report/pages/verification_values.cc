// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_values.h"

#include <algorithm>
#include <cmath>

#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

// The test whose parts are no values of its own kind, but distances that it is found from.
constexpr const char* kArticulatedLocation = "articulated location error";

VerifiedPart part_of(const DocumentView& part, const Language& say) {
  return {.name = in_language(part.text("name"), kVerificationPhrases, say),
          .where = part.text("where"),
          .value_mm = part.has("value_mm") ? part.number("value_mm") : std::nan(""),
          .length_mm = part.number_if("length_mm"),
          .mpe_mm = part.number_if("mpe_mm")};
}

VerifiedValue value_of(const DocumentView& judged, const Language& say) {
  VerifiedValue value;
  value.value_mm = judged.number_if("value_mm");
  value.largest_mm = judged.number_if("largest_mm");
  value.mpe_mm = judged.number_if("mpe_mm");
  value.U_mm = judged.number_if("U_mm");
  value.guard_mm = judged.number_if("guard_mm");
  value.share_of_mpe = judged.number_if("share_of_mpe");
  value.conformance_probability = judged.number_if("conformance_probability");
  value.verdict = verdict_in(judged);
  value.is_complete = judged.flag("complete");
  value.symbol = judged.text_if("symbol").value_or("");
  value.decided_by =
      in_language(judged.text_if("decided_by").value_or(""), kVerificationPhrases, say);
  for (const std::string& each : judged.texts("missing")) {
    value.missing.push_back(in_language(each, kVerificationPhrases, say));
  }
  for (const DocumentView& each : judged.list("parts")) value.parts.push_back(part_of(each, say));
  return value;
}

VerifiedRow verified_row(const DocumentView& test, const Language& say) {
  VerifiedRow row;
  const std::string name = test.text("name");
  row.test = test.text("test");
  row.title = in_language(name, kVerificationPhrases, say);
  // Results that were saved before they had a title have names alone.
  if (test.text_if("title").value_or(name) != name) {
    row.title = say("verification.title_of_test", row.title, row.test);
  }
  row.definition = in_language(test.text("definition"), kVerificationPhrases, say);
  row.part_axis =
      say(name == kArticulatedLocation ? "verification.distance_axis" : "verification.value_axis");
  row.limit = with_micro_sign(test.text_if("limit").value_or(""));
  row.is_signed = test.has("is_signed") && test.flag("is_signed");
  row.judged = value_of(test, say);
  if (test.has("as_found")) row.as_found = value_of(test["as_found"], say);
  return row;
}

}  // namespace

std::vector<VerifiedRow> verified_rows(const DocumentView& document, const Language& say) {
  std::vector<VerifiedRow> rows;
  for (const DocumentView& test : document.list("tests")) rows.push_back(verified_row(test, say));
  return rows;
}

bool have_as_left(const std::vector<VerifiedRow>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const VerifiedRow& row) { return row.as_found.has_value(); });
}

bool are_worth_a_chart(const VerifiedRow& row) {
  constexpr std::size_t kEnough = 4;
  return row.judged.parts.size() >= kEnough;
}

bool repeats_parts(const std::vector<VerifiedRow>& rows, std::size_t at) {
  if (at == 0 || rows[at - 1].test != rows[at].test) return false;
  const auto& parts = rows[at].judged.parts;
  const auto& before = rows[at - 1].judged.parts;
  return std::equal(parts.begin(), parts.end(), before.begin(), before.end(),
                    [](const VerifiedPart& one, const VerifiedPart& other) {
                      return one.name == other.name && one.value_mm == other.value_mm;
                    });
}

}  // namespace armcal
