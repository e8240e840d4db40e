// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/error_sources.h"

#include <gtest/gtest.h>

#include <set>

namespace armcal {
namespace {

TEST(ErrorSources, AreOffUnlessSwitchedOn) {
  for (const ErrorSource& source : error_source_list()) {
    EXPECT_FALSE(source.is_on(ErrorSources{})) << source.name;
  }
}

TEST(ErrorSources, SwitchOnOneByOne) {
  for (const ErrorSource& source : error_source_list()) {
    ErrorSources errors;
    source.switch_on(errors);
    for (const ErrorSource& other : error_source_list()) {
      EXPECT_EQ(other.is_on(errors), other.name == source.name) << other.name;
    }
  }
}

TEST(ErrorSources, TypicalIsEverythingButBlunders) {
  const ErrorSources errors = ErrorSources::typical();
  for (const ErrorSource& source : error_source_list()) {
    EXPECT_EQ(source.is_on(errors), source.name != "blunders") << source.name;
  }
}

TEST(ErrorSources, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const ErrorSource& source : error_source_list()) {
    names.insert(source.name);
    EXPECT_FALSE(source.brief.empty());
  }
  EXPECT_EQ(names.size(), error_source_list().size());
}

}  // namespace
}  // namespace armcal
