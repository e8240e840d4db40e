// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/calibration_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace armcal {
namespace {

using ::testing::HasSubstr;

Calibration small_calibration() {
  Calibration calibration;
  calibration.status = CalibrationStatus::converged;
  calibration.termination = Termination::converged;
  calibration.arm.name = calibration.nominal.name = "test arm";
  calibration.arm.joints.resize(2);
  calibration.parameters = {
      {"zero2", ParameterUnit::rad, 0.0, 0.001, 0.0001, ParameterStatus::free, 1.0, ""},
      {"b2", ParameterUnit::mm, 300.0, 300.25, 0.01, ParameterStatus::prior, 0.75, ""},
      {"cos1_2", ParameterUnit::rad, 0.0, 2e-5, 1e-6, ParameterStatus::free, 1.0, ""},
      {"d3", ParameterUnit::mm, 10.0, 10.0, 0.0, ParameterStatus::held, 0.0,
       "no reading depends on d3"},
  };
  calibration.free = {0, 1, 2};
  calibration.covariance = Eigen::Vector3d(1e-8, 1e-4, 1e-12).asDiagonal();
  calibration.covariance(0, 1) = calibration.covariance(1, 0) = -0.95 * 1e-6;
  calibration.unseen = {{"d3", "no reading depends on d3", {}}};
  calibration.degrees_of_freedom = 100;
  calibration.chi_squared = 400.0;
  calibration.sigma0 = 2.0;
  calibration.chi_squared_probability = 1e-20;
  calibration.check_coverage = 0.5;
  calibration.check_count = 20;
  calibration.flagged = {{"cone", {"cone.csv", 17, 0}, 0.5, 6.0, false}};
  return calibration;
}

TEST(CalibrationReport, SaysWhatAPersonNeeds) {
  const std::string text = text_result(small_calibration());
  EXPECT_THAT(text, HasSubstr("Calibration of test arm (2 joints)"));
  EXPECT_THAT(text, HasSubstr("deg"));
  EXPECT_THAT(text, HasSubstr("urad"));
  EXPECT_THAT(text, HasSubstr("prior, data 75 %"));
  EXPECT_THAT(text, HasSubstr("all uncertainties are widened by sigma0"));
  EXPECT_THAT(text, HasSubstr("the model is too small"));
  EXPECT_THAT(text, HasSubstr("no reading depends on d3"));
  EXPECT_THAT(text, HasSubstr("cone.csv:17: off by 0.500 mm, 6.0 times the usual"));
}

TEST(CalibrationReport, GivesProgramsTheKeysOfTheContract) {
  const Json json = json_result(small_calibration());
  for (const char* key :
       {"parameters", "rank", "unknowns", "condition_number", "null_space", "groups", "chi2", "dof",
        "sigma0", "iterations", "termination", "covariance", "covariance_of"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["parameters"][3]["status"], "held");
  EXPECT_EQ(json["covariance_of"], Json({"zero2", "b2", "cos1_2"}));
  ASSERT_EQ(json["correlations"].size(), 1u);
  EXPECT_EQ(json["correlations"][0]["parameters"], Json({"zero2", "b2"}));
  EXPECT_NEAR(json["correlations"][0]["correlation"].get<double>(), -0.95, 1e-12);
}

}  // namespace
}  // namespace armcal
