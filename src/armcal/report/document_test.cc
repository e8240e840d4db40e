// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/document.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace armcal {
namespace {

TEST(Document, HasTheHeadThatProgramsRelyOn) {
  DocumentHead head;
  head.command = "fit circle";
  head.inputs = {{"a.csv", "ab12"}};
  head.diagnostics.warning({"a.csv", 3, 1}, "odd", "look");
  const Json document = Json::parse(json_document(head, {{"radius_mm", 1.5}}));
  EXPECT_EQ(document["schema"], "armcal.result/1");
  EXPECT_EQ(document["command"], "fit circle");
  EXPECT_EQ(document["inputs"][0]["sha256"], "ab12");
  EXPECT_TRUE(document["seed"].is_null());
  EXPECT_EQ(document["warnings"][0]["message"], "odd");
  EXPECT_EQ(document["warnings"][0]["line"], 3);
  EXPECT_EQ(document["radius_mm"], 1.5);
  EXPECT_EQ(document.begin().key(), "schema");
}

TEST(Document, TellsErrorsWithTheirPlaces) {
  DocumentHead head;
  head.command = "fk";
  head.diagnostics.error({"b.csv", 7, 2}, "bad");
  const Json document = Json::parse(json_error(head, 2, "bad input"));
  EXPECT_EQ(document["error"]["exit_code"], 2);
  EXPECT_EQ(document["error"]["problems"][0]["file"], "b.csv");
}

TEST(Document, NumbersReadBackTheSameAndNaNIsNull) {
  EXPECT_EQ(json_of(Eigen::VectorXd(Eigen::Vector2d(0.1, 1e-300))).dump(), "[0.1,1e-300]");
  EXPECT_TRUE(json_number(std::numeric_limits<double>::quiet_NaN()).is_null());
  EXPECT_TRUE(json_of(std::optional<double>()).is_null());
  EXPECT_EQ(json_of(Eigen::MatrixXd(Eigen::Matrix2d::Identity())).dump(), "[[1.0,0.0],[0.0,1.0]]");
}

TEST(Document, SurvivesNamesThatAreNoUtf8) {
  DocumentHead head;
  head.inputs = {{"bad\xFFname", ""}};
  const Json document = Json::parse(json_document(head, Json::object()));
  EXPECT_EQ(document["inputs"].size(), 1u);
}

}  // namespace
}  // namespace armcal
