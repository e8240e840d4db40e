// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/language.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <stdexcept>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;
using testing::repository;

// Keys that sources put together: the part that is a literal of theirs, up to its slot.
const std::vector<std::string> kComposed = {"tone.",
                                            "calibration.kind_of.",
                                            "numerics.reason.",
                                            "fit.title.",
                                            "fit.form.",
                                            "parameters.status_",
                                            "symmetric.kind_",
                                            "verification.verdict.",
                                            "verification.stamp.",
                                            "verification.sentence.",
                                            "verification.rule.",
                                            "verification.budget.source.",
                                            "sphere_test.value.",
                                            "sphere_test.sentence.",
                                            "check.stamp.",
                                            "check.sentence.",
                                            "check.value.",
                                            "check.rule.",
                                            "probe.stamp.",
                                            "probe.sentence.",
                                            "verification_plan.purpose."};
// Phrases of documents, found by their English text.
const std::vector<std::string> kPhrases = {"verification.phrase", "check.phrase",
                                           "verification_plan.phrase", "compare.phrase",
                                           "demo.phrase"};
// Chinese sentences follow each other without a space.
const std::set<std::string> kMayBeEmpty = {"verification.between_sentences"};

bool is_source(const std::filesystem::path& path) {
  return path.extension() == ".cc" && !path.stem().string().ends_with("_test");
}

std::string sources_below(const char* folder, bool (*wanted)(const std::filesystem::path&)) {
  std::string text;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(repository() / folder)) {
    if (entry.is_regular_file() && wanted(entry.path())) text += read_bytes(entry.path());
  }
  return text;
}

const std::string& report_sources() {
  static const std::string text = sources_below("src/armcal/report", is_source);
  return text;
}

std::string quoted(const std::string& key) { return fmt::format("\"{}\"", key); }

// Where the whole key stands: as a literal, in the layout of the page, or in the script.
bool stands_in_sources(const std::string& key) {
  static const std::string layout =
      read_bytes(repository() / "src/armcal/report/html/page.mustache");
  static const std::string script =
      sources_below("web/report/src",
                    [](const std::filesystem::path& path) { return path.extension() == ".js"; });
  if (report_sources().find(quoted(key)) != std::string::npos) return true;
  if (key.starts_with("page.")) {
    return layout.find(fmt::format("{{{{say_{}}}}}", key.substr(5))) != std::string::npos;
  }
  return key.starts_with("script.") && script.find(quoted(key.substr(7))) != std::string::npos;
}

bool is_composed(const std::string& key) {
  const auto begins_key = [&](const std::string& stem) { return key.starts_with(stem); };
  return std::any_of(kComposed.begin(), kComposed.end(), begins_key) ||
         std::any_of(kPhrases.begin(), kPhrases.end(), begins_key);
}

// What a text looks like with a mark for each value, and so which values it shows.
std::set<int> slots_of(const Language& say, const std::string& key) {
  const std::string text = say(key, "\x01", "\x02", "\x03", "\x04", "\x05", "\x06");
  std::set<int> slots;
  for (const char c : text) {
    if (c >= '\x01' && c <= '\x06') slots.insert(c - '\x01');
  }
  return slots;
}

TEST(Languages, SayTheSameThings) {
  const Language& english = Language::named("en");
  for (const std::string& code : Language::codes()) {
    const Language& other = Language::named(code);
    EXPECT_EQ(other.code(), code);
    ASSERT_EQ(other.keys(), english.keys());
    for (const std::string& key : english.keys()) {
      EXPECT_EQ(slots_of(other, key), slots_of(english, key)) << code << ": " << key;
    }
  }
}

TEST(Languages, LeaveNothingUnsaid) {
  for (const std::string& code : Language::codes()) {
    const Language& say = Language::named(code);
    for (const std::string& key : say.keys()) {
      if (kMayBeEmpty.contains(key)) continue;
      EXPECT_NE(say(key, 1, 2, 3, 4, 5, 6), "") << code << ": " << key;
    }
  }
}

TEST(Languages, HaveNoTextThatNobodyUses) {
  for (const std::string& key : Language::named("en").keys()) {
    EXPECT_TRUE(stands_in_sources(key) || is_composed(key)) << key;
  }
  for (const std::string& stem : kComposed) {
    EXPECT_THAT(report_sources(), HasSubstr(fmt::format("\"{}{{}}", stem)));
  }
  for (const std::string& stem : kPhrases) EXPECT_THAT(report_sources(), HasSubstr(quoted(stem)));
}

TEST(Languages, HaveEveryTextThatSourcesAskFor) {
  const Language& say = Language::named("en");
  const std::regex asked("say\\(\\s*\"([a-z0-9_.]+)\"");
  const std::string& text = report_sources();
  std::size_t count = 0;
  for (std::sregex_iterator each(text.begin(), text.end(), asked), end; each != end; ++each) {
    EXPECT_TRUE(say.has((*each)[1].str())) << (*each)[1];
    ++count;
  }
  EXPECT_GT(count, 300U);  // the search finds what it is for
}

TEST(Language, PutsValuesInTheirPlacesAndLooksAtThemOnce) {
  const Language& say = Language::named("en");
  const std::string text = say("calibration.flagged_row", "{1}{0}", "{9}", "{{", "}");
  EXPECT_THAT(text, HasSubstr("{1}{0}"));
  EXPECT_THAT(text, HasSubstr("{9}"));
  EXPECT_THAT(text, HasSubstr("{{"));
}

TEST(Language, TellsProgrammersOfKeysAndValuesThatAreMissing) {
  const Language& say = Language::named("zh");
  EXPECT_FALSE(say.has("no.such.key"));
  try {
    (void)say("no.such.key");
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "languages/zh.json has no text \"no.such.key\"");
  }
  EXPECT_THROW((void)say("calibration.flagged_row", "one"), std::logic_error);
}

TEST(Language, NamesTheLanguagesThatThereAre) {
  for (const char* code : {"xx", "", "EN", "zh-CN"}) {
    try {
      (void)Language::named(code);
      FAIL() << code;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()),
                fmt::format("there is no language \"{}\" (there are: en, zh)", code));
    }
  }
}

}  // namespace
}  // namespace armcal
