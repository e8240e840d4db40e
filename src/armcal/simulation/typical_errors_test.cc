// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "armcal/arm/estimability.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/simulation/virtual_arm.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/wang2016_arm.h"

// How much each source of error in its typical size moves the tip, and how much of that a
// calibration of the geometry would leave: the table of docs/theory/virtual_arm.md.
namespace armcal {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kArms = 20;
constexpr int kReadings = 60;

struct Effect {
  double rms_mm = 0.0;   // of the tip against the drawing
  double left_mm = 0.0;  // when the geometry and the base frame are fitted to it
};

double rms(const VectorXd& coordinates) {
  return std::sqrt(3.0 * coordinates.squaredNorm() / static_cast<double>(coordinates.size()));
}

// Columns of the parameters that a calibration would seek, and of the base frame.
Eigen::MatrixXd sought(const ArmModel& drawing, const TipLinearisation& at) {
  const ParameterTable table(drawing);
  Eigen::MatrixXd columns(3, table.size() + 6);
  Eigen::Index count = 0;
  for (int i = 0; i < table.size(); ++i) {
    if (!held_by_convention(drawing, table[i])) columns.col(count++) = at.J_tip_parameters.col(i);
  }
  columns.middleCols<3>(count) = Eigen::Matrix3d::Identity();
  columns.middleCols<3>(count + 3) = skew(at.tip_mm);
  return columns.leftCols(count + 6);
}

Effect effect_of(const ErrorSource& source) {
  const ArmModel drawing = testing::consistent_romer();
  const ForwardKinematics kinematics(drawing);
  ErrorSources errors;
  source.switch_on(errors);
  VectorXd all(3 * kReadings * kArms);
  VectorXd left(3 * kReadings * kArms);
  for (int a = 0; a < kArms; ++a) {
    RandomStream random(static_cast<std::uint64_t>(a), 500);
    const VirtualArm arm(drawing, errors, static_cast<std::uint64_t>(a));
    Eigen::MatrixXd jacobian;
    VectorXd off(3 * kReadings);
    for (int i = 0; i < kReadings; ++i) {
      VectorXd e(6);
      for (double& angle : e) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      Vector3d push;
      for (double& component : push) component = random.normal();
      const Circumstances now{.time_s = random.uniform(0.0, 3600.0),
                              .push = push.normalized(),
                              .base_movement = drawn_movement(errors.base_movement, random)};
      const VectorXd shown = arm.shown(e, random);
      const TipLinearisation at = kinematics.linearise({shown.data(), 6});
      const Eigen::MatrixXd columns = sought(drawing, at);
      if (i == 0) jacobian.resize(3 * kReadings, columns.cols());
      jacobian.middleRows<3>(3 * i) = columns;
      off.segment<3>(3 * i) = arm.tip(e, now) - at.tip_mm;
    }
    all.segment(3 * kReadings * a, 3 * kReadings) = off;
    left.segment(3 * kReadings * a, 3 * kReadings) =
        off - jacobian * shortest_solution(jacobian, off, 1e-9).x;
  }
  return {rms(all), rms(left)};
}

TEST(TypicalErrors, MoveTheTipAsThePageSays) {
  const std::string page =
      testing::read_bytes(testing::repository() / "docs/theory/virtual_arm.md");
  for (const ErrorSource& source : error_source_list()) {
    if (source.name == "blunders") continue;
    const Effect effect = effect_of(source);
    const std::regex row(fmt::format(R"(\| `{}` \|.*\| ([0-9.]+) \| ([0-9.]+) \|)", source.name));
    std::smatch match;
    ASSERT_TRUE(std::regex_search(page, match, row)) << source.name;
    // The page gives um, rounded to two digits or to 0.1 um.
    const auto same = [](double um, double shown) {
      return std::abs(um - shown) < 0.06 * shown + 0.1;
    };
    EXPECT_TRUE(same(1000.0 * effect.rms_mm, std::stod(match[1])))
        << source.name << ' ' << effect.rms_mm;
    EXPECT_TRUE(same(1000.0 * effect.left_mm, std::stod(match[2])))
        << source.name << ' ' << effect.left_mm;
  }
}

}  // namespace
}  // namespace armcal
