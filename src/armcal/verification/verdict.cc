// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/verdict.h"

#include <algorithm>

namespace armcal {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::not_judged:
      return "not_judged";
    case Verdict::pass:
      return "pass";
    case Verdict::undecided:
      return "undecided";
    case Verdict::fail:
      return "fail";
  }
  return "unknown";
}

Verdict worst(std::span<const Verdict> verdicts) {
  const auto found = std::max_element(verdicts.begin(), verdicts.end());
  return found == verdicts.end() ? Verdict::not_judged : *found;
}

}  // namespace armcal
