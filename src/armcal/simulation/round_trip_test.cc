// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// What every instrument and artefact measures without noise, calibration turns into the truth.
#include <gtest/gtest.h>

#include "armcal/arm/parameter_table.h"
#include "armcal/identification/calibration.h"
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
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Groups = std::vector<ObservationGroup>;

ArmModel nominal_arm(int joints) {
  return joints == 6 ? testing::nominal_romer() : seven_joint_arm();
}

struct Trip {
  const char* name;
  Groups (*measure)(Laboratory&);
};

Groups together(Groups one, const Groups& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

// Small ones: the sanitizers are to finish too.
const Trip kTrips[] = {
    {"reference_cmm", [](Laboratory& l) { return measure(l, ReferenceCmm{.u_mm = 0.0}); }},
    {"laser_tracker",
     [](Laboratory& l) {
       return measure(l, LaserTracker{.u_distance_mm = 0.0, .u_angle_rad = 0.0});
     }},
    {"pose_tracker",
     [](Laboratory& l) {
       return measure(l, PoseTracker{.count = 30, .u_mm = 0.0, .u_turn_rad = 0.0});
     }},
    {"half_turns", [](Laboratory& l) { return measure(l, HalfTurns{.count = 60, .u_mm = 0.0}); }},
    {"half_turns_and_circles",
     [](Laboratory& l) {
       return together(measure(l, HalfTurns{.count = 30, .u_mm = 0.0}),
                       measure(l, CircleRadii{.count = 30, .u_mm = 0.0}));
     }},
    {"cones_and_two_seats",
     [](Laboratory& l) {
       return together(measure(l, ConeSeat{.seats = 2, .postures = 20, .u_mm = 0.0}),
                       measure(l, TwoSeats{.u_length_mm = 0.0, .postures = 20, .u_mm = 0.0}));
     }},
    {"two_seats",
     [](Laboratory& l) { return measure(l, TwoSeats{.u_length_mm = 0.0, .u_mm = 0.0}); }},
    {"ball_bar", [](Laboratory& l) { return measure(l, BallBar{.placements = 8, .u_mm = 0.0}); }},
    {"gauge",
     [](Laboratory& l) { return measure(l, MultiSphereGauge{.spheres = 7, .u_mm = 0.0}); }},
    {"gauge_as_points",
     [](Laboratory& l) {
       return measure(l, MultiSphereGauge{.spheres = 5,
                                          .pitch_mm = 200.0,
                                          .placements = 2,
                                          .postures = 6,
                                          .u_mm = 0.0,
                                          .form = MultiSphereGauge::Form::points,
                                          .u_length_mm = 0.0});
     }},
    {"sphere_plate", [](Laboratory& l) { return measure(l, SpherePlate{.rows = 2, .u_mm = 0.0}); }},
    {"straight_line",
     [](Laboratory& l) { return measure(l, StraightLine{.positions = 3, .u_mm = 0.0}); }},
    {"sphere",
     [](Laboratory& l) {
       return measure(l, CalibratedSphere{.placements = 4, .points = 20, .u_mm = 0.0});
     }},
    {"unknown_sphere_and_two_seats",
     [](Laboratory& l) {
       return together(
           measure(l, CalibratedSphere{.placements = 1, .u_mm = 0.0, .is_known = false}),
           measure(l, TwoSeats{.u_length_mm = 0.0, .postures = 20, .u_mm = 0.0}));
     }},
    {"plane_and_two_seats",
     [](Laboratory& l) {
       return together(measure(l, FlatSurface{.placements = 1, .u_mm = 0.0}),
                       measure(l, TwoSeats{.u_length_mm = 0.0, .postures = 20, .u_mm = 0.0}));
     }},
};

std::vector<int> free_of(const Calibration& calibration) {
  std::vector<int> free;
  for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
    if (calibration.parameters[i].status == ParameterStatus::free) {
      free.push_back(static_cast<int>(i));
    }
  }
  return free;
}

// The parameters that readings of everything determine; the others are conventions.
std::vector<int> determined(const ArmModel& nominal) {
  Laboratory laboratory(VirtualArm(nominal, nominal, {}, 1), 2);
  return free_of(identifiability(nominal, measure(laboratory, ReferenceCmm{}), {}));
}

// The errors of a real arm in the parameters that readings determine, none in those that they leave
// to convention: then the truth has one form.
ArmModel true_arm(const ArmModel& nominal) {
  RandomStream random(11, 0);
  const ArmModel drawn = drawn_arm(nominal, GeometryErrors::typical(), random);
  const Eigen::VectorXd all = parameter_values(drawn);
  Eigen::VectorXd values = parameter_values(nominal);
  for (const int i : determined(nominal)) values(i) = all(i);
  return with_parameter_values(nominal, values);
}

void expect_same(const Calibration& calibration, const ArmModel& truth) {
  ASSERT_TRUE(calibration.ok()) << explain(calibration.status) << calibration.detail
                                << to_string(calibration.termination);
  const Eigen::VectorXd values = parameter_values(truth);
  for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
    const CalibratedParameter& each = calibration.parameters[i];
    const double tolerance = each.unit == ParameterUnit::mm ? 1e-6 : 1e-9;
    EXPECT_NEAR(each.value, values(static_cast<Eigen::Index>(i)), tolerance) << each.name;
  }
}

class RoundTrip : public ::testing::TestWithParam<std::tuple<int, Trip>> {};

TEST_P(RoundTrip, FindsTheTruth) {
  const auto& [joints, method] = GetParam();
  const ArmModel nominal = nominal_arm(joints);
  const ArmModel truth = true_arm(nominal);
  Laboratory laboratory(VirtualArm(nominal, truth, {}, 1), 13);
  const Calibration calibration = calibrate(nominal, method.measure(laboratory), {});
  EXPECT_EQ(calibration.free.size(), static_cast<std::size_t>(4 * joints - 3));
  expect_same(calibration, truth);
}

INSTANTIATE_TEST_SUITE_P(Of, RoundTrip,
                         ::testing::Combine(::testing::Values(6, 7), ::testing::ValuesIn(kTrips)),
                         [](const auto& each) {
                           return std::string(std::get<1>(each.param).name) + "_" +
                                  std::to_string(std::get<0>(each.param)) + "_joints";
                         });

TEST(RoundTrips, OfAnArmOnAPlatformFindTheTruthOfAnArmWithOneJointMore) {
  const ArmModel nominal = testing::nominal_romer();
  const ArmModel truth = true_arm(nominal);
  const IndexedPlatform platform{.points = 8, .u_mm = 0.0, .u_index_rad = 0.0};
  Laboratory laboratory(VirtualArm(nominal, truth, {}, 1), 14);
  const Calibration calibration =
      calibrate(on_platform(nominal, platform), measure(laboratory, platform), {});
  EXPECT_EQ(calibration.free.size(), 25u);
  expect_same(calibration, on_platform(truth, platform));
}

}  // namespace
}  // namespace armcal
