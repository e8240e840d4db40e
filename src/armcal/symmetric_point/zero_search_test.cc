// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/zero_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/core/random.h"
#include "armcal/core/units.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

// Radius about the axis of `sweep` as function of the setting of `joint`, the rest at 0.
std::function<double(double)> radius_of(ArmModel arm, int joint, int sweep) {
  return [arm = std::move(arm), joint, sweep](double setting) {
    Eigen::VectorXd posture = Eigen::VectorXd::Zero(6);
    posture(joint - 1) = setting;
    return predict(arm, testing::circle_radius("r", sweep, posture)).value;
  };
}

std::function<double(double)> squared(std::function<double(double)> f) {
  return [f = std::move(f)](double x) { return f(x) * f(x); };
}

std::vector<RadiusAtSetting> radii_at(const std::function<double(double)>& radius,
                                      double center_deg, double half_span_deg, int count,
                                      double sigma, RandomStream& random) {
  std::vector<RadiusAtSetting> radii;
  for (int i = 0; i < count; ++i) {
    const double setting =
        radians_from_degrees(center_deg - half_span_deg + 2 * half_span_deg * i / (count - 1));
    radii.push_back({setting, radius(setting) + sigma * random.normal(), std::max(sigma, 1e-6)});
  }
  return radii;
}

TEST(ZeroSearch, IsExactWithoutNoiseForNarrowAndWideSettings) {
  RandomStream random(1);
  // Joint 6 by circles of joint 5, joint 4 by joint 3, joint 2 by joint 1: as in the paper.
  for (const int joint : {6, 4, 2}) {
    ArmModel truth = testing::consistent_romer();
    truth.joints[static_cast<std::size_t>(joint - 1)].zero_rad = 0.012;
    const auto radius = radius_of(truth, joint, joint - 1);
    const auto nominal = squared(radius_of(testing::consistent_romer(), joint, joint - 1));
    SymmetricReading search = testing::circle_radius("z", joint, Eigen::VectorXd::Zero(6));
    search.kind = SymmetricKind::zero_search;
    search.sweep = joint - 1;
    search.reduced = false;
    const double expected = predict(truth, search).value;
    const double center = degrees_from_radians(expected) + 2.0;
    for (const auto& [span, count] :
         {std::pair{10.0, 5}, std::pair{170.0, 18}, std::pair{4.0, 3}}) {
      const auto result =
          search_zero(radii_at(radius, center, span, count, 0.0, random), nominal, expected);
      ASSERT_TRUE(result.ok()) << joint << " " << span << " " << explain(result.status);
      EXPECT_NEAR(result.setting_rad, expected, 1e-9) << joint << " " << span;
      EXPECT_EQ(result.law, span > 60 ? ZeroLaw::full_wave : ZeroLaw::nominal_shape);
    }
  }
}

TEST(ZeroSearch, UncertaintyIsWhatSimulationShows) {
  RandomStream random(2);
  const auto radius = radius_of(testing::consistent_romer(), 6, 5);
  const double expected = std::atan2(-25.962, 176.484);
  for (const auto& [span, count] : {std::pair{12.0, 7}, std::pair{120.0, 13}}) {
    double sum = 0.0;
    const int trials = 600;
    for (int t = 0; t < trials; ++t) {
      const auto radii = radii_at(radius, -8.0, span, count, 0.003, random);
      auto result = search_zero(radii, squared(radius), expected);
      ASSERT_TRUE(result.ok());
      // Undo the widening by scatter, to compare with what the stated uncertainties alone promise.
      const double ratio = result.chi_squared / result.degrees_of_freedom;
      const double u = result.u_rad / std::sqrt(std::max(1.0, ratio));
      const double z = (result.setting_rad - expected) / u;
      sum += z * z / trials;
    }
    EXPECT_NEAR(sum, 1.0, 5.0 * std::sqrt(2.0 / trials)) << span;
  }
}

TEST(ZeroSearch, BeatsTheSmallestArc) {
  // Settings every 5 deg, none at the zero: the grid minimum is up to 2.5 deg off, the fit is not.
  RandomStream random(3);
  const auto radius = radius_of(testing::consistent_romer(), 6, 5);
  const double expected = std::atan2(-25.962, 176.484);  // -8.37 deg
  const auto radii = radii_at(radius, -6.0, 15.0, 7, 0.003, random);
  const auto result = search_zero(radii, squared(radius), expected);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result.is_minimum);
  EXPECT_LT(std::abs(result.setting_rad - expected), 5 * result.u_rad);
  EXPECT_LT(result.u_rad, radians_from_degrees(0.05));
}

TEST(ZeroSearch, WidensWhereTheRadiiScatterMoreThanStated) {
  RandomStream random(4);
  const auto radius = radius_of(testing::consistent_romer(), 6, 5);
  auto radii = radii_at(radius, -8.0, 15.0, 12, 0.05, random);
  const double honest = search_zero(radii, squared(radius), -0.146).u_rad;
  for (RadiusAtSetting& at : radii) at.u_mm = 0.005;
  const double corrected = search_zero(radii, squared(radius), -0.146).u_rad;
  EXPECT_GT(corrected, 0.4 * honest);
}

TEST(ZeroSearch, RefusesWithAReason) {
  RandomStream random(5);
  const auto radius = radius_of(testing::consistent_romer(), 6, 5);
  EXPECT_EQ(search_zero(radii_at(radius, 0, 5, 2, 0, random), squared(radius), 0).status,
            ZeroStatus::too_few_settings);
  const auto constant = [](double) { return 10.0; };
  EXPECT_EQ(search_zero(radii_at(constant, 0, 5, 5, 0, random), constant, 0).status,
            ZeroStatus::no_extremum);
  // Three settings within a tenth of a degree and noise: the radii say nothing.
  EXPECT_EQ(
      search_zero(radii_at(radius, -8, 0.05, 3, 0.05, random), squared(radius), -0.146).status,
      ZeroStatus::not_determined);
}

}  // namespace
}  // namespace armcal
