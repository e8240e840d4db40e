// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/calibration_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/core/utc_time.h"
#include "armcal/observations/empty_group.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/synthetic_readings.h"

namespace armcal {
namespace {

using testing::SyntheticReadings;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Cones, a length between them and reference points with times, some rows held out.
class CalibratedRows : public ::testing::Test {
 protected:
  CalibratedRows() {
    RandomStream random(61, 0);
    const ArmModel nominal = testing::random_arm(
        6, random, {.arbitrary_twists = false, .beta = false, .harmonics = 0, .mount = false});
    SyntheticReadings readings(testing::perturbed(nominal, random, 0.5, 0.002), 62, 0.01);
    groups_ = {readings.fixed_points({"P", "Q"}, 12), readings.length("P", "Q"),
               readings.reference_points(40, "A")};
    for (std::size_t row = 0; row < 40; row += 4) groups_[2].is_check[row] = true;
    groups_[2].time_is_utc = true;
    groups_[2].time_s =
        Eigen::VectorXd::Constant(40, static_cast<double>(*parse_utc_time("2026-03-02T09:15:30Z")));
    groups_[2].time_s(1) += 0.25;
    groups_[2].time_s(2) = kNone;
    groups_[2].temperature_c = Eigen::VectorXd::Constant(40, 20.5);
    groups_[0].time_s = Eigen::VectorXd::LinSpaced(24, 0.0, 23.0);
    calibration_ = calibrate(nominal, groups_, {});
    rows_ = json_of_rows(calibration_, groups_);
  }

  std::vector<ObservationGroup> groups_;
  Calibration calibration_;
  Json rows_;
};

TEST_F(CalibratedRows, AreColumnsOfOneLength) {
  ASSERT_TRUE(calibration_.ok());
  for (const auto& [name, column] : rows_.items()) EXPECT_EQ(column.size(), 24u + 1u + 40u) << name;
  for (const char* name :
       {"group", "file", "line", "check", "residual_mm", "nominal_residual_mm", "normalised",
        "u_mm", "time", "temperature_c", "q_deg", "tip_mm", "residual_vector_mm", "components"}) {
    EXPECT_TRUE(rows_.contains(name)) << name;
  }
}

TEST_F(CalibratedRows, NameTheirFileAndLine) {
  EXPECT_EQ(rows_["group"][0], "seats");
  EXPECT_EQ(rows_["file"][0], groups_[0].file);
  EXPECT_EQ(rows_["line"][1], groups_[0].lines[1]);
  EXPECT_EQ(rows_["group"][64], groups_[2].name);
  EXPECT_EQ(rows_["line"][64], groups_[2].lines[39]);
}

TEST_F(CalibratedRows, HaveTheRmsOfTheirGroups) {
  for (const GroupResult& group : calibration_.groups) {
    double squares[2] = {};
    double counts[2] = {};
    for (std::size_t i = 0; i < rows_["group"].size(); ++i) {
      if (rows_["group"][i] != group.name) continue;
      const bool check = rows_["check"][i].get<bool>();
      squares[check] += std::pow(rows_["residual_mm"][i].get<double>(), 2);
      counts[check] += 1.0;
    }
    // Rounded to 1e-9 mm each.
    EXPECT_NEAR(std::sqrt(squares[0] / counts[0]), group.fit.rms_mm, 1e-9);
    if (group.check) {
      EXPECT_NEAR(std::sqrt(squares[1] / counts[1]), group.check->rms_mm, 1e-9);
    }
  }
}

TEST_F(CalibratedRows, HaveVectorsAsLongAsTheirResiduals) {
  for (std::size_t i = 0; i < rows_["group"].size(); ++i) {
    if (i == 24) continue;  // the length
    double square = 0.0;
    for (const Json& coordinate : rows_["residual_vector_mm"][i])
      square += std::pow(coordinate.get<double>(), 2);
    EXPECT_NEAR(std::sqrt(square), rows_["residual_mm"][i].get<double>(), 3e-9);
    EXPECT_EQ(rows_["components"][i].size(), 3u);
    EXPECT_NEAR(rows_["q_deg"][i][5].get<double>(),
                degrees_from_radians(i < 24 ? groups_[0].encoder_rad(5, static_cast<int>(i))
                                            : groups_[2].encoder_rad(5, static_cast<int>(i) - 25)),
                1e-10);
  }
}

TEST_F(CalibratedRows, OfALengthHaveNoPlaceButASign) {
  for (const char* name : {"q_deg", "tip_mm", "residual_vector_mm", "time", "temperature_c"})
    EXPECT_TRUE(rows_[name][24].is_null()) << name;
  ASSERT_EQ(rows_["components"][24].size(), 1u);
  EXPECT_EQ(rows_["components"][24][0], rows_["normalised"][24]);
  EXPECT_NEAR(std::abs(rows_["normalised"][24].get<double>()),
              rows_["residual_mm"][24].get<double>() / groups_[1].u_mm(0), 1e-6);
}

TEST_F(CalibratedRows, SayWhenTheyWereRead) {
  EXPECT_EQ(rows_["time"][3], 3.0);  // plain seconds stay numbers
  EXPECT_EQ(rows_["time"][25], "2026-03-02T09:15:30Z");
  EXPECT_EQ(rows_["time"][26], "2026-03-02T09:15:30.250Z");
  EXPECT_TRUE(rows_["time"][27].is_null());
  EXPECT_TRUE(rows_["temperature_c"][0].is_null());
  EXPECT_EQ(rows_["temperature_c"][25], 20.5);
}

TEST(CalibrationRows, KeepHostileNamesAndRoundWhatNobodyReads) {
  ObservationGroup group = empty_group(ReferenceKind::fixed_point,
                                       std::string("<script>\"\0\xE2\x80\xAE", 13), 1, 2, 0.1);
  group.encoder_rad << radians_from_degrees(46.469), radians_from_degrees(-1e-13);
  Calibration calibration;
  RowResidual row;
  row.residual_mm = 0.123456789012345;
  row.nominal_residual_mm = kNone;
  row.point_mm = {1000.00000049, -2e-9, 0.1};
  row.vector_mm.setConstant(kNone);
  row.components = Eigen::Vector3d(1.0, -2.0, 2.0);
  calibration.residuals = {row};
  const Json rows = json_of_rows(calibration, std::vector<ObservationGroup>{group});
  EXPECT_EQ(rows["group"][0], group.name);
  EXPECT_EQ(rows["residual_mm"].dump(), "[0.123456789]");
  EXPECT_EQ(rows["q_deg"].dump(), "[[46.469,0.0]]");
  EXPECT_EQ(rows["tip_mm"].dump(), "[[1000.0,0.0,0.1]]");
  EXPECT_EQ(rows["normalised"].dump(), "[1.732051]");
  EXPECT_EQ(rows["nominal_residual_mm"].dump(), "[null]");
  EXPECT_EQ(rows["residual_vector_mm"].dump(), "[null]");
}

TEST(CalibrationRows, OfNothingAreEmptyColumns) {
  const Json rows = json_of_rows({}, {});
  EXPECT_EQ(rows.size(), 14u);
  for (const auto& [name, column] : rows.items()) EXPECT_EQ(column.dump(), "[]") << name;
}

}  // namespace
}  // namespace armcal
