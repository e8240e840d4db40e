// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace armcal::testing {

/// Folder of published reference answers and measured data: environment ARMCAL_REFERENCE_DATA, else
/// the folder set when the tests were built.
[[nodiscard]] std::filesystem::path reference_data();

/// Root of this repository, for the examples.
[[nodiscard]] std::filesystem::path repository();

}  // namespace armcal::testing

/// Skips the test, visibly, where the reference data are not at hand.
#define ARMCAL_NEEDS_REFERENCE_DATA()                                                            \
  if (!std::filesystem::is_directory(::armcal::testing::reference_data()))                       \
  GTEST_SKIP() << "reference data not found at " << ::armcal::testing::reference_data().string() \
               << "; set ARMCAL_REFERENCE_DATA to their folder"
