// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/invariant.h"

#include <gtest/gtest.h>

namespace {

TEST(Invariant, IsSilentWhenItHolds) { ARMCAL_INVARIANT(1 + 1 == 2); }

TEST(InvariantDeathTest, NamesTheBrokenPromiseAndThePlace) {
  EXPECT_DEATH(ARMCAL_INVARIANT(1 + 1 == 3),
               "invariant_test.cc:[0-9]+: armcal bug: this should always hold: 1 \\+ 1 == 3");
}

}  // namespace
