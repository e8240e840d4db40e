// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/io/arm_file.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/robot_descriptions.h"
#include "armcal/testing/same_poses.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

ArmModel arm_of(const std::string& text) {
  Diagnostics diagnostics;
  return read_arm({"converted", text, "UTF-8", ""}, diagnostics).value();
}

TEST(Conversion, ThereAndBackHasTheSamePoses) {
  // Every shipped arm, through both conventions.
  for (const auto& entry :
       std::filesystem::directory_iterator(testing::repository() / "examples/arms")) {
    const testing::TemporaryFolder folder;
    InputFiles files;
    const ArmModel original = files.arm(entry.path().string()).value();
    for (const ArmFormat format : {ArmFormat::dh_classic, ArmFormat::dh_modified}) {
      InputFiles there;
      const std::string table = convert(there, {entry.path().string(), {}, format, false}, {});
      InputFiles back;
      const ArmModel again =
          arm_of(convert(back, {folder.write("t.dh.toml", table), {}, ArmFormat::arm, false}, {}));
      const ForwardKinematics one(original);
      const ForwardKinematics other(again);
      RandomStream random(1);
      for (int i = 0; i < 20; ++i) {
        const auto q = testing::random_posture(original.joint_count(), random);
        const RigidTransform a = one.base_from_tip(q);
        const RigidTransform b = other.base_from_tip(q);
        EXPECT_LT((a.translation_mm - b.translation_mm).norm(), 1e-10) << entry.path();
        EXPECT_LT((a.rotation - b.rotation).norm(), 1e-13) << entry.path();
      }
    }
  }
}

TEST(Conversion, TakesASpreadsheetWhenItsConventionIsTold) {
  const testing::TemporaryFolder folder;
  const std::string csv = "theta_deg,d_mm,a_mm,alpha_deg\n0.0,10.0,20.0,90.0\n0.0,5.0,7.0,0.0\n";
  const std::string path = folder.write("t.csv", csv);
  InputFiles files;
  EXPECT_THROW(static_cast<void>(convert(files, {path, {}, ArmFormat::arm, false}, {})),
               InputError);
  InputFiles again;
  EXPECT_EQ(convert(again, {path, ArmFormat::dh_classic, ArmFormat::dh_classic, true}, {}), csv);
}

TEST(Conversion, RefusesASpreadsheetForWhatItCannotSay) {
  const testing::TemporaryFolder folder;
  RandomStream random(2);
  const std::string path = folder.write("a.arm.toml", arm_text(testing::random_arm(4, random)));
  InputFiles files;
  try {
    static_cast<void>(convert(files, {path, {}, ArmFormat::dh_classic, true}, {}));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("a D-H table has no place for the encoder harmonics of joint 1: left out"));
    EXPECT_THAT(error.what(), HasSubstr("write it as *.dh.toml"));
  }
}

TEST(Conversion, ThroughUrdfAndBackHasTheSamePoses) {
  for (const auto& entry :
       std::filesystem::directory_iterator(testing::repository() / "examples/arms")) {
    const testing::TemporaryFolder folder;
    InputFiles files;
    const ArmModel original = files.arm(entry.path().string()).value();
    InputFiles there;
    const std::string urdf = convert(there, {entry.path().string(), {}, ArmFormat::urdf}, {});
    InputFiles back;
    const std::string path = folder.write("robot.urdf", urdf);
    testing::expect_same_poses(original, arm_of(convert(back, {path, {}, ArmFormat::arm}, {})));
    EXPECT_TRUE(back.diagnostics().entries().empty());
  }
}

TEST(Conversion, AUrdfBecomesADhTable) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.write("panda.urdf", testing::kPandaUrdf);
  const std::string chain = "panda_link0:panda_link8";
  InputFiles there;
  const std::string table = convert(there, {path, {}, ArmFormat::dh_modified, false, chain}, {});
  EXPECT_THAT(there.diagnostics().to_text(),
              HasSubstr("a D-H table has no place for the limits of joint 7: left out"));
  InputFiles back;
  const std::string again = folder.write("panda.dh.toml", table);
  InputFiles files;
  const auto example = testing::repository() / "examples/arms/panda.arm.toml";
  testing::expect_same_poses(files.arm(example.string()).value(),
                             arm_of(convert(back, {again, {}, ArmFormat::arm}, {})));
}

TEST(Conversion, ToldAChainItWantsAUrdf) {
  const std::string path = (testing::repository() / "examples/arms/ur10.arm.toml").string();
  InputFiles files;
  try {
    static_cast<void>(convert(files, {path, {}, ArmFormat::arm, false, "a:b"}, {}));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is no URDF: --chain has no meaning for it"));
  }
}

TEST(Conversion, FormatsAreKnownByTheirNames) {
  for (const std::string& name : arm_format_names()) EXPECT_TRUE(arm_format(name)) << name;
  EXPECT_EQ(arm_format("c-header"), ArmFormat::c_header);
  EXPECT_EQ(arm_format("csv-line"), ArmFormat::csv_line);
  EXPECT_FALSE(arm_format("sdf"));
}

}  // namespace
}  // namespace armcal
