// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/contact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/geometry/plane.h"
#include "armcal/geometry/sphere.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/simulation/artefacts/calibrated_sphere.h"
#include "armcal/simulation/artefacts/flat_surface.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

std::vector<TipLinearisation> tips_of(const ObservationGroup& group, const ArmModel& truth) {
  const ForwardKinematics kinematics(truth);
  std::vector<TipLinearisation> tips;
  for (Eigen::Index i = 0; i < group.count(); ++i) {
    const auto posture = group.encoder_rad.col(i);
    tips.push_back(kinematics.linearise(as_span(posture)));
  }
  return tips;
}

std::vector<Eigen::Vector3d> points_of(const std::vector<TipLinearisation>& tips) {
  std::vector<Eigen::Vector3d> points;
  for (const TipLinearisation& tip : tips) points.push_back(tip.tip_mm);
  return points;
}

TEST(Contact, WithASphereKeepsTheTipItsRadiusAwayAndTheWristOutside) {
  for (const ArmModel& arm : {testing::nominal_romer(), seven_joint_arm()}) {
    Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 3);
    const CalibratedSphere sphere{
        .diameter_mm = 40.0, .tip_radius_mm = 2.0, .placements = 1, .u_mm = 0.0};
    const auto tips = tips_of(measure(laboratory, sphere).front(), arm);
    const SphereFit fit = fit_sphere(points_of(tips));
    EXPECT_NEAR(fit.radius_mm, 22.0, 1e-8);
    EXPECT_LT(fit.form_mm, 1e-7);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const TipLinearisation& tip : tips) {
      const Eigen::Vector3d outward = (tip.tip_mm - fit.center_mm).normalized();
      mean += outward / static_cast<double>(tips.size());
      EXPECT_GT(outward.dot(tip.joint_origins_mm.rightCols<1>() - tip.tip_mm), 0.0);
    }
    // On one half of it: the other is the stem's. The mean of a half sphere is half its radius out.
    for (const TipLinearisation& tip : tips) {
      EXPECT_GT((tip.tip_mm - fit.center_mm).dot(mean.normalized()), -15.0);
    }
    EXPECT_NEAR(mean.norm(), 0.5, 0.15);
  }
}

TEST(Contact, WithAPlaneStaysOnItsFreeSide) {
  const ArmModel arm = testing::nominal_romer();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 4);
  const FlatSurface surface{.size_mm = 300.0, .placements = 1, .points = 40, .u_mm = 0.0};
  const auto tips = tips_of(measure(laboratory, surface).front(), arm);
  const PlaneFit fit = fit_plane(points_of(tips));
  EXPECT_LT(fit.form_mm, 1e-7);
  int above = 0;
  for (const TipLinearisation& tip : tips) {
    above += fit.normal.dot(tip.joint_origins_mm.rightCols<1>() - tip.tip_mm) > 0.0;
    EXPECT_LT((tip.tip_mm - tips.front().tip_mm).norm(), 300.0 * std::sqrt(2.0));
  }
  EXPECT_TRUE(above == 0 || above == 40) << above;
}

// Whatever bends and moves the arm, the tip is where the sphere has it; the model is what is wrong.
TEST(Contact, HoldsTheTipAgainstAllErrorsOfTheArm) {
  const ArmModel arm = testing::nominal_romer();
  ErrorSources errors;
  errors.probing_force = ProbingForce::typical();
  const CalibratedSphere sphere{.placements = 1, .points = 40, .u_mm = 0.0};
  Laboratory laboratory(VirtualArm(arm, arm, errors, 1), 6);
  const SphereFit fit = fit_sphere(points_of(tips_of(measure(laboratory, sphere).front(), arm)));
  // The arm yields by 12 um, the stylus by up to 8 um more: the encoders are that much inside.
  EXPECT_LT(fit.radius_mm, 12.7 + 3.0 - 0.01);
  EXPECT_GT(fit.radius_mm, 12.7 + 3.0 - 0.03);
}

std::string refusal(const Feature& feature) {
  const ArmModel arm = testing::nominal_romer();
  Laboratory laboratory(VirtualArm(arm, arm, {}, 1), 5);
  EXPECT_FALSE(is_within_reach(laboratory, feature));
  try {
    static_cast<void>(take_on(laboratory, feature, "sphere-1: " + feature.name));
  } catch (const Impossible& impossible) {
    return impossible.what();
  }
  return "taken";
}

TEST(Contact, IsRefusedWithTheReason) {
  // The wrist ends 177 mm short of the reach of 1463 mm.
  const Eigen::Vector3d far_out(1400.0, 0.0, 0.0);
  EXPECT_EQ(refusal({"point 1", far_out, Eigen::Vector3d::UnitX()}),
            "sphere-1: point 1 at (1400.0, 0.0, 0.0) mm is reached from behind only");
  EXPECT_THAT(
      refusal({"point 2", 1.1 * far_out, Eigen::Vector3d::Zero()}),
      ::testing::StartsWith("sphere-1: point 2 at (1540.0, 0.0, 0.0) mm cannot be reached"));
}

}  // namespace
}  // namespace armcal
