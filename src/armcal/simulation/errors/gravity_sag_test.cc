// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/gravity_sag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kLength = 800.0;
constexpr double kProbe = 200.0;
constexpr double kMass = 2.0;
constexpr double kWeight = kMass * kGravity_m_per_s2;
const Vector3d kDown = -Vector3d::UnitZ();

// A link along x and a probe whose mass is at its tip, in the same line or across.
ArmState two_parts(const Vector3d& probe = {kProbe, 0.0, 0.0}) {
  ArmState state;
  state.joints.resize(2);
  state.links.resize(2);
  state.links[0].way_mm = {kLength, 0.0, 0.0};
  state.links[1].way_mm = probe;
  return state;
}

Vector3d deflection(ArmState state, const std::vector<LinkBody>& bodies,
                    const Vector3d& down = kDown) {
  const Vector3d tip = frames_of(state).tip_mm;
  add_sag(state, bodies, down);
  return frames_of(state).tip_mm - tip;
}

const LinkBody kMassAtTip{.mass_kg = kMass, .centre = 1.0};

// Deflections are some tenths of a mm on 1 m; what is quadratic in them is below 1e-3 of them.
constexpr double kSmall = 1e-3;

TEST(GravitySag, BendsACantileverWithALoadBeyondItsEnd) {
  const double c = 1e-10;
  const double drop = deflection(two_parts(), {{.bending_per_N_mm2 = c}, kMassAtTip}).z();
  // End: F L^3 / 3 + M L^2 / 2 with M = F p; slope: F L^2 / 2 + M L; the probe follows it stiffly.
  const double moment = kWeight * kProbe;
  const double end = kWeight * std::pow(kLength, 3) / 3.0 + moment * kLength * kLength / 2.0;
  const double slope = kWeight * kLength * kLength / 2.0 + moment * kLength;
  EXPECT_NEAR(drop, -c * (end + slope * kProbe), kSmall * std::abs(drop));
}

TEST(GravitySag, BendsALinkUnderItsOwnMass) {
  const double c = 1e-10;
  const LinkBody link{.mass_kg = kMass, .centre = 0.5, .bending_per_N_mm2 = c};
  const double drop = deflection(two_parts(), {link, {}}).z();
  // Load half way: F a^2 (3 L - a) / 6 at the end, slope F a^2 / 2, a = L / 2.
  const double a = kLength / 2.0;
  const double end = kWeight * a * a * (3.0 * kLength - a) / 6.0;
  EXPECT_NEAR(drop, -c * (end + kWeight * a * a / 2.0 * kProbe), kSmall * std::abs(drop));
}

TEST(GravitySag, TwistsALinkWhoseLoadIsAside) {
  const double c = 1e-10;
  const ArmState bent = two_parts({0.0, kProbe, 0.0});
  const double drop = deflection(bent, {{.torsion_per_N_mm2 = c}, kMassAtTip}).z();
  EXPECT_NEAR(drop, -c * kWeight * kProbe * kLength * kProbe, kSmall * std::abs(drop));
  // In line nothing is twisted.
  EXPECT_EQ(deflection(two_parts(), {{.torsion_per_N_mm2 = c}, kMassAtTip}).norm(), 0.0);
}

TEST(GravitySag, TiltsBearingsAcrossTheirAxesOnly) {
  const double c = 1e-8;
  const double reach = kLength + kProbe;
  const std::vector<LinkBody> bodies = {{.bearing_rad_per_N_mm = c}, kMassAtTip};
  ArmState state = two_parts();
  state.joints[0].angle_rad = 0.6;  // the tilt is stated before this rotation
  const double drop = deflection(state, bodies).z();
  EXPECT_NEAR(drop, -c * kWeight * reach * reach, kSmall * std::abs(drop));
  // On a wall the weight turns the joint about its axis, which the encoder reads.
  EXPECT_EQ(deflection(two_parts(), bodies, -Vector3d::UnitY()).norm(), 0.0);
}

TEST(GravitySag, FollowsGravity) {
  const std::vector<LinkBody> bodies = {{.bending_per_N_mm2 = 1e-10}, kMassAtTip};
  const double drop = -deflection(two_parts(), bodies).z();
  const Vector3d on_a_wall = deflection(two_parts(), bodies, Vector3d::UnitY());
  EXPECT_NEAR(on_a_wall.y(), drop, kSmall * drop);
  // Hanging straight down nothing bends.
  EXPECT_EQ(deflection(two_parts(), bodies, Vector3d::UnitX()).norm(), 0.0);
}

TEST(GravitySag, IsTheSumOfWhatEachMassDoes) {
  const LinkBody soft{
      .bending_per_N_mm2 = 1e-11, .torsion_per_N_mm2 = 2e-11, .bearing_rad_per_N_mm = 1e-9};
  const auto with_masses = [&](double first, double second) {
    std::vector<LinkBody> bodies = {soft, soft};
    bodies[0].mass_kg = first;
    bodies[1].mass_kg = second;
    return deflection(two_parts({100.0, 150.0, -50.0}), bodies);
  };
  const Vector3d both = with_masses(3.0, 1.0);
  EXPECT_LT((both - with_masses(3.0, 0.0) - with_masses(0.0, 1.0)).norm(), kSmall * both.norm());
}

TEST(GravitySag, TypicalBodiesOfAnArmAreTubesWithJointsAtTheirEnds) {
  const ArmModel arm = testing::consistent_romer();
  const GravitySag sag = GravitySag::typical();
  const auto bodies = bodies_of(arm, sag);
  ASSERT_EQ(bodies.size(), 6U);
  const double tube = sag.tube_kg_per_mm * 747.489;
  EXPECT_NEAR(bodies[1].mass_kg, tube + 0.5, 1e-12);
  EXPECT_NEAR(bodies[1].centre * bodies[1].mass_kg, 0.5 * tube + 0.5, 1e-12);
  EXPECT_EQ(bodies[0].mass_kg, 0.5);  // no tube between joints of one origin
  EXPECT_EQ(bodies[5].mass_kg, 0.3);
  // Stretched out level such an arm sags by some tenths of a mm.
  const Eigen::VectorXd level = testing::degrees({0, 90, 0, 90, 0, 0});
  ArmState state = state_of(arm, {level.data(), 6});
  const double drop = -deflection(state, bodies).z();
  EXPECT_GT(std::abs(drop), 0.02);
  EXPECT_LT(std::abs(drop), 1.0);
}

TEST(GravitySag, RefusesAnotherNumberOfLinks) {
  const GravitySag sag{.links = {{.mass_kg = 1.0}, {.mass_kg = 1.0}}};
  EXPECT_TRUE(sag.is_on());
  try {
    (void)bodies_of(testing::consistent_romer(), sag);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "sag is given for 2 links, but arm \"ROMER Infinite 2.0\" has 6 (the last leads "
                 "to the tip)");
  }
}

}  // namespace
}  // namespace armcal
