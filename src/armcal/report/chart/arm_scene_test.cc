// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/arm_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "armcal/testing/random_arms.h"
#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

ArmScene random_scene(int joints, int postures) {
  RandomStream random(11);
  ArmScene scene{.arm = testing::random_arm(joints, random)};
  for (int i = 0; i < postures; ++i) {
    const auto q = testing::random_posture(joints, random);
    ScenePosture posture{.name = std::to_string(i)};
    posture.q_rad = Eigen::Map<const Eigen::VectorXd>(q.data(), joints);
    posture.residual_mm = 0.05 * testing::random_normal_vector(random);
    scene.postures.push_back(posture);
  }
  return scene;
}

// The tip as a reader of the JSON computes it, by the formula of theory/kinematics.md alone.
Eigen::Vector3d tip_of(const nlohmann::json& arm, const nlohmann::json& q_deg) {
  const auto rad = [](const nlohmann::json& deg) {
    return deg.get<double>() * std::numbers::pi / 180.0;
  };
  Eigen::Affine3d pose;
  for (int i = 0; i < 16; ++i) {
    pose.matrix()(i / 4, i % 4) = arm["base_from_first_joint"][static_cast<std::size_t>(i)];
  }
  for (std::size_t i = 0; i < arm["joints"].size(); ++i) {
    const auto& joint = arm["joints"][i];
    const double e = rad(q_deg[i]);
    double angle = joint["direction"].get<int>() * (e + rad(joint["zero_deg"]));
    for (std::size_t k = 0; k < joint["harmonics"].size(); ++k) {
      const double order = static_cast<double>(k) + 1.0;
      angle += joint["harmonics"][k][0].get<double>() * std::cos(order * e) +
               joint["harmonics"][k][1].get<double>() * std::sin(order * e);
    }
    pose = pose * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
    const auto& step = i < arm["links"].size() ? arm["links"][i] : arm["tip"];
    pose = pose * Eigen::Translation3d(step["a_mm"], step["b_mm"], step["d_mm"]);
    if (i == arm["links"].size()) break;
    pose = pose * Eigen::AngleAxisd(rad(step["alpha_deg"]), Eigen::Vector3d::UnitX()) *
           Eigen::AngleAxisd(rad(step["beta_deg"]), Eigen::Vector3d::UnitY());
  }
  return pose.translation();
}

TEST(ArmScenes, AScriptFindsTheSameTips) {
  for (const int joints : {2, 6, 7, 10}) {
    const auto live = nlohmann::json::parse(live_scene(random_scene(joints, 5)));
    ASSERT_EQ(live["postures"].size(), 5u);
    for (const auto& posture : live["postures"]) {
      const Eigen::Vector3d tip = tip_of(live["arm"], posture["q_deg"]);
      for (const int axis : {0, 1, 2}) {
        // Rounding at a reach of some metres.
        EXPECT_NEAR(tip(axis), posture["tip_mm"][static_cast<std::size_t>(axis)].get<double>(),
                    1e-9);
      }
    }
  }
}

TEST(ArmScenes, OfManyPosturesTheWorstAreToldAndOthersBetween) {
  ArmScene scene = random_scene(3, 3000);
  scene.postures[1234].residual_mm = Eigen::Vector3d(9.0, 0.0, 0.0);
  const auto live = nlohmann::json::parse(live_scene(scene));
  ASSERT_EQ(live["postures"].size(), 500u);
  bool has_worst = false;
  int before = -1;
  for (const auto& posture : live["postures"]) {
    const int index = std::stoi(posture["name"].get<std::string>());
    EXPECT_GT(index, before);
    before = index;
    has_worst = has_worst || index == 1234;
  }
  EXPECT_TRUE(has_worst);
}

TEST(ArmScenes, WhatIsNotKnownIsNull) {
  ArmScene scene = random_scene(3, 2);
  scene.arm.joints[1].min_rad = -1.0;
  scene.postures[0].residual_mm.reset();
  scene.postures[1].name = "\xff" + std::string(testing::kHostileName);
  const auto live = nlohmann::json::parse(live_scene(scene));
  EXPECT_TRUE(live["nominal"].is_null());
  EXPECT_TRUE(live["postures"][0]["residual_mm"].is_null());
  EXPECT_TRUE(live["arm"]["joints"][0]["min_deg"].is_null());
  EXPECT_NEAR(live["arm"]["joints"][1]["min_deg"].get<double>(), -57.29577951308232, 1e-12);
}

TEST(ArmScenes, PosturesThatTheArmCannotTakeAreLeftOut) {
  ArmScene scene = random_scene(3, 4);
  scene.postures[0].q_rad.resize(2);
  scene.postures[1].q_rad(1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nlohmann::json::parse(live_scene(scene))["postures"].size(), 2u);
  scene.arm.links.clear();
  EXPECT_EQ(nlohmann::json::parse(live_scene(scene))["postures"].size(), 0u);
}

TEST(ArmScenes, EnlargementIsANiceNumberThatShowsLargeResiduals) {
  ArmScene scene = random_scene(6, 30);
  const double reach = reach_mm(scene.arm);
  for (const double size : {1e-6, 1e-3, 0.03, 1.0, 20.0}) {
    for (ScenePosture& posture : scene.postures) posture.residual_mm = Eigen::Vector3d(size, 0, 0);
    scene.postures[7].residual_mm = Eigen::Vector3d(0, 1e4 * size, 0);
    const double enlargement = nice_enlargement(scene);
    const double shown = enlargement * size / reach;
    EXPECT_LE(shown, 0.121) << size;
    EXPECT_GE(shown, 0.04) << size;
  }
  for (ScenePosture& posture : scene.postures) posture.residual_mm.reset();
  EXPECT_EQ(nice_enlargement(scene), 1.0);
}

}  // namespace
}  // namespace armcal
