// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/io/verification_file.h"
#include "armcal/verification/decision_rule.h"
#include "armcal/verification/judgement.h"
#include "armcal/verification/maximum_permissible_error.h"
#include "armcal/verification/test_uncertainty.h"

namespace armcal {

/// The budget of a test value, and which one it is of where a test has several: "500.0012 mm".
struct TestBudget {
  std::string of;
  TestUncertainty uncertainty;
};

/// One statistic of one test, from the same readings put through one arm or two.
struct VerifiedStatistic {
  std::string test;   ///< name of the test in the file
  std::string title;  ///< of the statistic: "probing size error", with the test's name where the
                      ///< file gives it one of its own
  std::string limit;  ///< "20 um + L/50"; empty without one
  Judged as_found;
  std::optional<Judged> as_left;  ///< where a second arm was given
  std::vector<TestBudget> budgets;
  std::optional<MaximumPermissibleError> mpe = {};  ///< that limit, for every length
  std::string artefact = {};                        ///< name of what was measured; empty: a seat

  /// What counts: as left, where that was judged.
  [[nodiscard]] const Judged& judged() const { return as_left ? *as_left : as_found; }
};

/// Everything that the tests of one standard said of an arm.
struct Verification {
  std::string name;      ///< of the file
  std::string standard;  ///< "ISO 10360-12:2016"
  std::string arm_file;  ///< empty: coordinates of the arm's own software
  std::string as_left_file;
  std::optional<double> reach_mm;
  DecisionRule rule;
  double coverage_factor = 2.0;
  std::vector<VerifiedStatistic> statistics;
  std::vector<StatedArtefact> artefacts;  ///< that these were measured on
  StatedEnvironment environment;
  /// Tests of the standard that the file does not hold: "articulated location error".
  std::vector<std::string> not_performed;

  /// The worst verdict: of the arm as left where there is one, else as found.
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] Verdict as_found_verdict() const;
};

}  // namespace armcal
