// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/symmetric_point_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "armcal/core/random.h"
#include "armcal/core/units.h"
#include "armcal/io/reading_tables.h"
#include "armcal/io/symmetric_point_file.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

SymmetricPointProcedure read_back(const std::string& text,
                                  const std::string& path = "folder/p.symmetric.toml") {
  Diagnostics diagnostics;
  auto procedure = read_symmetric_point_file({path, text, "UTF-8", ""}, diagnostics);
  EXPECT_TRUE(procedure.has_value()) << diagnostics.to_text() << text;
  if (!procedure) return {};
  EXPECT_TRUE(check_against_arm(*procedure, testing::nominal_romer(), diagnostics))
      << diagnostics.to_text();
  EXPECT_FALSE(diagnostics.has_errors());
  return *procedure;
}

void expect_same(const SymmetricReading& one, const SymmetricReading& other) {
  EXPECT_EQ(one.name, other.name);
  EXPECT_EQ(one.kind, other.kind);
  EXPECT_EQ(one.joint, other.joint);
  EXPECT_EQ(one.sweep, other.sweep);
  EXPECT_EQ(one.posture_rad, other.posture_rad);
  ASSERT_EQ(one.posture_end_rad.size(), other.posture_end_rad.size());
  EXPECT_LT((one.posture_end_rad - other.posture_end_rad).norm(), 1e-14);  // rounding of the sum
  EXPECT_EQ(one.value, other.value);
  EXPECT_EQ(one.u, other.u);
  EXPECT_EQ(one.reduced, other.reduced);
  EXPECT_EQ(one.solves, other.solves);
  EXPECT_EQ(one.raw.has_value(), other.raw.has_value());
  if (one.raw && other.raw) {
    EXPECT_EQ(one.raw->file, other.raw->file);
  }
}

void expect_same(const SymmetricPointProcedure& one, const SymmetricPointProcedure& other) {
  EXPECT_EQ(one.arm_file, other.arm_file);
  ASSERT_EQ(one.readings.size(), other.readings.size());
  for (std::size_t i = 0; i < one.readings.size(); ++i) {
    expect_same(one.readings[i], other.readings[i]);
  }
  EXPECT_EQ(one.unknowns, other.unknowns);
  EXPECT_EQ(one.hold, other.hold);
  EXPECT_EQ(one.unknown_signs, other.unknown_signs);
  EXPECT_EQ(one.significance, other.significance);
  EXPECT_EQ(one.power, other.power);
  ASSERT_EQ(one.claims.size(), other.claims.size());
  for (std::size_t i = 0; i < one.claims.size(); ++i) {
    EXPECT_EQ(one.claims[i].parameter, other.claims[i].parameter);
    EXPECT_EQ(one.claims[i].value, other.claims[i].value);
    EXPECT_EQ(one.claims[i].u, other.claims[i].u);
  }
}

SymmetricPointProcedure everything() {
  return read_back(R"(schema = "armcal.symmetric/1"
arm = "../nominal.arm.toml"
[[reading]]
name = "a \"reduced\" one"
kind = "reversal"
joint = 5
posture_deg = [0.1, -12.345, 0, 0, 0, -90]
distance_mm = 352.968
u_mm = 0.003
solves = "b7"
[[reading]]
name = "the other way, and not quite"
kind = "reversal"
joint = 3
posture_deg = [0, 0, 90, 0, 0, 0]
turn_deg = -179.25
file = "raw/l3.csv"
u_mm = 0.001
[[reading]]
name = "R"
kind = "circle_radius"
joint = 6
radius_mm = 178.383
u_mm = 0.01
[[reading]]
name = "zero"
kind = "zero_search"
joint = 6
sweep = 3
posture_deg = [0, 0, 0, 0, 0, 2]
angle_deg = 1.5
u_deg = 0.02
[adjust]
unknowns = ["a*", "b7"]
hold = ["alpha?"]
significance = 0.01
power = 0.9
[signs]
unknown = ["a5", "direction4"]
[claims]
a5_mm = 78.312
alpha3_deg = -90
u_mm = 0.002
u_deg = 0.01
)");
}

TEST(SymmetricPointText, ReadsBackAsTheSameProcedure) {
  const SymmetricPointProcedure procedure = everything();
  const std::string text = symmetric_point_text(procedure, "a name", "a note");
  expect_same(procedure, read_back(text));
  EXPECT_EQ(text, symmetric_point_text(read_back(text), "a name", "a note"));
}

TEST(SymmetricPointText, ReadsBackForEveryExample) {
  for (const char* name :
       {"wang2016/as-printed", "wang2016/as-meant", "wang2016/signs", "half-turns/procedure"}) {
    SCOPED_TRACE(name);
    const auto path = testing::repository() / "examples" / (std::string(name) + ".symmetric.toml");
    const auto procedure = read_back(testing::read_bytes(path), path.string());
    expect_same(procedure, read_back(symmetric_point_text(procedure), path.string()));
  }
}

SymmetricReading planned(const std::string& name) {
  SymmetricReading reading;
  reading.name = name;
  reading.joint = 5;
  reading.posture_rad = Eigen::VectorXd::Zero(6);
  reading.posture_end_rad = reading.posture_rad;
  reading.posture_end_rad(4) = std::numbers::pi;
  return reading;
}

