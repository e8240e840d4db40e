// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/shown_number.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(ShownNumber, LengthsAreMillimetresAnglesDegreesAndHarmonicsMicroradians) {
  EXPECT_EQ(shown_unit("b3", "mm").unit, "mm");
  EXPECT_EQ(shown_unit("zero2", "rad").unit, "deg");
  EXPECT_NEAR(shown_unit("alpha2", "rad").factor, 57.29577951308232, 1e-12);
  EXPECT_EQ(shown_unit("cos1_3", "rad").unit, "urad");
  EXPECT_EQ(shown_unit("sin2_1", "rad").factor, 1e6);
}

TEST(ShownNumber, MicrometresGetTheirSignAndWordsStayWords) {
  EXPECT_EQ(with_micro_sign("min(30 um + L/40, 80 um)"), "min(30 \u00b5m + L/40, 80 \u00b5m)");
  EXPECT_EQ(with_micro_sign("1 um/N"), "1 \u00b5m/N");
  EXPECT_EQ(with_micro_sign("an umbrella um"), "an umbrella \u00b5m");
  EXPECT_EQ(with_micro_sign(""), "");
}

TEST(ShownNumber, CountsAreWhole) { EXPECT_EQ(whole(120.0), "120"); }

}  // namespace
}  // namespace armcal
