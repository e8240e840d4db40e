// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using ::testing::HasSubstr;
using testing::tool;

TEST(DemoCommand, TellsThePapersStory) {
  const auto result = tool({"demo"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.out, HasSubstr("104.700 agrees with both"));
  EXPECT_EQ(tool({"demo", "paper"}).out, result.out);
  EXPECT_NEAR(tool({"demo", "paper", "--json"}).json()["sphere"]["relative_error"].get<double>(),
              -0.003836, 5e-7);
  EXPECT_EQ(tool({"demo", "nonsense"}).code, kWrongInput);
}

}  // namespace
}  // namespace armcal::cli
