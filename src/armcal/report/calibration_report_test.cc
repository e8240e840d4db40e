// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/calibration_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/io/session_file.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Calibration small_calibration() {
  Calibration calibration;
  calibration.status = CalibrationStatus::converged;
  calibration.termination = Termination::converged;
  calibration.arm.name = "test arm";
  calibration.arm.joints.resize(2);
  calibration.arm.links.resize(1);
  calibration.nominal = calibration.arm;
  calibration.arm.links[0].b_mm = 300.25;
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
  calibration.convergence = {{"geometry", 4, {5e6, 500.0}}, {"all", 5, {450.0, 400.0}}};
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
  for (const char* key : {"parameters", "rank", "unknowns", "condition_number", "null_space",
                          "groups", "chi2", "dof", "sigma0", "iterations", "termination",
                          "convergence", "covariance", "covariance_of", "arm", "nominal_arm"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["parameters"][3]["status"], "held");
  EXPECT_EQ(json["covariance_of"], Json({"zero2", "b2", "cos1_2"}));
  ASSERT_EQ(json["correlations"].size(), 1u);
  EXPECT_EQ(json["correlations"][0]["parameters"], Json({"zero2", "b2"}));
  EXPECT_NEAR(json["correlations"][0]["correlation"].get<double>(), -0.95, 1e-12);
}

TEST(CalibrationReport, SaysHowItConverged) {
  const Json json = json_result(small_calibration());
  ASSERT_EQ(json["convergence"].size(), 2u);
  EXPECT_EQ(json["convergence"][0]["stage"], "geometry");
  EXPECT_EQ(json["convergence"][1]["unknowns"], 5);
  EXPECT_EQ(json["convergence"][1]["costs"], Json({450.0, 400.0}));
}

TEST(CalibrationReport, HoldsBothArmsAsTheirFiles) {
  const Json json = json_result(small_calibration());
  EXPECT_THAT(json["arm"].get<std::string>(), HasSubstr("b_mm = 300.25"));
  EXPECT_THAT(json["nominal_arm"].get<std::string>(), Not(HasSubstr("300.25")));
}

TEST(CalibrationReport, SaysWhatWasAskedFor) {
  SessionEstimate asked;
  asked.hold = {"alpha*"};
  asked.prior_zero_rad = 0.01;
  asked.prior_of = {{"a7", 50.0}};
  asked.loss = "huber";
  asked.check_fraction = 0.25;
  const Json session = json_result(small_calibration(), {}, asked)["session"];
  EXPECT_EQ(session["hold"], Json({"alpha*"}));
  EXPECT_EQ(session["loss"], "huber");
  EXPECT_EQ(session["check_fraction"], 0.25);
  EXPECT_EQ(session["prior"]["zero_rad"], 0.01);
  EXPECT_TRUE(session["prior"]["length_mm"].is_null());
  EXPECT_EQ(session["prior"]["parameters"], Json({{"a7", 50.0}}));
}

}  // namespace
}  // namespace armcal
