// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/symmetric_point/adjustment.h"
#include "armcal/symmetric_point/chain.h"
#include "armcal/symmetric_point/claims.h"
#include "armcal/symmetric_point/leakage.h"
#include "armcal/symmetric_point/reduction.h"
#include "armcal/symmetric_point/sign_search.h"

namespace armcal {

/// Everything that the symmetric-point procedure has to say about one arm.
struct SymmetricPointAnalysis {
  ArmModel nominal;                    ///< with its signs settled
  std::vector<SignCombination> signs;  ///< all tried, best first; one where no sign was in doubt
  std::vector<SymmetricReading> readings;  ///< reduced
  std::vector<Reduction> reductions;       ///< how each raw reading became a value
  Eigen::VectorXd predicted_by_nominal;    ///< of each reading, mm or rad
  std::optional<Chain> chain;              ///< where readings name what they solve
  Adjustment adjustment;
  std::vector<ClaimCheck> claims;
  Leakage leakage;  ///< of the chain where it is complete, else of the adjustment
  bool leakage_of_chain = false;
  /// A second arm held against the readings, where one was given.
  std::optional<ArmModel> compared;
  Eigen::VectorXd predicted_by_compared;

  /// No reading flagged and every claim agrees.
  [[nodiscard]] bool is_consistent() const;
};

/// Settles signs, reduces raw readings, solves the chain, adjusts, and checks claims.
/// @param procedure  checked against `nominal` (check_against_arm)
/// @param compared   an arm whose lengths are held against the readings as claims (instead of the
/// file's)
/// @return nothing where raw readings cannot be reduced; the reasons are in `diagnostics`
[[nodiscard]] std::optional<SymmetricPointAnalysis> analyse_symmetric_points(
    const SymmetricPointProcedure& procedure, const ArmModel& nominal,
    const std::optional<ArmModel>& compared, Diagnostics& diagnostics);

}  // namespace armcal
