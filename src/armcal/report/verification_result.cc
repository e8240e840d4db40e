// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_result.h"

namespace armcal {

Verdict Verification::verdict() const {
  std::vector<Verdict> verdicts;
  for (const VerifiedStatistic& statistic : statistics) {
    verdicts.push_back(statistic.judged().verdict);
  }
  return worst(verdicts);
}

Verdict Verification::as_found_verdict() const {
  std::vector<Verdict> verdicts;
  for (const VerifiedStatistic& statistic : statistics) {
    verdicts.push_back(statistic.as_found.verdict);
  }
  return worst(verdicts);
}

}  // namespace armcal
