// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/test_uncertainty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace armcal {
namespace {

// A steel bar 2 K too warm.
const ArtefactCertificate kBar{.value_mm = 1000.0,
                               .U_mm = 0.002,
                               .coverage_factor = 2.0,
                               .expansion_per_k = 11.5e-6,
                               .u_expansion_per_k = 0.5e-6};
const TestEnvironment kWarm{.temperature_c = 22.0, .u_temperature_k = 0.3};

double u_of(const TestUncertainty& budget, UncertaintySource source) {
  for (const auto& each : budget.contributions) {
    if (each.source == source) return each.u_mm();
  }
  return 0.0;
}

TEST(TestUncertainty, OfALengthFollowsByHand) {
  EXPECT_NEAR(value_at_temperature_mm(kBar, kWarm), 1000.023, 1e-12);
  const TestUncertainty budget = length_error_uncertainty(kBar, kWarm);
  ASSERT_EQ(budget.contributions.size(), 3u);
  EXPECT_NEAR(u_of(budget, UncertaintySource::certificate), 0.001, 1e-15);
  EXPECT_NEAR(u_of(budget, UncertaintySource::temperature), 0.00345, 1e-15);
  EXPECT_NEAR(u_of(budget, UncertaintySource::expansion), 0.001, 1e-15);
  // sqrt(0.001^2 + 0.00345^2 + 0.001^2)
  EXPECT_NEAR(budget.combined_mm(), 0.003728605637, 1e-12);
  EXPECT_NEAR(budget.with_factor(2.0).expanded(), 0.007457211275, 1e-12);
  EXPECT_TRUE(std::isinf(budget.effective_degrees_of_freedom()));
  EXPECT_NEAR(budget.at_level(0.95).coverage_factor, 1.959963984540054, 1e-12);
}

TEST(TestUncertainty, FormCountsTwiceInADiameterAndHalfInAForm) {
  const ArtefactCertificate sphere{.value_mm = 25.0, .U_mm = 0.0004, .form_mm = 0.0002};
  const TestUncertainty size = probing_size_uncertainty(sphere, {});
  EXPECT_NEAR(u_of(size, UncertaintySource::form), 0.0002 / std::sqrt(3.0), 1e-18);
  EXPECT_NEAR(size.combined_mm(), std::hypot(0.0002, 0.0002 / std::sqrt(3.0)), 1e-18);
  EXPECT_EQ(probing_form_uncertainty(sphere).combined_mm(), 0.0001);
  EXPECT_EQ(location_uncertainty(sphere).combined_mm(), 0.0001);
  EXPECT_TRUE(probing_form_uncertainty({.value_mm = 25.0}).contributions.empty());
  EXPECT_EQ(probing_form_uncertainty({.value_mm = 25.0}).combined_mm(), 0.0);
}

TEST(TestUncertainty, EffectiveFreedomIsThatOfTheGumsExample) {
  // GUM H.1.6: u_c = 32 nm from 25 (18 dof), 9.7 (25.6), 2.9 (50), 16.6 (2): 16.7.
  const auto part = [](double u, double freedom) {
    return UncertaintyContribution{.name = "", .u = u, .degrees_of_freedom = freedom};
  };
  const TestUncertainty endgauge{
      {part(25.0, 18.0), part(9.7, 25.6), part(2.9, 50.0), part(16.6, 2.0)}};
  EXPECT_NEAR(endgauge.combined_mm(), 31.7, 0.1);
  EXPECT_NEAR(endgauge.effective_degrees_of_freedom(), 16.7, 0.3);  // the GUM works with 32
  // Student's t for 99 % and 16 degrees of freedom is 2.92.
  EXPECT_NEAR(endgauge.at_level(0.99).coverage_factor, 2.92, 0.02);
}

TEST(TestUncertainty, RepeatabilityIsThatOfTheMean) {
  const auto repeats = repeatability_of_mean(std::array{1.0, 2.0, 3.0, 4.0});
  EXPECT_NEAR(repeats.u, std::sqrt(5.0 / 3.0 / 4.0), 1e-15);
  EXPECT_EQ(repeats.degrees_of_freedom, 3.0);
  TestUncertainty alone;
  alone.contributions.push_back(repeats);
  EXPECT_NEAR(alone.at_level(0.95).coverage_factor, 3.182446305284263, 1e-12);  // t for 3
}

TEST(TestUncertainty, CoolerOrWarmerIsEquallyUncertain) {
  const auto cold = length_error_uncertainty(kBar, {.temperature_c = 18.0, .u_temperature_k = 0.3});
  EXPECT_NEAR(cold.combined_mm(), length_error_uncertainty(kBar, kWarm).combined_mm(), 1e-15);
  EXPECT_NEAR(value_at_temperature_mm(kBar, {.temperature_c = 18.0}), 999.977, 1e-12);
}

TEST(TestUncertainty, RefusesNonsense) {
  const auto refuses = [](const ArtefactCertificate& artefact, const TestEnvironment& environment) {
    EXPECT_THROW(static_cast<void>(length_error_uncertainty(artefact, environment)),
                 std::invalid_argument);
  };
  refuses({.value_mm = 0.0}, {});
  refuses({.value_mm = 1.0, .U_mm = -1.0}, {});
  refuses({.value_mm = 1.0, .coverage_factor = 0.0}, {});
  refuses({.value_mm = 1.0, .form_mm = NAN}, {});
  refuses({.value_mm = 1.0}, {.temperature_c = NAN});
  refuses({.value_mm = 1.0}, {.u_temperature_k = -0.1});
  EXPECT_THROW(static_cast<void>(repeatability_of_mean(std::array{1.0})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(TestUncertainty{}.with_factor(0.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(TestUncertainty{}.at_level(1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace armcal
