// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// What instruments and artefacts add to the truth is what they state as their uncertainty.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/identification/calibration.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/simulation/artefacts/ball_bar.h"
#include "armcal/simulation/artefacts/calibrated_sphere.h"
#include "armcal/simulation/artefacts/cone_seat.h"
#include "armcal/simulation/artefacts/flat_surface.h"
#include "armcal/simulation/artefacts/indexed_platform.h"
#include "armcal/simulation/artefacts/multi_sphere_gauge.h"
#include "armcal/simulation/artefacts/sphere_plate.h"
#include "armcal/simulation/artefacts/straight_line.h"
#include "armcal/simulation/artefacts/two_seats.h"
#include "armcal/simulation/instruments/half_turns.h"
#include "armcal/simulation/instruments/laser_tracker.h"
#include "armcal/simulation/instruments/pose_tracker.h"
#include "armcal/simulation/instruments/reference_cmm.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Groups = std::vector<ObservationGroup>;

// The arm is its drawing: what is measured is noise alone.
Laboratory laboratory_of(std::uint64_t seed, const ErrorSources& errors = {}) {
  const ArmModel arm = testing::nominal_romer();
  return {VirtualArm(arm, arm, errors, 1), seed};
}

Groups both(Groups one, const Groups& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

struct Method {
  const char* name;
  Groups (*measure)(Laboratory&);
};

// Different uncertainties everywhere, none of them the default.
const Method kMethods[] = {
    {"reference_cmm", [](Laboratory& l) { return measure(l, ReferenceCmm{.u_mm = 0.02}); }},
    {"laser_tracker",
     [](Laboratory& l) {
       return measure(l, LaserTracker{.u_distance_mm = 0.02, .u_angle_rad = 1e-5});
     }},
    {"half_turns_and_circles",
     [](Laboratory& l) {
       return both(measure(l, HalfTurns{.count = 50, .u_mm = 0.01}),
                   measure(l, CircleRadii{.count = 50, .u_mm = 0.02}));
     }},
    {"cones_and_two_seats",
     [](Laboratory& l) {
       return both(
           measure(l, ConeSeat{.seats = 2, .postures = 20, .u_mm = 0.03}),
           measure(l,
                   TwoSeats{.u_length_mm = 0.02, .placements = 3, .postures = 10, .u_mm = 0.01}));
     }},
    {"ball_bar",
     [](Laboratory& l) {
       return measure(l, BallBar{.placements = 8, .postures = 3, .u_mm = 0.01});
     }},
    {"gauge",
     [](Laboratory& l) { return measure(l, MultiSphereGauge{.spheres = 6, .u_mm = 0.02}); }},
    {"gauge_as_points",
     [](Laboratory& l) {
       return measure(l, MultiSphereGauge{.spheres = 5,
                                          .placements = 2,
                                          .postures = 5,
                                          .u_mm = 0.01,
                                          .form = MultiSphereGauge::Form::points,
                                          .u_length_mm = 0.05});
     }},
    {"sphere_plate",
     [](Laboratory& l) { return measure(l, SpherePlate{.rows = 2, .u_mm = 0.02}); }},
    {"straight_line",
     [](Laboratory& l) { return measure(l, StraightLine{.positions = 3, .u_mm = 0.03}); }},
    {"sphere_and_plane_and_two_seats",
     [](Laboratory& l) {
       return both(both(measure(l, CalibratedSphere{.placements = 1, .u_mm = 0.02}),
                        measure(l, FlatSurface{.placements = 1, .u_mm = 0.03})),
                   measure(l, TwoSeats{.postures = 10, .u_mm = 0.01}));
     }},
};

class NoiseOf : public ::testing::TestWithParam<Method> {};

TEST_P(NoiseOf, ACalibrationIsWhatItsReadingsState) {
  double chi_squared = 0.0;
  int freedom = 0;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Laboratory laboratory = laboratory_of(20 + seed);
    const Calibration calibration =
        calibrate(testing::nominal_romer(), GetParam().measure(laboratory), {});
    ASSERT_TRUE(calibration.ok()) << explain(calibration.status) << calibration.detail;
    chi_squared += calibration.chi_squared;
    freedom += calibration.degrees_of_freedom;
  }
  // Four standard deviations of the mean square.
  EXPECT_GT(freedom, 100);
  EXPECT_NEAR(chi_squared / freedom, 1.0, 4.0 * std::sqrt(2.0 / freedom));
}

INSTANTIATE_TEST_SUITE_P(Of, NoiseOf, ::testing::ValuesIn(kMethods),
                         [](const auto& each) { return std::string(each.param.name); });

double root_mean_square(const Eigen::ArrayXXd& values) { return std::sqrt(values.square().mean()); }

// The same seed draws the same postures: what differs is the noise.
TEST(Noise, OfATrackerIsThatOfItsDistanceAndItsAngles) {
  Laboratory noisy = laboratory_of(40);
  Laboratory exact = laboratory_of(40);
  const LaserTracker tracker{.count = 400, .u_distance_mm = 0.004, .u_angle_rad = 1e-5};
  LaserTracker perfect = tracker;
  perfect.u_distance_mm = perfect.u_angle_rad = 0.0;
  const ObservationGroup seen = measure(noisy, tracker).front();
  const ObservationGroup true_points = measure(exact, perfect).front();
  EXPECT_EQ(seen.encoder_rad, true_points.encoder_rad);
  Eigen::ArrayXd along(tracker.count);
  Eigen::ArrayXd upward_rad(tracker.count);
  Eigen::ArrayXd normalised(tracker.count);
  for (Eigen::Index i = 0; i < tracker.count; ++i) {
    const Eigen::Vector3d p = true_points.reference_mm.col(i);
    const Eigen::Vector3d error = seen.reference_mm.col(i) - p;
    const Eigen::Vector3d aside = p.cross(Eigen::Vector3d::UnitZ()).normalized();
    along(i) = error.dot(p.normalized());
    upward_rad(i) = error.dot(aside.cross(p.normalized())) / p.norm();
    normalised(i) = error.norm() / (std::sqrt(3.0) * seen.u_mm(i));
  }
  // 400 draws: 3.5 % standard uncertainty of a standard deviation.
  EXPECT_NEAR(root_mean_square(along) / 0.004, 1.0, 0.14);
  EXPECT_NEAR(root_mean_square(upward_rad) / 1e-5, 1.0, 0.14);
  EXPECT_NEAR(root_mean_square(normalised), 1.0, 0.1);
}

