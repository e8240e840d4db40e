// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verdict_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/number_format.h"

namespace armcal {
namespace {

constexpr const char* kDash = "\u2013";
constexpr int kLeastDecimals = 4;
constexpr int kMostDecimals = 6;

}  // namespace

Verdict verdict_in(const DocumentView& view, std::string_view key) {
  const std::string word = view.text(key);
  for (const Verdict each :
       {Verdict::not_judged, Verdict::pass, Verdict::undecided, Verdict::fail}) {
    if (word == to_string(each)) return each;
  }
  view[key].complain("is none of pass, fail, undecided, not_judged");
}

Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return Tone::good;
    case Verdict::fail:
      return Tone::bad;
    case Verdict::undecided:
      return Tone::warning;
    case Verdict::not_judged:
      break;
  }
  return Tone::neutral;
}

std::string word_of(Verdict verdict, const Language& say) {
  return say(fmt::format("verification.verdict.{}", to_string(verdict)));
}

Cell verdict_cell(Verdict verdict, const Language& say) {
  if (verdict == Verdict::not_judged) return {kDash};
  return {word_of(verdict, say), tone_of(verdict)};
}

Stamp stamp_of(Verdict verdict, std::string sentence, const Language& say) {
  return {say(fmt::format("verification.stamp.{}", to_string(verdict))), std::move(sentence),
          tone_of(verdict)};
}

std::string listed(const std::vector<std::string>& names, const Language& say,
                   const char* separator) {
  return fmt::format("{}", fmt::join(names, say(separator)));
}

std::string listed(const std::vector<std::string>& names, const Language& say) {
  return listed(names, say, "calibration.name_separator");
}

std::string run_on(const std::vector<std::string>& sentences, const Language& say) {
  return listed(sentences, say, "verification.between_sentences");
}

std::string mm_text(const std::optional<double>& value_mm, const std::optional<double>& u_mm) {
  if (!value_mm || !std::isfinite(*value_mm)) return kDash;
  const int wanted = u_mm && *u_mm > 0.0 ? decimals_for_uncertainty(*u_mm) : kLeastDecimals;
  return fixed(*value_mm, std::clamp(wanted, kLeastDecimals, kMostDecimals));
}

std::string percent_text(const std::optional<double>& share, int decimals) {
  constexpr double kPercent = 100.0;
  return share ? fixed(kPercent * *share, decimals) : kDash;
}

}  // namespace armcal
