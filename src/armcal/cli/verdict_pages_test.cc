// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/testing/page_laws.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

// Pages of what the tool says of the examples of the documentation.
namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::page_in;
using testing::section_of;
using testing::tool;
using testing::words_of;

Json result_of(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  return tool(arguments).json();
}

// Whatever armcal words in English has Chinese words on a Chinese page.
void expect_chinese(const Json& tests, const std::string& words) {
  for (const Json& test : tests) {
    for (const char* key : {"name", "definition"}) {
      if (!test.contains(key)) continue;
      EXPECT_THAT(words, Not(HasSubstr(test[key].get<std::string>() + " | ")));
    }
    if (!test.contains("parts")) continue;
    for (const Json& part : test["parts"]) {
      EXPECT_THAT(words, Not(HasSubstr(part["name"].get<std::string>() + " | ")));
    }
    for (const Json& missing : test["missing"]) {
      EXPECT_THAT(words, Not(HasSubstr(missing.get<std::string>())));
    }
  }
}

std::string four_decimals(const Json& value) { return fmt::format("{:.4f}", value.get<double>()); }

TEST(VerdictPages, ShowTheVerificationsOfTheExamples) {
  for (const auto& [standard, file] :
       {std::pair("iso10360-12", "verification/reverification.verification.toml"),
        std::pair("b89.4.22", "verification/long-scale.verification.toml"),
        std::pair("iso10360-12", "verification/still-wrist.verification.toml")}) {
    const Json document = result_of({"verify", standard, example(file)});
    const std::string words = words_of(page_in("en", document));
    for (const Json& test : document["tests"]) {
      EXPECT_THAT(words, HasSubstr(test["name"].get<std::string>() + " | "));
      EXPECT_THAT(words, HasSubstr(four_decimals(test["mpe_mm"])));
    }
    expect_chinese(document["tests"], words_of(page_in("zh", document)));
  }
}

// Readings that are too few: the second position of the sphere is left out.
TEST(VerdictPages, SayWhatAnIncompleteVerificationLacks) {
  const testing::TemporaryFolder folder;
  std::string rows = testing::read_bytes(example("verification/still-wrist.csv"));
  rows.resize(rows.find("right,"));
  std::string file = testing::read_bytes(example("verification/still-wrist.verification.toml"));
  const std::string arm = "../arms/romer-infinite-2.0-as-printed.arm.toml";
  file.replace(file.find(arm), arm.size(), example("arms/romer-infinite-2.0-as-printed.arm.toml"));
  folder.write("still-wrist.csv", rows);
  const Json document = result_of(
      {"verify", "iso10360-12", folder.write("few.verification.toml", file), "--incomplete"});
  EXPECT_FALSE(document["tests"][0]["complete"].get<bool>());
  expect_chinese(document["tests"], words_of(page_in("zh", document)));
  EXPECT_THAT(words_of(page_in("zh", document)), HasSubstr("有 1 个标准球位置，要求 2 个"));
}

TEST(VerdictPages, ShowTheSphereTestsOfTheExamples) {
  const std::string arm = example("arms/romer-infinite-2.0.arm.toml");
  const Json document =
      result_of({"verify", "sphere", example("sphere/still-wrist.csv"), "--arm", arm, "--diameter",
                 "15.8754", "--tip-diameter", "6", "--limit", "0.15"});
  EXPECT_EQ(document["directions"].size(), document["sphere"]["residuals_mm"].size());
  const Page page = page_in("en", document);
  EXPECT_THAT(words_of(page),
              HasSubstr("Diameter error | " + four_decimals(document["diameter_error_mm"])));
  EXPECT_EQ(page.stamp.tone, Tone::warning);
  expect_chinese(document["tests"], words_of(page_in("zh", document)));
}

TEST(VerdictPages, ShowTheChecksOfTheExamples) {
  const testing::TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  Json document;
  for (const char* week : {"01", "02", "03", "04"}) {
    document = result_of({"check", example(fmt::format("check/week-{}.csv", week)), "--arm",
                          example("arms/seven-joint.arm.toml"), "--length", "400", "--limit",
                          "0.08", "--history", history, "--time", fmt::format("2026-01-{}", week),
                          "--baseline", "3"});
  }
  const Page page = page_in("en", document);
  EXPECT_THAT(words_of(page),
              HasSubstr("Largest deviation | " + four_decimals(document["tests"][0]["value_mm"])));
  EXPECT_THAT(words_of(page), HasSubstr("4 | 2026-01-04 | "));
  EXPECT_EQ(page.sections.size(), 5u);  // summary, two trends, definitions, origin
  expect_chinese(document["tests"], words_of(page_in("zh", document)));
}

TEST(VerdictPages, ShowTheStylusOfTheExamples) {
  const Json document = result_of({"probe", example("arms/romer-infinite-2.0.arm.toml"),
                                   example("sphere/five-articulations.csv"), "--sphere-diameter",
                                   "15.8754", "--tip-diameter", "6", "--limit", "0.03"});
  const Page page = page_in("en", document);
  EXPECT_EQ(page.stamp.word, "Qualified");
  EXPECT_THAT(words_of(page), HasSubstr(four_decimals(document["U_mm"]) + " mm"));
}

}  // namespace
}  // namespace armcal::cli
