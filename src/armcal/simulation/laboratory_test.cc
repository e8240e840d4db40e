// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/laboratory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/simulation/posture_choice.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::uint64_t kLaboratorySeed = 3;

// An arm on a bench, about a column, with stops at every joint but one.
ArmModel stopped_arm() {
  ArmModel arm = testing::consistent_romer();
  for (Joint& joint : arm.joints) {
    joint.min_rad = -2.6;
    joint.max_rad = 2.6;
  }
  arm.joints[4].min_rad = -HUGE_VAL;
  arm.joints[4].max_rad = HUGE_VAL;
  return arm;
}
const Surroundings kRoom{.column_radius_mm = 60.0, .column_top_mm = 0.0, .bench_mm = -300.0};

Laboratory laboratory(const ErrorSources& errors = {}, const ArmModel& arm = stopped_arm()) {
  return {VirtualArm(arm, errors, kLaboratorySeed, kRoom), kLaboratorySeed};
}

// All numbers of a small measurement: a few seats, a few free points.
std::vector<double> measured(Laboratory& room, int measurement) {
  room.begin(measurement);
  std::vector<double> numbers;
  const auto note = [&](const TakenReading& taken) {
    numbers.insert(numbers.end(), taken.encoder_rad.begin(), taken.encoder_rad.end());
    numbers.insert(numbers.end(), taken.tip_mm.begin(), taken.tip_mm.end());
  };
  const Vector3d seat = room.convenient_point();
  for (const VectorXd& posture : room.postures_with_tip_at(seat, 3, "seat")) {
    note(room.take_with_tip_at(seat, posture, "seat"));
  }
  for (int i = 0; i < 3; ++i) note(room.take(room.free_posture()));
  const Vector3d noise = room.noise(0.01);
  numbers.insert(numbers.end(), noise.begin(), noise.end());
  return numbers;
}

ErrorSources without_drift() {
  ErrorSources errors = ErrorSources::typical();
  errors.warm_up_drift = {};
  return errors;
}

TEST(Laboratory, GivesTheSameReadingsForTheSameSeed) {
  Laboratory one = laboratory(ErrorSources::typical());
  Laboratory same = laboratory(ErrorSources::typical());
  EXPECT_EQ(measured(one, 1), measured(same, 1));
  EXPECT_NE(measured(one, 2), measured(same, 3));
}

TEST(Laboratory, OneMoreMeasurementChangesNoOther) {
  Laboratory few = laboratory(without_drift());
  Laboratory more = laboratory(without_drift());
  (void)measured(more, 1);
  (void)more.free_posture();
  EXPECT_EQ(measured(few, 2), measured(more, 2));
}

TEST(Laboratory, SwitchingOnWhatIsDrawnByReadingChangesNoPosture) {
  // The foot, blunders and encoder noise have streams of their own.
  ErrorSources noisy;
  noisy.encoder_noise = EncoderNoise::typical();
  noisy.blunders = {.share = 1.0, .size_mm = 0.1};
  noisy.base_movement = BaseMovement::typical();
  Laboratory quiet = laboratory();
  Laboratory loud = laboratory(noisy);
  for (Laboratory* room : {&quiet, &loud}) {
    room->begin(4);
    (void)room->take(VectorXd::Zero(6));
  }
  EXPECT_EQ(quiet.free_posture(), loud.free_posture());
}

TEST(Laboratory, TakesEveryPostureInsideTheLimitsAndClearOfTheRoom) {
  Laboratory room = laboratory(ErrorSources::typical());
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(room.arm().obstacle(room.free_posture()), std::nullopt);
  }
  const Vector3d seat = room.convenient_point();
  for (const VectorXd& posture : room.postures_with_tip_at(seat, 10, "seat")) {
    EXPECT_EQ(room.arm().obstacle(posture), std::nullopt);
    EXPECT_LT((room.arm().tip(posture) - seat).norm(), 1e-9);
  }
}

TEST(Laboratory, PicksPosturesThatDiffer) {
  Laboratory room = laboratory();
  const Vector3d seat = room.convenient_point();
  const auto postures = room.postures_with_tip_at(seat, 8, "seat");
  ASSERT_EQ(postures.size(), 8U);
  for (std::size_t i = 0; i < postures.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(joint_distance_rad(postures[i], postures[j]), 0.5);
    }
  }
}

TEST(Laboratory, FindsAPlaceForSomethingOfASize) {
  Laboratory room = laboratory();
  for (const double size : {0.0, 300.0, 800.0}) {
    const RigidTransform place = room.convenient_place(size);
    for (const double sign : {-0.5, 0.5}) {
      for (int axis = 0; axis < 2; ++axis) {
        const Vector3d end = place * Vector3d(sign * size * Vector3d::Unit(axis));
        EXPECT_EQ(room.postures_with_tip_at(end, 1, "an end").size(), 1U);
      }
    }
  }
}