TEST(SymmetricPointText, NamesAFileForEveryPlannedReading) {
  SymmetricPointProcedure plan;
  plan.file = "plans/arm.symmetric.toml";
  plan.arm_file = "nominal.arm.toml";
  plan.readings = {planned("joint 5, tip out"), planned("joint 5 tip out"), planned("***")};
  const SymmetricPointProcedure back = read_back(symmetric_point_text(plan), plan.file);
  EXPECT_EQ(back.arm_file, "nominal.arm.toml");
  EXPECT_EQ(back.readings[0].raw->file, "plans/joint-5-tip-out.csv");
  EXPECT_EQ(back.readings[1].raw->file, "plans/joint-5-tip-out-2.csv");
  EXPECT_EQ(back.readings[2].raw->file, "plans/reading.csv");
  name_point_files(plan);
  expect_same(plan, back);
}

TEST(SymmetricPointText, RefusesClaimsThatAFileCannotSay) {
  SymmetricPointProcedure procedure = everything();
  procedure.claims.push_back({"b7", 176.484, 0.5, {}});
  EXPECT_THROW(static_cast<void>(symmetric_point_text(procedure)), std::invalid_argument);
}

// --- tables of points

RawSymmetricPoints points(const SymmetricReading& reading, bool with_angles) {
  RandomStream random(1);
  RawSymmetricPoints raw;
  constexpr int kCount = 12;
  for (int i = 0; i < kCount; ++i) {
    raw.points_mm.emplace_back(random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3), i);
    if (reading.kind == SymmetricKind::reversal) raw.end.push_back(i % 2 == 0 ? 'A' : 'B');
    if (reading.kind == SymmetricKind::zero_search) raw.setting_rad.push_back(0.1 * (i / 4));
    raw.lines.push_back(i + 2);
  }
  if (with_angles) {
    raw.encoder_rad = Eigen::MatrixXd::NullaryExpr(6, kCount, [&] { return random.normal(); });
    for (int i = 0; i < kCount && !raw.setting_rad.empty(); ++i) {
      raw.setting_rad[static_cast<std::size_t>(i)] = raw.encoder_rad(reading.joint - 1, i);
    }
  }
  return raw;
}

RawSymmetricPoints read_points(const std::string& csv, const SymmetricReading& reading) {
  Diagnostics diagnostics;
  const auto table = CsvTable::parse({"raw.csv", csv, "UTF-8", ""}, {}, diagnostics);
  EXPECT_TRUE(table.has_value()) << diagnostics.to_text();
  if (!table) return {};
  const auto raw = symmetric_points(*table, reading, 6, {}, diagnostics);
  EXPECT_TRUE(raw.has_value()) << diagnostics.to_text() << csv;
  return raw.value_or(RawSymmetricPoints{});
}

TEST(RawPointsCsv, ReadsBackAsTheSamePointsForEveryKind) {
  for (const SymmetricKind kind :
       {SymmetricKind::reversal, SymmetricKind::circle_radius, SymmetricKind::zero_search}) {
    for (const bool with_angles : {false, true}) {
      SymmetricReading reading = planned("any");
      reading.kind = kind;
      reading.raw = points(reading, with_angles);
      const RawSymmetricPoints back = read_points(raw_points_csv(reading), reading);
      ASSERT_EQ(back.points_mm.size(), reading.raw->points_mm.size());
      EXPECT_EQ(back.end, reading.raw->end);
      EXPECT_EQ(back.lines, reading.raw->lines);
      ASSERT_EQ(back.setting_rad.size(), reading.raw->setting_rad.size());
      ASSERT_EQ(back.encoder_rad.cols(), reading.raw->encoder_rad.cols());
      for (std::size_t i = 0; i < back.points_mm.size(); ++i) {
        // Written to 1e-8 mm and 1e-10 deg.
        EXPECT_LT((back.points_mm[i] - reading.raw->points_mm[i]).lpNorm<Eigen::Infinity>(),
                  0.51e-8);
        if (!back.setting_rad.empty()) {
          EXPECT_NEAR(back.setting_rad[i], reading.raw->setting_rad[i],
                      radians_from_degrees(0.51e-10));
        }
      }
      if (with_angles) {
        EXPECT_LT((back.encoder_rad - reading.raw->encoder_rad).lpNorm<Eigen::Infinity>(),
                  radians_from_degrees(0.51e-10));
      }
    }
  }
}

TEST(RawPointsCsv, CountsRepeatsThatAreEqual) {
  SymmetricReading reading = planned("quiet");
  RawSymmetricPoints raw;
  for (const char end : {'A', 'A', 'B', 'B'}) {
    raw.points_mm.emplace_back(end == 'A' ? 1.0 : -1.0, 0.0, 5.0);
    raw.end.push_back(end);
  }
  reading.raw = raw;
  const std::string csv = raw_points_csv(reading);
  EXPECT_THAT(csv, HasSubstr("repeat\nA,1,0,5,1\nA,1,0,5,2\n"));
  EXPECT_EQ(read_points(csv, reading).points_mm.size(), 4u);
}

TEST(RawPointsCsv, OfAPlannedReadingIsAHeaderToBeFilledIn) {
  EXPECT_EQ(raw_points_csv(planned("tip")),
            "end,x_mm,y_mm,z_mm,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n");
}

TEST(SymmetricPointWriter, KeepsTheUncertaintyOfTheEncoders) {
  SymmetricPointProcedure procedure;
  procedure.file = "folder/p.symmetric.toml";
  procedure.arm_file = "folder/nominal.arm.toml";
  procedure.readings = testing::wang2016_readings();
  procedure.u_encoder_rad = radians_from_arcseconds(2.0);
  const std::string text = symmetric_point_text(procedure);
  EXPECT_THAT(text, HasSubstr("u_encoder_arcsec = 2\n"));
  EXPECT_NEAR(read_back(text).u_encoder_rad, procedure.u_encoder_rad, 1e-18);
}

}  // namespace
}  // namespace armcal
