// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/row_residuals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/core/units.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/synthetic_readings.h"

namespace armcal {
namespace {

using testing::SyntheticReadings;

ArmModel nominal_arm() {
  RandomStream random(41, 0);
  return testing::random_arm(
      6, random, {.arbitrary_twists = false, .beta = false, .harmonics = 0, .mount = true});
}

ArmModel true_arm() {
  RandomStream random(42, 0);
  return testing::perturbed(nominal_arm(), random, 1.0, radians_from_degrees(0.4));
}

const RowResidual& row_of(const Calibration& calibration, int group, int row) {
  for (const RowResidual& each : calibration.residuals) {
    if (each.group == group && each.row == row) return each;
  }
  ADD_FAILURE() << "no row " << row << " of group " << group;
  return calibration.residuals.front();
}

struct RowKindCase {
  const char* name;
  ObservationGroup (*make)(SyntheticReadings&);
};

const RowKindCase kPlacesInSpace[] = {
    {"reference_points", [](SyntheticReadings& s) { return s.reference_points(20, "B"); }},
    {"reference_poses", [](SyntheticReadings& s) { return s.reference_poses(20, "C"); }},
    {"fixed_point", [](SyntheticReadings& s) { return s.fixed_points({"P"}, 10); }},
    {"artefact", [](SyntheticReadings& s) { return s.artefact(5, 3, "flat"); }},
};
const RowKindCase kDistances[] = {
    {"reversal", [](SyntheticReadings& s) { return s.reversals(20); }},
    {"circle_radius", [](SyntheticReadings& s) { return s.circle_radii(20); }},
    {"sphere", [](SyntheticReadings& s) { return s.sphere(20, 40.0, true); }},
    {"plane", [](SyntheticReadings& s) { return s.plane(20); }},
};

// Noiseless readings of a kind beside reference points that tell the arm; one row is held out, and
// its encoders are set so that the calibrated arm has the point off by a known displacement.
class OneRowOff : public ::testing::TestWithParam<RowKindCase> {
 protected:
  static constexpr int kGroup = 1;
  static constexpr int kRow = 3;

  void calibrate_with_row_off_by(const Eigen::Vector3d& off_mm) {
    SyntheticReadings readings(true_arm(), 43, 0.0);
    groups_ = {readings.reference_points(60, "A"), GetParam().make(readings)};
    groups_[kGroup].is_check[kRow] = true;
    const Calibration before = calibrate(nominal_arm(), groups_, {});
    ASSERT_TRUE(before.ok()) << before.detail;
    ASSERT_LT(row_of(before, kGroup, kRow).residual_mm, 1e-7);
    const Eigen::Vector3d here_mm = row_of(before, kGroup, kRow).point_mm;
    const PostureSearch moved =
        find_posture(ForwardKinematics(before.arm), here_mm + off_mm,
                     groups_[kGroup].encoder_rad.col(kRow), {.tolerance_mm = 1e-10});
    ASSERT_TRUE(moved.found);
    groups_[kGroup].encoder_rad.col(kRow) = moved.encoder_rad;
    after_ = calibrate(nominal_arm(), groups_, {});
    ASSERT_TRUE(after_.ok());
    ASSERT_LT((row().point_mm - here_mm - off_mm).norm(), 1e-7);
  }

  [[nodiscard]] const RowResidual& row() const { return row_of(after_, kGroup, kRow); }
  [[nodiscard]] TipLinearisation at_row() const {
    const Eigen::VectorXd e = groups_[kGroup].encoder_rad.col(kRow);
    return ForwardKinematics(after_.arm).linearise({e.data(), static_cast<std::size_t>(e.size())});
  }
  [[nodiscard]] double value_mm() const { return groups_[kGroup].value_mm(kRow); }

