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
/// more than chance allows (probability 1e-4) keep their own. Nothing is changed with fewer than 40
/// degrees of freedom or three readings, or where the others differ by more than chance as well
/// (Bartlett's test, 1e-3): an arm that gives way scatters more with a longer lever.
/// theory/symmetric_point.md eq. (28).
void share_repeatability(std::vector<Reduction>& reductions);

}  // namespace armcal