TEST(Noise, OfATargetIsThatOfItsPositionAndItsTurn) {
  Laboratory noisy = laboratory_of(41);
  Laboratory exact = laboratory_of(41);
  const PoseTracker tracker{.count = 200, .u_mm = 0.01, .u_turn_rad = 2e-4};
  PoseTracker perfect = tracker;
  perfect.u_mm = perfect.u_turn_rad = 0.0;
  const ObservationGroup seen = measure(noisy, tracker).front();
  const ObservationGroup true_poses = measure(exact, perfect).front();
  EXPECT_NEAR(seen.lever_mm, 50.0, 1e-12);
  EXPECT_NEAR(root_mean_square(seen.reference_mm - true_poses.reference_mm) / 0.01, 1.0, 0.12);
  Eigen::Matrix3Xd turns(3, tracker.count);
  for (Eigen::Index i = 0; i < tracker.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    turns.col(i) =
        vector_from_rotation(seen.orientation[at] * true_poses.orientation[at].transpose());
  }
  EXPECT_NEAR(root_mean_square(turns) / 2e-4, 1.0, 0.12);
}

TEST(Noise, OfASeatIsThatOfEachCoordinate) {
  Laboratory laboratory = laboratory_of(42);
  const ObservationGroup seat =
      measure(laboratory, ConeSeat{.postures = 300, .u_mm = 0.02}).front();
  const ForwardKinematics kinematics(testing::nominal_romer());
  Eigen::Matrix3Xd tips(3, seat.count());
  for (Eigen::Index i = 0; i < seat.count(); ++i) {
    const auto posture = seat.encoder_rad.col(i);
    tips.col(i) = kinematics.tip_in_base(as_span(posture));
  }
  const Eigen::Matrix3Xd off = tips.colwise() - tips.rowwise().mean();
  for (const auto& axis : off.rowwise()) {
    EXPECT_NEAR(root_mean_square(axis.array()) / 0.02, 1.0, 0.16);
  }
}

TEST(Noise, OfEncodersEntersByWhatTheyShowAlone) {
  ErrorSources errors;
  errors.encoder_noise.u_rad = 1e-4;
  Laboratory noisy = laboratory_of(43, errors);
  const ObservationGroup seat = measure(noisy, ConeSeat{.postures = 200, .u_mm = 0.0}).front();
  const ForwardKinematics kinematics(testing::nominal_romer());
  // The tip was in the seat all the time; where the readings put it scatters by their noise times
  // the levers of the six joints.
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> tips;
  double predicted = 0.0;
  for (Eigen::Index i = 0; i < seat.count(); ++i) {
    const auto posture = seat.encoder_rad.col(i);
    const TipLinearisation at = kinematics.linearise(as_span(posture));
    tips.push_back(at.tip_mm);
    mean += at.tip_mm / static_cast<double>(seat.count());
    predicted += (1e-4 * at.J_tip_encoder).squaredNorm();
  }
  double scatter = 0.0;
  for (const Eigen::Vector3d& tip : tips) scatter += (tip - mean).squaredNorm();
  EXPECT_NEAR(std::sqrt(scatter / predicted), 1.0, 0.16);
}

TEST(Noise, OfAPlatformIsInAnglesThatNobodyReads) {
  const IndexedPlatform platform{.positions = 6, .points = 5, .u_mm = 0.0, .u_index_rad = 1e-4};
  Laboratory laboratory = laboratory_of(44);
  const ObservationGroup group = measure(laboratory, platform).front();
  const ForwardKinematics kinematics(on_platform(testing::nominal_romer(), platform));
  const RigidTransform axis =
      on_platform(testing::nominal_romer(), platform).base_from_first_joint.inverse();
  std::map<double, std::vector<double>> turns;
  for (Eigen::Index i = 0; i < group.count(); ++i) {
    const auto posture = group.encoder_rad.col(i);
    const Eigen::Vector3d shown = axis * kinematics.tip_in_base(as_span(posture));
    const Eigen::Vector3d real = axis * Eigen::Vector3d(group.reference_mm.col(i));
    EXPECT_NEAR(shown.z(), real.z(), 1e-8);
    turns[posture(0)].push_back(std::atan2(real.y(), real.x()) - std::atan2(shown.y(), shown.x()));
  }
  ASSERT_EQ(turns.size(), 6u);
  for (const auto& [index_rad, of_index] : turns) {
    for (const double turn : of_index)
      EXPECT_NEAR(std::remainder(turn - of_index[0], 2.0 * std::numbers::pi), 0.0, 1e-10);
    EXPECT_LT(std::abs(std::remainder(of_index[0], 2.0 * std::numbers::pi)), 4e-4);
    EXPECT_GT(std::abs(std::remainder(of_index[0], 2.0 * std::numbers::pi)), 1e-8);
  }
}

}  // namespace
}  // namespace armcal