  std::vector<ObservationGroup> groups_;
  Calibration after_;
};

class OnePointOff : public OneRowOff {};

TEST_P(OnePointOff, PointsBackFromTheArmToTheReferenceInTheBaseFrame) {
  const Eigen::Vector3d off_mm(0.0, 0.0, 0.3);
  ASSERT_NO_FATAL_FAILURE(calibrate_with_row_off_by(off_mm));
  EXPECT_TRUE(row().is_check);
  EXPECT_LT((row().vector_mm + off_mm).norm(), 1e-6);
  const double u_mm = groups_[kGroup].u_mm(kRow);
  EXPECT_LT((u_mm * row().components.head<3>() - row().vector_mm).norm(), 1e-12);
  EXPECT_GT(row().normalised(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(OfKinds, OnePointOff, ::testing::ValuesIn(kPlacesInSpace),
                         [](const auto& each) { return std::string(each.param.name); });

class OneDistanceOff : public OneRowOff {};

TEST_P(OneDistanceOff, PointsAlongItToWhereTheReferenceHasThePoint) {
  const Eigen::Vector3d off_mm(0.01, -0.02, 0.015);
  ASSERT_NO_FATAL_FAILURE(calibrate_with_row_off_by(off_mm));
  ASSERT_EQ(row().components.size(), 1);
  EXPECT_NEAR(row().vector_mm.norm(), row().residual_mm, 1e-12);
  EXPECT_EQ(row().normalised(), row().components(0));
  // Joints below a circle carry its axis along, so of the displacement only a part is off.
  if (groups_[kGroup].kind == ReferenceKind::circle_radius) return;
  // What is off is the part of the displacement along the distance; it is curved by less than
  // |off|^2 / 40 mm.
  const Eigen::Vector3d along = row().vector_mm.normalized();
  EXPECT_LT((row().vector_mm + along * along.dot(off_mm)).norm(), 2e-5);
}

INSTANTIATE_TEST_SUITE_P(OfKinds, OneDistanceOff, ::testing::ValuesIn(kDistances),
                         [](const auto& each) { return std::string(each.param.name); });

class OneReversalOff : public OneRowOff {};

TEST_P(OneReversalOff, IsMeasuredLessPredicted) {
  ASSERT_NO_FATAL_FAILURE(calibrate_with_row_off_by({0.2, 0.1, 0.0}));
  const Eigen::VectorXd e = groups_[kGroup].encoder_end_rad.col(kRow);
  const Eigen::Vector3d end_mm =
      ForwardKinematics(after_.arm).tip_in_base({e.data(), static_cast<std::size_t>(e.size())});
  const double u_mm = groups_[kGroup].u_mm(kRow);
  EXPECT_NEAR(row().normalised(), (value_mm() - (row().point_mm - end_mm).norm()) / u_mm, 1e-5);
  EXPECT_NEAR((row().point_mm + row().vector_mm - end_mm).norm(), value_mm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfKinds, OneReversalOff, ::testing::Values(kDistances[0]),
                         [](const auto& each) { return std::string(each.param.name); });

class OneCircleOff : public OneRowOff {};

TEST_P(OneCircleOff, IsMeasuredLessPredicted) {
  ASSERT_NO_FATAL_FAILURE(calibrate_with_row_off_by({0.2, 0.1, 0.0}));
  const TipLinearisation here = at_row();
  const Eigen::Index joint = groups_[kGroup].joint[kRow] - 1;
  const auto radius_of = [&](const Eigen::Vector3d& point_mm) {
    const Eigen::Vector3d lever = point_mm - here.joint_origins_mm.col(joint);
    return lever.cross(Eigen::Vector3d(here.joint_axes.col(joint))).norm();
  };
  const double u_mm = groups_[kGroup].u_mm(kRow);
  EXPECT_NEAR(row().normalised(), (value_mm() - radius_of(row().point_mm)) / u_mm, 1e-5);
  EXPECT_NEAR(radius_of(row().point_mm + row().vector_mm), value_mm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfKinds, OneCircleOff, ::testing::Values(kDistances[1]),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(RowResiduals, OfAPointInsideASphereArePositive) {
  SyntheticReadings readings(true_arm(), 44, 0.0);
  std::vector<ObservationGroup> groups = {readings.reference_points(60, "A"),
                                          readings.sphere(20, 40.0, true)};
  groups[1].is_check[5] = true;
  groups.push_back(groups[1]);  // the same sphere, said to be larger: its points lie inside
  groups[2].radius_mm = 40.5;
  groups[2].is_check.assign(20, true);
  const Calibration calibration = calibrate(nominal_arm(), groups, {});
  ASSERT_TRUE(calibration.ok());
  for (int row = 0; row < 20; ++row) {
    EXPECT_NEAR(row_of(calibration, 2, row).normalised() * groups[2].u_mm(row), 0.5, 1e-6);
  }
}

// Every kind with noise, some rows held out.
class MixedRows : public ::testing::Test {
 protected:
  MixedRows() {
    SyntheticReadings readings(true_arm(), 45, 0.01);
    groups_ = {readings.reference_points(60, "A"),
               readings.fixed_points({"P", "Q"}, 20),
               readings.length("P", "Q"),
               readings.reference_poses(20, "B"),
               readings.artefact(5, 6, "flat"),
               readings.reversals(20),
               readings.circle_radii(20),
               readings.sphere(30, 40.0, false),
               readings.plane(30)};
    for (ObservationGroup& group : groups_) {
      for (std::size_t row = 2; row < group.is_check.size(); row += 3) group.is_check[row] = true;
    }
    calibration_ = calibrate(nominal_arm(), groups_, {});
  }

  std::vector<ObservationGroup> groups_;
  Calibration calibration_;
};

TEST_F(MixedRows, AreAllThereInTheOrderOfTheFile) {
  ASSERT_TRUE(calibration_.ok());
  std::size_t at = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (int row = 0; row < groups_[g].count(); ++row, ++at) {
      ASSERT_LT(at, calibration_.residuals.size());
      const RowResidual& each = calibration_.residuals[at];
      EXPECT_EQ(each.group, static_cast<int>(g));
      EXPECT_EQ(each.row, row);
      EXPECT_EQ(each.is_check, groups_[g].is_check[static_cast<std::size_t>(row)]);
      const bool has_place = groups_[g].kind != ReferenceKind::length;
      EXPECT_EQ(each.point_mm.allFinite(), has_place);
      EXPECT_EQ(each.vector_mm.allFinite(), has_place);
    }
  }
  EXPECT_EQ(at, calibration_.residuals.size());
}

TEST_F(MixedRows, GiveTheStatisticsOfTheirGroups) {
  ASSERT_TRUE(calibration_.ok());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const GroupResult& group = calibration_.groups[g];
    double squares[2][2] = {};  // by check, by nominal
    for (const RowResidual& row : calibration_.residuals) {
      if (row.group != static_cast<int>(g)) continue;
      squares[row.is_check][0] += row.residual_mm * row.residual_mm;
      squares[row.is_check][1] += row.nominal_residual_mm * row.nominal_residual_mm;
    }
    const auto expect = [&](double sum, const ResidualStatistics& statistics) {
      const double rms_mm = std::sqrt(sum / static_cast<double>(statistics.count));
      EXPECT_NEAR(rms_mm, statistics.rms_mm, 1e-12 * (1.0 + rms_mm)) << group.name;
    };
    expect(squares[0][0], group.fit);
    expect(squares[0][1], group.nominal);
    if (group.kind == ReferenceKind::length) continue;
    expect(squares[1][0], group.check.value());
    expect(squares[1][1], group.check_nominal.value());
    EXPECT_GT(group.check_nominal->rms_mm, 3.0 * group.check->rms_mm) << group.name;
  }
}

TEST_F(MixedRows, HaveTheirNoiseForFloor) {
  for (const GroupResult& group : calibration_.groups) {
    const bool one_number =
        group.kind == ReferenceKind::length || group.kind == ReferenceKind::reversal ||
        group.kind == ReferenceKind::circle_radius || group.kind == ReferenceKind::sphere ||
        group.kind == ReferenceKind::plane;
    const double expected_mm = 0.01 * std::sqrt(one_number ? 1.0 : 3.0);
    EXPECT_NEAR(group.fit.floor_mm, expected_mm, 1e-15) << group.name;
  }
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double count = 0.0;
};

Moments moments_of(const Calibration& calibration, bool check) {
  Moments moments;
  for (const RowResidual& row : calibration.residuals) {
    if (row.is_check != check) continue;
    moments.mean += row.components.sum();
    moments.variance += row.components.squaredNorm();
    moments.count += static_cast<double>(row.components.size());
  }
  moments.mean /= moments.count;
  moments.variance /= moments.count;
  return moments;
}

// Readings whose encoders scatter too, so that floor and whitening are not those of u_mm alone.
TEST(RowResiduals, HaveStandardNormalComponentsAndTheFloorForRms) {
  constexpr double kEncoder_rad = 3e-5;
  SyntheticReadings readings(true_arm(), 46, 0.01);
  std::vector<ObservationGroup> groups = {readings.reference_points(450, "A"),
                                          readings.reversals(300)};
  for (ObservationGroup& group : groups) {
    group.u_encoder_rad = kEncoder_rad;
    for (Eigen::Index row = 0; row < group.count(); ++row) {
      group.is_check[static_cast<std::size_t>(row)] = row % 3 == 0;
      const Eigen::VectorXd turn = group.encoder_end_rad.cols() > 0
                                       ? group.encoder_end_rad.col(row) - group.encoder_rad.col(row)
                                       : Eigen::VectorXd();
      for (Eigen::Index joint = 0; joint < 6; ++joint) {
        group.encoder_rad(joint, row) += kEncoder_rad * readings.random().normal();
        if (turn.size() == 0) continue;
        // A locked joint is read once.
        group.encoder_end_rad(joint, row) =
            turn(joint) == 0.0
                ? group.encoder_rad(joint, row)
                : group.encoder_end_rad(joint, row) + kEncoder_rad * readings.random().normal();
      }
    }
  }
  const Calibration calibration = calibrate(nominal_arm(), groups, {});
  ASSERT_TRUE(calibration.ok());
  for (const bool check : {false, true}) {
    const Moments moments = moments_of(calibration, check);
    // Four standard errors: 1 / sqrt(n) of the mean, sqrt(2 / n) of the variance, which fitting
    // takes 27 of 1100 from, and being held out adds as much to.
    EXPECT_NEAR(moments.mean, 0.0, 4.0 / std::sqrt(moments.count)) << check;
    EXPECT_NEAR(moments.variance, 1.0, 4.0 * std::sqrt(2.0 / moments.count) + 0.03) << check;
  }
  for (const GroupResult& group : calibration.groups) {
    EXPECT_GT(group.fit.floor_mm, 1.5 * 0.01);  // encoders count
    EXPECT_NEAR(group.check->rms_mm / group.check->floor_mm, 1.0, 0.25) << group.name;
  }
}

TEST(SolutionTraces, FallFromTheNominalArmToTheResult) {
  ArmModel truth = true_arm();
  for (Joint& joint : truth.joints) joint.harmonics = {{3e-4, -2e-4}};
  SyntheticReadings readings(truth, 47, 0.01);
  const std::vector<ObservationGroup> groups = {readings.reference_points(120, "A")};
  const Calibration calibration = calibrate(nominal_arm(), groups, {.harmonics = 1});
  ASSERT_TRUE(calibration.ok());
  ASSERT_GE(calibration.convergence.size(), 2u);
  EXPECT_EQ(calibration.convergence.front().stage, "geometry");
  EXPECT_EQ(calibration.convergence.back().stage, "all");
  EXPECT_EQ(calibration.convergence.back().unknowns, calibration.rank);
  for (const SolutionTrace& each : calibration.convergence) {
    ASSERT_GE(each.costs.size(), 2u);
    for (std::size_t i = 1; i < each.costs.size(); ++i)
      EXPECT_LE(each.costs[i], each.costs[i - 1] * (1.0 + 1e-12));
  }
  EXPECT_GT(calibration.convergence.front().costs.front(), 1e4);
  EXPECT_NEAR(calibration.convergence.back().costs.back() / calibration.chi_squared, 1.0, 1e-6);
}

}  // namespace
}  // namespace armcal
