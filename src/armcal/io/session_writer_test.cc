// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/session_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Session read_session(const std::string& path, const std::string& text) {
  Diagnostics diagnostics;
  const auto session = read_session_file({path, text, "UTF-8", ""}, diagnostics);
  EXPECT_TRUE(session.has_value()) << diagnostics.to_text() << text;
  return session.value_or(Session{});
}

void expect_same(const SessionGroup& one, const SessionGroup& other) {
  EXPECT_EQ(one.name, other.name);
  EXPECT_EQ(one.kind, other.kind);
  EXPECT_EQ(one.file, other.file);
  EXPECT_EQ(one.artefact_file, other.artefact_file);
  EXPECT_EQ(one.u_mm, other.u_mm);
  EXPECT_EQ(one.u_encoder_rad, other.u_encoder_rad);
  EXPECT_EQ(one.set, other.set);
  EXPECT_EQ(one.place, other.place);
  EXPECT_EQ(one.place_to, other.place_to);
  EXPECT_EQ(one.length_mm, other.length_mm);
  EXPECT_EQ(one.joint, other.joint);
  EXPECT_EQ(one.turn_rad, other.turn_rad);
  EXPECT_EQ(one.radius_mm, other.radius_mm);
  EXPECT_EQ(one.tip_radius_mm, other.tip_radius_mm);
  EXPECT_EQ(one.lever_mm, other.lever_mm);
  EXPECT_EQ(one.offset_mm, other.offset_mm);
  EXPECT_EQ(one.target, other.target);
  EXPECT_EQ(one.table.keep_duplicates, other.table.keep_duplicates);
  EXPECT_EQ(one.table.keep_zero_points, other.table.keep_zero_points);
}

void expect_same(const Session& one, const Session& other) {
  EXPECT_EQ(one.name, other.name);
  EXPECT_EQ(one.arm_file, other.arm_file);
  ASSERT_EQ(one.groups.size(), other.groups.size());
  for (std::size_t i = 0; i < one.groups.size(); ++i) {
    expect_same(one.groups[i], other.groups[i]);
  }
  const SessionEstimate& a = one.estimate;
  const SessionEstimate& b = other.estimate;
  EXPECT_EQ(a.hold, b.hold);
  EXPECT_EQ(a.prior_length_mm, b.prior_length_mm);
  EXPECT_EQ(a.prior_zero_rad, b.prior_zero_rad);
  EXPECT_EQ(a.prior_twist_rad, b.prior_twist_rad);
  EXPECT_EQ(a.prior_harmonic_rad, b.prior_harmonic_rad);
  EXPECT_EQ(a.prior_of, b.prior_of);
  EXPECT_EQ(a.harmonics, b.harmonics);
  EXPECT_EQ(a.loss, b.loss);
  EXPECT_EQ(a.check_fraction, b.check_fraction);
  EXPECT_EQ(a.check_seed, b.check_seed);
}

constexpr const char* kEverything = R"(schema = "armcal.session/1"
name = "a \"name\""
arm = "../nominal.arm.toml"
u_encoder_arcsec = 1.5
[[observations]]
kind = "reference_points"
file = "points/cmm.csv"
setup = "cmm"
u_mm = 0.003
offset_mm = [1, 2, 3.5]
target = "reflector"
keep_duplicates = true
keep_zero_points = true
[[observations]]
kind = "reference_poses"
file = "poses.csv"
lever_mm = 80
set = "check"
[[observations]]
kind = "fixed_point"
name = "in the cone"
file = "cone.csv"
point = "A"
[[observations]]
kind = "length"
from = "A"
to = "B"
length_mm = 240.013
u_mm = 0.002
[[observations]]
kind = "artefact"
file = "plate.csv"
artefact = "../plate-coordinates.csv"
placement = "bench"
[[observations]]
kind = "reversal"
file = "reversal.csv"
joint = 3
turn_deg = -179.5
[[observations]]
kind = "circle_radius"
file = "circle.csv"
joint = 6
[[observations]]
kind = "sphere"
file = "sphere.csv"
diameter_mm = 25.4
tip_diameter_mm = 3
inside = true
[[observations]]
kind = "plane"
u_encoder_arcsec = 2
file = "plane.csv"
plane = "table"
[estimate]
hold = ["alpha*", "d5"]
prior = { length_mm = 2.0, zero_deg = 0.5, twist_deg = 0.4, harmonic_rad = 1e-4, a7_mm = 50, zero3_deg = 0.1 }
harmonics = 1
loss = "cauchy"
check_fraction = 0.3
check_seed = 5
)";

TEST(SessionText, ReadsBackAsTheSameSession) {
  for (const char* path : {"s.session.toml", "one/two/s.session.toml"}) {
    const Session session = read_session(path, kEverything);
    const std::string text = session_text(session, "a note");
    expect_same(session, read_session(path, text));
    EXPECT_EQ(text, session_text(read_session(path, text), "a note"));
  }
}

TEST(SessionText, ReadsBackForTheExamples) {
  for (const char* name : {"calibration/seats", "calibration/tracker", "real/positioner-poses"}) {
    SCOPED_TRACE(name);
    const auto path = testing::repository() / "examples" / (std::string(name) + ".session.toml");
    const Session session = read_session(path.string(), testing::read_bytes(path));
    expect_same(session, read_session(path.string(), session_text(session)));
  }
}

TEST(SessionText, SaysOnceWhatAllEncodersShare) {
  Session session = read_session("s.session.toml", kEverything);
  for (SessionGroup& group : session.groups) group.u_encoder_rad = 1e-5;
  const std::string text = session_text(session);
  EXPECT_EQ(text.find("u_encoder_arcsec"), text.rfind("u_encoder_arcsec"));
  expect_same(session, read_session("s.session.toml", text));
}

TEST(SessionText, SaysNothingThatIsSoAnyway) {
  Session session = read_session("s.session.toml", kEverything);
  session.groups.resize(1);
  session.groups[0].name = "cmm";
  session.estimate = {};
  const std::string text = session_text(session);
  EXPECT_THAT(text, Not(HasSubstr("[estimate]")));
  EXPECT_THAT(text, Not(HasSubstr("name = \"cmm\"")));
  session.estimate.prior_zero_rad = session.estimate.prior_twist_rad = 0.1;
  EXPECT_THAT(session_text(session), HasSubstr("prior = { angle_deg = "));
}

}  // namespace
}  // namespace armcal
