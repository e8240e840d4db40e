// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/observation_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/core/units.h"
#include "armcal/io/observation_tables.h"
#include "armcal/io/session_writer.h"
#include "armcal/testing/synthetic_readings.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::SyntheticReadings;

constexpr double kWritten_mm = 0.51e-8;
const double kWritten_rad = radians_from_degrees(0.51e-10);

std::optional<CsvTable> table_of(const std::string& path, const std::string& text) {
  Diagnostics diagnostics;
  auto table = CsvTable::parse({path, text, "UTF-8", ""}, {}, diagnostics);
  EXPECT_TRUE(table.has_value()) << diagnostics.to_text() << text;
  return table;
}

/// Through the text of a session and its tables.
ObservationGroup written_and_read(const ObservationGroup& group) {
  const GroupTexts texts = group_texts(group);
  Session session;
  session.file = "session.toml";
  session.arm_file = "nominal.arm.toml";
  session.groups = {texts.entry};
  Diagnostics diagnostics;
  const auto read =
      read_session_file({"session.toml", session_text(session), "UTF-8", ""}, diagnostics);
  EXPECT_TRUE(read.has_value()) << diagnostics.to_text() << session_text(session);
  if (!read) return {};
  std::optional<CsvTable> table;
  std::optional<CsvTable> artefact;
  if (!texts.entry.file.empty()) table = table_of(texts.entry.file, texts.readings_csv);
  if (!texts.entry.artefact_file.empty()) {
    artefact = table_of(texts.entry.artefact_file, texts.artefact_csv);
  }
  const auto back = observation_group(read->groups[0], table ? &*table : nullptr,
                                      artefact ? &*artefact : nullptr, 6, diagnostics);
  EXPECT_TRUE(back.has_value()) << diagnostics.to_text() << texts.readings_csv;
  EXPECT_EQ(diagnostics.to_text(), "");
  return back.value_or(ObservationGroup{});
}

void expect_near(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other, double tolerance) {
  ASSERT_EQ(one.rows(), other.rows());
  ASSERT_EQ(one.cols(), other.cols());
  EXPECT_LT((one - other).lpNorm<Eigen::Infinity>(), tolerance);
}

void expect_same(const ObservationGroup& group, const ObservationGroup& back) {
  EXPECT_EQ(group.name, back.name);
  EXPECT_EQ(group.kind, back.kind);
  EXPECT_EQ(group.is_check, back.is_check);
  EXPECT_EQ(group.place, back.place);
  EXPECT_EQ(group.place_to, back.place_to);
  EXPECT_EQ(group.feature, back.feature);
  EXPECT_EQ(group.joint, back.joint);
  EXPECT_EQ(group.radius_mm, back.radius_mm);
  EXPECT_EQ(group.tip_radius_mm, back.tip_radius_mm);
  EXPECT_EQ(group.lever_mm, back.lever_mm);
  EXPECT_EQ(group.u_encoder_rad, back.u_encoder_rad);
  EXPECT_EQ(group.offset_mm, back.offset_mm);
  EXPECT_EQ(group.target, back.target);
  expect_near(group.u_mm, back.u_mm, 1e-6);
  expect_near(group.encoder_rad, back.encoder_rad, kWritten_rad);
  expect_near(group.encoder_end_rad, back.encoder_end_rad, kWritten_rad);
  expect_near(group.reference_mm, back.reference_mm, kWritten_mm);
  expect_near(group.value_mm, back.value_mm, kWritten_mm);
  ASSERT_EQ(group.orientation.size(), back.orientation.size());
  for (std::size_t i = 0; i < group.orientation.size(); ++i) {
    expect_near(group.orientation[i], back.orientation[i], 1e-11);
  }
}

std::vector<ObservationGroup> every_kind(double noise_mm) {
  SyntheticReadings readings(testing::nominal_romer(), 3, noise_mm);
  std::vector<ObservationGroup> groups = {readings.reference_points(12, "cmm"),
                                          readings.reference_poses(8, "tracker"),
                                          readings.fixed_points({"A", "B, left"}, 5),
                                          readings.length("A", "B, left"),
                                          readings.artefact(4, 3, "bench"),
                                          readings.reversals(6),
                                          readings.circle_radii(6),
                                          readings.sphere(9, 12.7, true),
                                          readings.sphere(9, 12.7, false),
                                          readings.plane(9)};
  return groups;
}

