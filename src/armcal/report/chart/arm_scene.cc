// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/arm_scene.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/units.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kMostPostures = 500;
constexpr double kLongVector = 0.12;  // of the reach

OrderedJson finite_or_null(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

template <typename Vector>
OrderedJson numbers_of(const Vector& vector) {
  OrderedJson list = OrderedJson::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) list.push_back(finite_or_null(vector(i)));
  return list;
}

OrderedJson rows_of(const RigidTransform& pose) {
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = decltype(matrix)::Identity();
  matrix.topLeftCorner<3, 3>() = pose.rotation;
  matrix.topRightCorner<3, 1>() = pose.translation_mm;
  return numbers_of(matrix.reshaped<Eigen::RowMajor>());
}

OrderedJson live_json(const Joint& joint) {
  OrderedJson harmonics = OrderedJson::array();
  for (const Harmonic& term : joint.harmonics) harmonics.push_back({term.cos_rad, term.sin_rad});
  return {{"zero_deg", degrees_from_radians(joint.zero_rad)},
          {"direction", joint.direction},
          {"min_deg", finite_or_null(degrees_from_radians(joint.min_rad))},
          {"max_deg", finite_or_null(degrees_from_radians(joint.max_rad))},
          {"harmonics", std::move(harmonics)}};
}

OrderedJson live_json(const ArmModel& arm) {
  OrderedJson joints = OrderedJson::array();
  for (const Joint& joint : arm.joints) joints.push_back(live_json(joint));
  OrderedJson links = OrderedJson::array();
  for (const Link& link : arm.links) {
    links.push_back({{"d_mm", link.d_mm},
                     {"b_mm", link.b_mm},
                     {"a_mm", link.a_mm},
                     {"alpha_deg", degrees_from_radians(link.alpha_rad)},
                     {"beta_deg", degrees_from_radians(link.beta_rad)}});
  }
  return {{"name", arm.name},
          {"base_from_first_joint", rows_of(arm.base_from_first_joint)},
          {"joints", std::move(joints)},
          {"links", std::move(links)},
          {"tip", {{"a_mm", arm.tip.a_mm}, {"b_mm", arm.tip.b_mm}, {"d_mm", arm.tip.d_mm}}}};
}

OrderedJson live_json(const ScenePosture& posture, const ForwardKinematics& kinematics) {
  const std::span readings(posture.q_rad.data(), static_cast<std::size_t>(posture.q_rad.size()));
  return {{"name", posture.name},
          {"q_deg", numbers_of(posture.q_rad.unaryExpr(&degrees_from_radians))},
          {"tip_mm", numbers_of(kinematics.tip_in_base(readings))},
          {"residual_mm",
           posture.residual_mm ? numbers_of(*posture.residual_mm) : OrderedJson(nullptr)},
          {"check", posture.is_check}};
}

const char* name_of(ArtefactShape shape) {
  switch (shape) {
    case ArtefactShape::sphere:
      return "sphere";
    case ArtefactShape::bar:
      return "bar";
    case ArtefactShape::point:
      break;
  }
  return "point";
}

OrderedJson live_json(const SceneArtefact& artefact) {
  return {{"kind", name_of(artefact.shape)},
          {"name", artefact.name},
          {"at_mm", numbers_of(artefact.at_mm)},
          {"to_mm", numbers_of(artefact.to_mm)},
          {"radius_mm", finite_or_null(artefact.radius_mm)}};
}

double residual_of(const ScenePosture& posture) {
  const double length = posture.residual_mm ? posture.residual_mm->norm() : 0.0;
  return std::isfinite(length) ? length : 0.0;
}

// In the order of the scene.
std::vector<std::size_t> told_postures(const ArmScene& scene) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < scene.postures.size(); ++i) {
    if (can_stand(scene.arm, scene.postures[i])) all.push_back(i);
  }
  if (all.size() <= kMostPostures) return all;
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
    return residual_of(scene.postures[a]) > residual_of(scene.postures[b]);
  });
  const std::size_t half = kMostPostures / 2;
  std::sort(all.begin() + half, all.end());
  std::vector<std::size_t> told(all.begin(), all.begin() + half);
  const std::size_t others = all.size() - half;
  for (std::size_t k = 0; k < kMostPostures - half; ++k) {
    told.push_back(all[half + k * others / (kMostPostures - half)]);
  }
  std::sort(told.begin(), told.end());
  return told;
}

}  // namespace

bool can_stand(const ArmModel& arm, const ScenePosture& posture) {
  return posture.q_rad.size() == arm.joint_count() && posture.q_rad.allFinite() &&
         problems_of(arm).empty();
}

std::string live_scene(const ArmScene& scene) {
  OrderedJson postures = OrderedJson::array();
  if (problems_of(scene.arm).empty()) {
    const ForwardKinematics kinematics(scene.arm);
    for (const std::size_t i : told_postures(scene)) {
      postures.push_back(live_json(scene.postures[i], kinematics));
    }
  }
  OrderedJson artefacts = OrderedJson::array();
  for (const SceneArtefact& artefact : scene.artefacts) artefacts.push_back(live_json(artefact));
  const OrderedJson json = {
      {"kind", "scene"},
      {"arm", live_json(scene.arm)},
      {"nominal", scene.nominal ? live_json(*scene.nominal) : OrderedJson(nullptr)},
      {"postures", std::move(postures)},
      {"turning_joint", scene.turning_joint ? OrderedJson(*scene.turning_joint) : OrderedJson()},
      {"artefacts", std::move(artefacts)},
      {"enlargement", scene.enlargement}};
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

double nice_enlargement(const ArmScene& scene) {
  std::vector<double> residuals;
  for (const ScenePosture& posture : scene.postures) {
    const double residual = residual_of(posture);
    if (residual > 0.0) residuals.push_back(residual);
  }
  if (residuals.empty()) return 1.0;
  const std::size_t place = (residuals.size() - 1) * 19 / 20;
  std::nth_element(residuals.begin(), residuals.begin() + static_cast<std::ptrdiff_t>(place),
                   residuals.end());
  const double wanted = kLongVector * reach_mm(scene.arm) / residuals[place];
  if (!std::isfinite(wanted) || wanted <= 1.0) return 1.0;
  // The largest step that is not above: 10 over the least that is not below 10 over it.
  return std::max(1.0, std::round(10.0 / nice_step(10.0 / wanted)));
}

}  // namespace armcal
