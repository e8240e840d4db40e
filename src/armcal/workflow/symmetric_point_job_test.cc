// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/symmetric_point_job.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/io/arm_file.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

// Raw points of the whole procedure of the paper, as a reference machine with 2 um noise would give
// them.
void write_raw_readings(const testing::TemporaryFolder& folder, const ArmModel& truth) {
  RandomStream random(11);
  const RigidTransform machine_from_base = testing::random_transform(random, 800);
  const ForwardKinematics kinematics(truth);
  const auto point = [&](const Eigen::VectorXd& q) {
    const Eigen::Vector3d p = machine_from_base * kinematics.tip_in_base({q.data(), 6}) +
                              testing::random_normal_vector(random, 0.002);
    return fmt::format("{:.5f},{:.5f},{:.5f}", p.x(), p.y(), p.z());
  };
  std::string toml = "schema = \"armcal.symmetric/1\"\narm = \"nominal.arm.toml\"\n";
  for (const SymmetricReading& reading : testing::wang2016_readings()) {
    std::string csv = "end,x_mm,y_mm,z_mm\n";
    if (reading.kind == SymmetricKind::reversal) {
      for (int i = 0; i < 5; ++i) {
        csv += "A," + point(reading.posture_rad) + "\nB," + point(reading.posture_end_rad) + "\n";
      }
    } else {
      csv = "x_mm,y_mm,z_mm\n";
      for (int i = 0; i < 20; ++i) {
        Eigen::VectorXd q = reading.posture_rad;
        q(5) = 0.3 * i;
        csv += point(q) + "\n";
      }
    }
    folder.write(reading.name + ".csv", csv);
    toml += fmt::format(
        "[[reading]]\nname = \"{}\"\nkind = \"{}\"\njoint = {}\nfile = \"{}.csv\"\nposture_deg = [",
        reading.name, to_string(reading.kind), reading.joint, reading.name);
    for (int i = 0; i < 6; ++i) {
      toml +=
          fmt::format("{}{}", i == 0 ? "" : ", ", reading.posture_rad(i) * 180 / std::numbers::pi);
    }
    toml += "]\n";
    if (!reading.solves.empty()) toml += fmt::format("solves = \"{}\"\n", reading.solves);
  }
  folder.write("procedure.symmetric.toml", toml);
  folder.write("nominal.arm.toml", arm_text(testing::nominal_romer()));
}

TEST(SymmetricPointJob, CalibratesFromRawPointsOfTheReferenceMachine) {
  const testing::TemporaryFolder folder;
  write_raw_readings(folder, testing::consistent_romer());
  InputFiles files;
  const auto analysis =
      run_symmetric_point(files, folder.path("procedure.symmetric.toml"), std::nullopt, {});
  EXPECT_EQ(files.records().size(), 8u);  // procedure, arm, six tables
  EXPECT_EQ(analysis.reductions.size(), 6u);
  EXPECT_TRUE(analysis.is_consistent());
  const ArmModel& arm = analysis.adjustment.arm;
  EXPECT_NEAR(arm.links[3].a_mm, 78.312, 0.006);
  EXPECT_NEAR(arm.links[1].b_mm, 747.489, 0.006);
  EXPECT_NEAR(arm.tip.b_mm, 176.484, 0.004);
  for (const SymmetricReading& reading : analysis.readings) EXPECT_LT(reading.u, 0.003);
}

TEST(SymmetricPointJob, TellsMissingRawFilesAllAtOnce) {
  const testing::TemporaryFolder folder;
  write_raw_readings(folder, testing::consistent_romer());
  std::filesystem::remove(folder.path("l_PP1.csv"));
  std::filesystem::remove(folder.path("R.csv"));
  InputFiles files;
  try {
    static_cast<void>(
        run_symmetric_point(files, folder.path("procedure.symmetric.toml"), std::nullopt, {}));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("l_PP1.csv: error: cannot open"));
    EXPECT_THAT(error.what(), HasSubstr("R.csv: error: cannot open"));
  }
}

}  // namespace
}  // namespace armcal
