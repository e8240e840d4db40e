// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/verification/verdict.h"

namespace armcal {

/// Where the language files have the phrases of these documents.
inline constexpr const char* kVerificationPhrases = "verification.phrase";

/// One of the values that a statistic was found from.
struct VerifiedPart {
  std::string name;   ///< in the language of the reader
  std::string where;  ///< place in the user's file; may be empty
  double value_mm = 0.0;
  std::optional<double> length_mm;
  std::optional<double> mpe_mm;  ///< for this length
};

/// What one arm gave for a statistic, and how it was judged.
struct VerifiedValue {
  std::optional<double> value_mm;    ///< that decides
  std::optional<double> largest_mm;  ///< of the statistic
  std::optional<double> mpe_mm, U_mm, guard_mm, share_of_mpe, conformance_probability;
  Verdict verdict = Verdict::not_judged;
  bool is_complete = true;
  std::string symbol;      ///< empty: none
  std::string decided_by;  ///< name of the part; may be empty
  std::vector<std::string> missing;
  std::vector<VerifiedPart> parts;
};

/// A statistic of a verification, from one of the entries of `tests`.
struct VerifiedRow {
  std::string title;  ///< in the language of the reader, with the name that a user gave the test
  std::string test;   ///< as the file calls it
  std::string part_axis;  ///< what its parts are: "value, mm"
  std::string definition;
  std::string limit;  ///< "20 um + L/50"; empty: none
  bool is_signed = false;
  std::optional<VerifiedValue> as_found;  ///< only where there is another one as left
  VerifiedValue judged;                   ///< what counts
};

/// @throws InputError where an entry lacks a key
[[nodiscard]] std::vector<VerifiedRow> verified_rows(const DocumentView& document,
                                                     const Language& say);

/// Was an arm as left verified too? Rows without a value as found are of the arm as found then:
/// their readings could not be put through the other one.
[[nodiscard]] bool have_as_left(const std::vector<VerifiedRow>& rows);
/// Are there so many parts that a chart tells more than a table?
[[nodiscard]] bool are_worth_a_chart(const VerifiedRow& row);
/// Has the row before, of the same test, the same parts?
[[nodiscard]] bool repeats_parts(const std::vector<VerifiedRow>& rows, std::size_t at);

}  // namespace armcal
