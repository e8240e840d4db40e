// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/arm_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/report/chart/posture_drawing.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::SvgReader;

ArmDrawing random_drawing(int joints, int postures) {
  RandomStream random(5);
  ArmDrawing drawing{.id = "arm", .title = "Arm", .nothing = "no postures", .fit = "fit"};
  drawing.scene.arm = testing::random_arm(joints, random);
  for (int i = 0; i < postures; ++i) {
    const auto q = testing::random_posture(joints, random);
    ScenePosture posture{.name = std::to_string(i), .is_check = i % 3 == 0};
    posture.q_rad = Eigen::Map<const Eigen::VectorXd>(q.data(), joints);
    posture.residual_mm = 0.05 * testing::random_normal_vector(random);
    drawing.scene.postures.push_back(posture);
  }
  drawing.scene.enlargement = nice_enlargement(drawing.scene);
  return drawing;
}

TEST(ArmDrawings, EveryTipIsSeenAndTheArmIsNotCut) {
  for (const int joints : {2, 6, 7, 10}) {
    ArmDrawing drawing = random_drawing(joints, 100);
    drawing.scene.artefacts = {{ArtefactShape::sphere, "sphere", {500, 0, 0}, {}, 12.7},
                               {ArtefactShape::bar, "bar", {0, 500, 0}, {300, 500, 0}, 0.0},
                               {ArtefactShape::point, "seat", {0, -500, 0}, {}, 0.0}};
    const Figure figure = figure_of(drawing);
    const SvgReader svg(figure.svg);
    const auto is_inside = [&](const testing::SvgPlace& at) {
      return at.x >= 0.0 && at.x <= svg.width() && at.y >= 0.0 && at.y <= svg.height();
    };
    const auto tips = svg.starts("./path[starts-with(@class, 'dots')]");
    EXPECT_GE(tips.size(), 100u);
    EXPECT_TRUE(std::all_of(tips.begin(), tips.end(), is_inside));
    for (const char* part : {"./path[@class='link']", "./path[@class='joint']"}) {
      const auto places = svg.starts(part);
      EXPECT_GE(places.size(), static_cast<std::size_t>(joints - 1));
      EXPECT_TRUE(std::all_of(places.begin(), places.end(), is_inside));
    }
    EXPECT_TRUE(svg.says("sphere"));
    EXPECT_TRUE(svg.says("bar"));
    EXPECT_LT(figure.svg.size(), 60000u);
  }
}

// The enlargement stood in the title, where it stayed when the slider of the live scene changed it.
TEST(ArmDrawings, TheLegendSaysHowMuchResidualsAreEnlarged) {
  ArmDrawing drawing = random_drawing(6, 10);
  drawing.arrows = "residuals x 500";
  EXPECT_TRUE(SvgReader(figure_of(drawing).svg).says("residuals x 500"));
  for (ScenePosture& posture : drawing.scene.postures) posture.residual_mm.reset();
  EXPECT_FALSE(SvgReader(figure_of(drawing).svg).says("residuals x 500"));
}

TEST(ArmDrawings, OfAnArmThatCannotStandItIsSaid) {
  ArmDrawing drawing = random_drawing(6, 0);
  EXPECT_TRUE(SvgReader(figure_of(drawing).svg).says("no postures"));
  drawing = random_drawing(6, 2);
  drawing.scene.postures[0].q_rad(2) = std::numeric_limits<double>::infinity();
  drawing.shown = 99;
  EXPECT_FALSE(SvgReader(figure_of(drawing).svg).says("no postures"));
  drawing.scene.arm.links.clear();
  EXPECT_TRUE(SvgReader(figure_of(drawing).svg).says("no postures"));
}

TEST(ArmDrawings, HostileNamesAndPlacesAreDrawn) {
  ArmDrawing drawing = random_drawing(6, 3);
  drawing.title = drawing.text = drawing.fit = drawing.check = testing::kHostileName;
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  drawing.scene.artefacts = {{ArtefactShape::sphere, testing::kHostileName, {1, 2, 3}, {}, kNan},
                             {ArtefactShape::bar, "nowhere", {kNan, 0, 0}, {0, 0, 0}, 1.0},
                             {ArtefactShape::bar, "half", {1, 0, 0}, {0, kNan, 0}, 1.0}};
  drawing.scene.postures[1].residual_mm = Eigen::Vector3d(kNan, 0, 0);
  const SvgReader svg(figure_of(drawing).svg);
  EXPECT_EQ(svg.count("//script"), 0u);
  EXPECT_EQ(svg.root().select_node("//title").node().child("script"), pugi::xml_node());
}

TEST(ArmDrawings, AResidualThatIsFarTooLargeIsCutAndDashed) {
  ArmDrawing drawing = random_drawing(6, 30);
  EXPECT_EQ(SvgReader(figure_of(drawing).svg).count("./path[@stroke-dasharray='5 3']"), 0u);
  drawing.scene.postures[4].residual_mm = Eigen::Vector3d(0.0, 1e6, 0.0);
  EXPECT_EQ(SvgReader(figure_of(drawing).svg).count("./path[@stroke-dasharray='5 3']"), 1u);
}

TEST(ArmDrawings, AreTheSameEveryTime) {
  EXPECT_EQ(figure_of(random_drawing(7, 20)).svg, figure_of(random_drawing(7, 20)).svg);
}

TEST(HalfTurnDrawings, NameBothPosturesTheJointAndTheWayBetween) {
  RandomStream random(9);
  HalfTurnDrawing drawing{.id = "half",
                          .arm = testing::random_arm(6, random),
                          .joint = 3,
                          .joint_name = "joint 4",
                          .distance = "612.304 mm"};
  drawing.a_rad = drawing.b_rad = Eigen::VectorXd::Constant(6, 0.4);
  drawing.b_rad(3) += 3.14159;
  const SvgReader svg(figure_of(drawing).svg);
  for (const char* text : {"A", "B", "joint 4", "612.304 mm"}) EXPECT_TRUE(svg.says(text)) << text;
  EXPECT_GE(svg.count("./path[@class='ghost']"), 2u);
  drawing.joint = 77;
  drawing.b_rad.resize(2);
  drawing.nothing = "cannot be shown";
  EXPECT_TRUE(SvgReader(figure_of(drawing).svg).says("cannot be shown"));
}

TEST(StandingArms, HaveTheirTipWhereForwardKinematicsHasIt) {
  RandomStream random(2);
  const ArmModel arm = testing::random_arm(5, random);
  const auto q = testing::random_posture(5, random);
  const auto stands = standing(arm, Eigen::Map<const Eigen::VectorXd>(q.data(), 5));
  ASSERT_TRUE(stands);
  EXPECT_EQ(stands->joint_count(), 5);
  EXPECT_LT((stands->tip_mm - ForwardKinematics(arm).tip_in_base(q)).norm(), 1e-9);
}

}  // namespace
}  // namespace armcal
