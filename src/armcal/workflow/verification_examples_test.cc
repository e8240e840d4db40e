// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/verification_examples.h"

#include <gtest/gtest.h>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/workflow/input_files.h"

namespace armcal {
namespace {

// The last decimal of an angle may turn on the rounding of a machine.
constexpr double kLastDecimal_rad = 2e-6;

TEST(VerificationExamples, AreWhatTheLaboratoryMeasures) {
  const auto folder = testing::repository() / "examples";
  InputFiles files;
  const auto arm = files.arm((folder / "arms/romer-infinite-2.0.arm.toml").string());
  files.require_good();
  const testing::TemporaryFolder fresh;
  for (const auto& [name, text] : testing::verification_example_tables(*arm)) {
    const auto made = files.joints(fresh.write(name, text), arm->joint_count(), {});
    const auto kept =
        files.joints((folder / "verification" / name).string(), arm->joint_count(), {});
    files.require_good();
    ASSERT_EQ(made->count(), kept->count()) << name;
    const double difference = (made->encoder_rad - kept->encoder_rad).cwiseAbs().maxCoeff();
    EXPECT_LT(difference, kLastDecimal_rad) << name << ": run armcal_make_verification_examples";
  }
}

}  // namespace
}  // namespace armcal
