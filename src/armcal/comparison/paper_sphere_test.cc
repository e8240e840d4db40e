// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/paper_sphere.h"

#include <gtest/gtest.h>

#include <map>

namespace armcal {
namespace {

std::map<std::string, NeglectedEffect> by_name(const std::vector<NeglectedEffect>& effects) {
  std::map<std::string, NeglectedEffect> named;
  for (const NeglectedEffect& effect : effects) named[effect.name] = effect;
  return named;
}

// A still wrist takes the same error to every point of a small sphere.
TEST(PaperSphere, LosesNothingOfWhatIsMeasuredAndShowsTheRestOnlyInSeveralArticulations) {
  const auto effects = by_name(study_paper_sphere({.arms = 4}));
  const NeglectedEffect& lengths = effects.at("lengths");
  EXPECT_GE(lengths.arms, 3);
  EXPECT_LT(lengths.five_articulations.largest95_mm, 1e-6);
  EXPECT_LT(lengths.five_articulations.median_form_mm, 1e-6);
  for (const char* name : {"twists", "zeros", "offsets"}) {
    const NeglectedEffect& effect = effects.at(name);
    EXPECT_GT(effect.five_articulations.median_form_mm,
              5.0 * effect.one_articulation.median_form_mm)
        << name;
  }
}

TEST(PaperSphere, GivesTheSameDigitsOnOneAndTwoThreads) {
  const auto one = study_paper_sphere({.arms = 1, .threads = 1});
  const auto two = study_paper_sphere({.arms = 1, .threads = 2});
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].arms, two[i].arms);
    EXPECT_EQ(one[i].five_articulations.median_mm, two[i].five_articulations.median_mm);
  }
}

}  // namespace
}  // namespace armcal