TEST(GroupTexts, ReadBackAsTheSameGroupForEveryKind) {
  for (const double noise_mm : {0.0, 0.01}) {
    for (const ObservationGroup& group : every_kind(noise_mm)) {
      SCOPED_TRACE(to_string(group.kind));
      const ObservationGroup back = written_and_read(group);
      expect_same(group, back);
      if (group.kind != ReferenceKind::length) {
        EXPECT_EQ(group.file, back.file);
        EXPECT_EQ(group.lines, back.lines);
      }
    }
  }
}

TEST(GroupTexts, KeepWhatDiffersByRow) {
  for (ObservationGroup group : every_kind(0.01)) {
    if (group.count() < 2) continue;
    SCOPED_TRACE(to_string(group.kind));
    group.u_mm(1) = 0.0123456;
    group.is_check[0] = true;
    if (!group.place.empty()) group.place.back() = "another";
    expect_same(group, written_and_read(group));
  }
}

TEST(GroupTexts, KeepTimesAndTemperatures) {
  for (ObservationGroup group : every_kind(0.01)) {
    if (group.count() < 2) continue;
    SCOPED_TRACE(to_string(group.kind));
    for (const bool is_utc : {true, false}) {
      group.time_is_utc = is_utc;
      group.time_s = Eigen::VectorXd::LinSpaced(group.count(), 1000.25, 5000.75).array().round();
      group.time_s(0) += 0.125;
      group.temperature_c = Eigen::VectorXd::Constant(group.count(), 20.5);
      group.temperature_c(1) = std::numeric_limits<double>::quiet_NaN();
      const ObservationGroup back = written_and_read(group);
      EXPECT_EQ(back.time_is_utc, is_utc);
      EXPECT_EQ(back.time_s, group.time_s);
      ASSERT_EQ(back.temperature_c.size(), group.count());
      EXPECT_EQ(back.temperature_c(0), 20.5);
      EXPECT_TRUE(std::isnan(back.temperature_c(1)));
    }
  }
}

TEST(GroupTexts, KeepWhatAllRowsShareInTheEntry) {
  ObservationGroup group = every_kind(0.01).front();
  group.is_check.assign(group.is_check.size(), true);
  group.offset_mm = {1.0, -2.5, 0.0};
  group.target = "reflector";
  group.u_encoder_rad = 1e-5;
  const GroupTexts texts = group_texts(group);
  EXPECT_EQ(texts.entry.set, "check");
  EXPECT_EQ(texts.entry.u_mm, 0.01);
  EXPECT_EQ(texts.readings_csv.substr(0, texts.readings_csv.find('\n')),
            "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm");
  expect_same(group, written_and_read(group));
}

TEST(GroupTexts, SayThatRepeatsAreReadings) {
  for (ObservationGroup group : every_kind(0.0)) {
    if (group.count() < 2 || group.kind == ReferenceKind::length) continue;
    SCOPED_TRACE(to_string(group.kind));
    group.encoder_rad.col(1) = group.encoder_rad.col(0);
    if (group.encoder_end_rad.cols() > 0) {
      group.joint[1] = group.joint[0];
      group.encoder_end_rad.col(1) = group.encoder_end_rad.col(0);
    }
    if (group.kind == ReferenceKind::reference_points) {
      group.reference_mm.leftCols(2).setZero();
    }
    if (!group.place.empty()) group.place[1] = group.place[0];
    if (!group.feature.empty()) {
      group.feature[1] = group.feature[0];
      group.reference_mm.col(1) = group.reference_mm.col(0);
    }
    expect_same(group, written_and_read(group));
  }
}

TEST(GroupTexts, OfASphereFromInsideKeepItsSign) {
  ObservationGroup group = every_kind(0.01)[7];
  group.tip_radius_mm = -1.5;
  EXPECT_THAT(session_text({"s", "", "a", {group_texts(group).entry}, {}}),
              HasSubstr("tip_diameter_mm = 3.0\ninside = true\n"));
  expect_same(group, written_and_read(group));
}

TEST(GroupTexts, RefuseTurnsThatATableCannotSay) {
  ObservationGroup group = every_kind(0.0)[5];
  group.encoder_end_rad(0, 2) += 1e-3;
  EXPECT_THROW(static_cast<void>(group_texts(group)), std::invalid_argument);
}

TEST(GroupTexts, RefuseAFeatureInTwoPlaces) {
  ObservationGroup group = every_kind(0.0)[4];
  group.feature.assign(group.feature.size(), "S1");
  EXPECT_THROW(static_cast<void>(group_texts(group)), std::invalid_argument);
}

}  // namespace
}  // namespace armcal