TEST(Laboratory, SaysWhatCannotBeReached) {
  Laboratory room = laboratory();
  const auto reach = [&](const Vector3d& point) {
    return [&room, point] { (void)room.postures_with_tip_at(point, 2, "seat A"); };
  };
  EXPECT_THAT(reach({2000.0, 0.0, 0.0}),
              ThrowsMessage<Impossible>("seat A at (2000.0, 0.0, 0.0) mm cannot be reached: the "
                                        "tip comes no nearer to it than 536.5 mm"));
  EXPECT_THAT(reach({500.0, 0.0, -400.0}),
              ThrowsMessage<Impossible>(HasSubstr("every posture that was tried runs into "
                                                  "something, one of them: ")));
  EXPECT_THAT([&] { (void)room.convenient_place(4000.0); },
              ThrowsMessage<Impossible>(HasSubstr("room for something of 4000.0 mm")));
}

TEST(Laboratory, SaysWhenNoPostureIsFree) {
  Laboratory room(VirtualArm(stopped_arm(), {}, kLaboratorySeed, {.bench_mm = 5000.0}),
                  kLaboratorySeed);
  EXPECT_THAT([&] { (void)room.free_posture(); },
              ThrowsMessage<Impossible>(HasSubstr("none of 2000 random postures of arm \"ROMER "
                                                  "Infinite 2.0\" is free: ")));
}

TEST(Laboratory, HoldsTheTipWhereItIsHeldWhateverMoves) {
  ErrorSources errors;
  errors.base_movement = {.u_shift_mm = 0.05, .u_tilt_rad = 1e-5};
  errors.warm_up_drift = {.u_zero_rad = 1e-4, .time_constant_s = 10.0};
  Laboratory room = laboratory(errors);
  const Vector3d seat = room.convenient_point();
  const VectorXd posture = room.postures_with_tip_at(seat, 1, "seat").front();
  const TakenReading first = room.take_with_tip_at(seat, posture, "seat");
  const TakenReading later = room.take_with_tip_at(seat, posture, "seat");
  EXPECT_EQ(first.tip_mm, seat);
  EXPECT_EQ(later.tip_mm, seat);
  // What moves is seen by the encoders there, and by the reference where the joints are locked.
  EXPECT_GT((later.encoder_rad - first.encoder_rad).norm(), 1e-5);
  EXPECT_GT((room.take(posture).tip_mm - seat).norm(), 0.01);
  EXPECT_EQ(room.take(posture).encoder_rad, posture);
}

TEST(Laboratory, TheClockGoesOnReadingByReading) {
  Laboratory room = laboratory();
  room.seconds_per_reading = 7.0;
  (void)room.take(VectorXd::Zero(6));
  room.begin(5);
  (void)room.take(VectorXd::Zero(6));
  EXPECT_EQ(room.time_s(), 14.0);
}

TEST(Laboratory, NamesItsBlunders) {
  ErrorSources errors;
  errors.blunders = {.share = 0.2, .size_mm = 0.1};
  Laboratory room = laboratory(errors);
  const Vector3d seat = room.convenient_point();
  const VectorXd posture = room.postures_with_tip_at(seat, 1, "seat").front();
  room.begin(7);
  std::vector<int> spoilt;
  for (int i = 0; i < 40; ++i) {
    const bool is_held = i % 2 == 0;
    const TakenReading taken =
        is_held ? room.take_with_tip_at(seat, posture, "seat") : room.take(posture);
    EXPECT_NEAR((taken.tip_mm - seat).norm(), taken.is_blunder() ? 0.1 : 0.0, 1e-9);
    // Held: the joints are where the tip really is, beside the seat. Free: the tip is not.
    const double off_mm = (room.arm().tip(taken.encoder_rad) - seat).norm();
    EXPECT_NEAR(off_mm, taken.is_blunder() && is_held ? 0.1 : 0.0, 1e-9);
    if (taken.is_blunder()) spoilt.push_back(i);
  }
  EXPECT_GE(spoilt.size(), 2U);
  ASSERT_EQ(room.blunders().size(), spoilt.size());
  for (std::size_t i = 0; i < spoilt.size(); ++i) {
    EXPECT_EQ(room.blunders()[i].measurement, 7);
    EXPECT_EQ(room.blunders()[i].reading, spoilt[i]);
    EXPECT_NEAR(room.blunders()[i].off_mm.norm(), 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace armcal
