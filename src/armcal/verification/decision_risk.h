// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/verification/decision_rule.h"

namespace armcal {

/// What is known of the things judged before one is measured, and how it is measured: both normal.
struct MeasuringProcess {
  double mean = 0.0;                ///< of the true values
  double standard_deviation = 0.0;  ///< of the true values
  double u = 0.0;                   ///< standard uncertainty of one measurement
};

/// Shares of all things judged.
struct DecisionRisk {
  double false_acceptance = 0.0;  ///< global consumer's risk, "PFA"
  double false_rejection = 0.0;   ///< global producer's risk, "PFR"
  double accepted = 0.0;          ///< share that is accepted at all
  /// Share of the accepted that does not conform.
  [[nodiscard]] double false_among_accepted() const { return false_acceptance / accepted; }
};

/// How often a rule errs (JCGM 106:2012, 3.3.15, 3.3.16, 9.5). theory/verification.md eq. (14).
///
/// By quadrature over the true values, to 1e-10 absolute. Agrees with the table of NCSLI RP-19 and
/// Deaver's example.
/// @param tolerance   what a true value must keep
/// @param acceptance  what a measured value must keep to be accepted
/// @throws std::invalid_argument unless both standard deviations are finite and positive
[[nodiscard]] DecisionRisk decision_risk(const MeasuringProcess& process,
                                         const ToleranceLimits& tolerance,
                                         const ToleranceLimits& acceptance);

}  // namespace armcal
