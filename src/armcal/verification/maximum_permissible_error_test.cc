// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/maximum_permissible_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace armcal {
namespace {

TEST(MaximumPermissibleError, HasThreeForms) {
  const auto constant = MaximumPermissibleError::constant(0.030);
  EXPECT_EQ(constant.at(0.0), 0.030);
  EXPECT_EQ(constant.at(5000.0), 0.030);
  EXPECT_FALSE(constant.depends_on_length());
  // 20 um + 1000/50 um = 40 um.
  const auto linear = MaximumPermissibleError::linear(0.020, 50.0);
  EXPECT_NEAR(linear.at(1000.0), 0.040, 1e-17);
  EXPECT_EQ(linear.at(0.0), 0.020);
  EXPECT_TRUE(linear.depends_on_length());
  // The line meets 80 um at 3 m.
  const auto lesser = MaximumPermissibleError::lesser(0.020, 50.0, 0.080);
  EXPECT_NEAR(lesser.at(2999.0), 0.07998, 1e-15);
  EXPECT_EQ(lesser.at(3001.0), 0.080);
}

TEST(MaximumPermissibleError, IsWrittenAsOnDataSheets) {
  EXPECT_EQ(MaximumPermissibleError::constant(0.0301).text(), "30.1 um");
  EXPECT_EQ(MaximumPermissibleError::linear(0.005, 200.0).text(), "5 um + L/200");
  EXPECT_EQ(MaximumPermissibleError::lesser(0.02, 50.0, 0.08).text(), "min(20 um + L/50, 80 um)");
}

TEST(MaximumPermissibleError, RefusesNonsenseInWords) {
  const auto message = [](auto&& make) -> std::string {
    try {
      static_cast<void>(make());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  using Limit = MaximumPermissibleError;
  EXPECT_EQ(message([] { return Limit::constant(0.0); }), "limit 0 mm: must be larger than 0");
  EXPECT_EQ(message([] { return Limit::constant(NAN); }), "limit nan mm: must be larger than 0");
  EXPECT_EQ(message([] { return Limit::linear(-0.1, 50.0); }),
            "limit A + L/K: A = -0.1 mm must not be negative");
  EXPECT_EQ(message([] { return Limit::linear(0.1, 0.0); }),
            "limit A + L/K: K = 0 must be larger than 0");
  EXPECT_EQ(message([] { return Limit::lesser(0.1, 50.0, 0.05); }),
            "limit min(A + L/K, B): B = 0.05 mm must be larger than A = 0.1 mm");
  EXPECT_EQ(message([] { return Limit::linear(0.1, 50.0).at(-1.0); }),
            "limit for a length of -1 mm: lengths are not negative");
}

}  // namespace
}  // namespace armcal
