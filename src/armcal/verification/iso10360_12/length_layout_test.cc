// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/length_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/verification/iso10360_12/length_error_bi.h"
#include "armcal/verification/iso10360_12/length_error_uni.h"

namespace armcal::iso10360_12 {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// 5 lengths up to 850 mm at 7 positions, 3 times, all too long by 0.01 %.
std::vector<MeasuredLength> full_test() {
  std::vector<MeasuredLength> lengths;
  for (int position = 1; position <= 7; ++position) {
    for (const double length : {50.0, 250.0, 450.0, 650.0, 850.0}) {
      for (int repeat = 1; repeat <= 3; ++repeat) {
        lengths.push_back({"P" + std::to_string(position), length, 1.0001 * length, repeat, ""});
      }
    }
  }
  return lengths;
}

TEST(LengthError, IsTheLargestOfAHundredAndFive) {
  auto lengths = full_test();
  ASSERT_EQ(lengths.size(), 105u);
  lengths[10].measured_mm = lengths[10].calibrated_mm - 0.2;  // 650 mm at P1, repeat 2
  const TestResult uni = length_error_uni(lengths, 1250.0);
  EXPECT_EQ(uni.symbol, "E_Uni");
  EXPECT_TRUE(uni.complete());
  EXPECT_NEAR(uni.value_mm.value(), -0.2, 1e-12);
  EXPECT_EQ(uni.parts.size(), 105u);
  EXPECT_EQ(uni.parts[10].name, "650 mm at P1, repeat 2");
  EXPECT_EQ(uni.parts[10].length_mm, 650.0);
  const TestResult bi = length_error_bi(lengths, 1250.0);
  EXPECT_EQ(bi.symbol, "E_Bi");
  EXPECT_EQ(bi.value_mm, uni.value_mm);
  EXPECT_NE(bi.definition, uni.definition);
}

TEST(LengthLayout, AcceptsMoreThanIsAskedForInAnyOrder) {
  auto lengths = full_test();
  for (const MeasuredLength& length : full_test()) lengths.insert(lengths.begin(), length);
  lengths.push_back({"P8", 1000.0, 1000.0, 1, ""});  // a sixth length, but only once
  EXPECT_THAT(missing_lengths(full_test(), 1250.0), IsEmpty());
  lengths.pop_back();
  EXPECT_THAT(missing_lengths(lengths, {}), IsEmpty());
}

TEST(LengthLayout, SaysWhatIsMissing) {
  auto lengths = full_test();
  lengths.erase(lengths.begin());  // 50 mm at P1, repeat 1
  EXPECT_THAT(missing_lengths(lengths, 1250.0),
              ElementsAre("length 50 mm measured 2 times at position P1, 3 are asked for"));
  EXPECT_EQ(length_error_uni(lengths, 1250.0).symbol, "");

  EXPECT_THAT(missing_lengths(full_test(), 1500.0),
              ElementsAre("the longest length of 850 mm is 57 % of the reach of 1500 mm, 66 % are "
                          "asked for"));

  std::erase_if(lengths, [](const auto& each) { return each.calibrated_mm < 100.0; });
  std::erase_if(lengths, [](const auto& each) { return each.position == "P7"; });
  EXPECT_THAT(missing_lengths(lengths, {}),
              ElementsAre("4 calibrated lengths, 5 are asked for",
                          "length 250 mm at 6 positions, 7 are asked for",
                          "length 450 mm at 6 positions, 7 are asked for",
                          "length 650 mm at 6 positions, 7 are asked for",
                          "length 850 mm at 6 positions, 7 are asked for"));
  EXPECT_THAT(missing_lengths({}, 1250.0), ElementsAre("0 calibrated lengths, 5 are asked for"));
}

TEST(LengthLayout, TakesBarsOfNearlyOneLengthForOne) {
  auto lengths = full_test();
  for (std::size_t i = 0; i < lengths.size(); i += 2) lengths[i].calibrated_mm += 0.012;
  EXPECT_THAT(missing_lengths(lengths, 1250.0), IsEmpty());
}

TEST(LengthError, TellsLengthsThatCannotBe) {
  auto lengths = full_test();
  lengths[0].measured_mm = 50.0 / 25.4;
  lengths[1].measured_mm = 30.0;
  lengths[2].measured_mm = NAN;
  const TestResult result = length_error_bi(lengths, 1250.0);
  EXPECT_THAT(result.problems,
              ElementsAre("50 mm at P1, repeat 1: 1.9685 mm was measured: 25.4 times too small, as "
                          "if in inches",
                          "50 mm at P1, repeat 2: 30.0000 mm was measured: another length?",
                          "50 mm at P1, repeat 3: measured length nan mm must be larger than 0"));
  EXPECT_EQ(result.symbol, "");
  EXPECT_FALSE(length_error_bi({}, {}).value_mm.has_value());
}

}  // namespace
}  // namespace armcal::iso10360_12
