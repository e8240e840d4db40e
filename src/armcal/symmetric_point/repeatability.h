// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/symmetric_point/reduction.h"

namespace armcal {

/// The same machine took the repeats of all half turns, so they share one spread: of a few repeats
/// alone it would be far too small or too large by chance, and the tests of the readings would
/// alarm for nothing. The shared variance is the median of those of the readings, each over the
/// median of chi-squared for its degrees of freedom, so that a blunder in one reading does not
/// touch the others. Replaces `u_type_a` of half turns by the shared one; readings that scatter
/// more than chance allows (probability 1e-4) keep their own. Needs 20 degrees of freedom from
/// three readings, else nothing is changed. theory/symmetric_point.md eq. (28).
void share_repeatability(std::vector<Reduction>& reductions);

}  // namespace armcal
