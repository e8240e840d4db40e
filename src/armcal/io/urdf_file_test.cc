// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/urdf_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/io/arm_file.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/robot_descriptions.h"
#include "armcal/testing/same_poses.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using testing::expect_same_poses;
using ::testing::HasSubstr;

struct Outcome {
  std::optional<ArmModel> arm;
  std::string messages;
};

Outcome read_robot(const std::string& text, const std::optional<std::string>& chain = {}) {
  Diagnostics diagnostics;
  auto arm = read_urdf({"r.urdf", text, "UTF-8", ""}, chain, diagnostics);
  EXPECT_NE(arm.has_value(), diagnostics.has_errors());
  return {std::move(arm), diagnostics.to_text()};
}

ArmModel example_arm(const std::string& name) {
  const auto path = testing::repository() / "examples/arms" / (name + ".arm.toml");
  Diagnostics diagnostics;
  return read_arm({name, testing::read_bytes(path), "UTF-8", ""}, diagnostics).value();
}

/// Two joints a-b-c; `first` and `second` stand within the joints.
std::string two_joints(const std::string& first, const std::string& second = "",
                       const std::string& type = "continuous") {
  return fmt::format(R"(<robot name="two">
<link name="a"/><link name="b"/><link name="c"/>
<joint name="one" type="{}"><parent link="a"/><child link="b"/>{}</joint>
<joint name="two" type="continuous"><parent link="b"/><child link="c"/>{}</joint>
</robot>)",
                     type, first, second);
}

TEST(UrdfFile, AMakersUr10HasThePosesOfItsDhTable) {
  const Outcome outcome = read_robot(testing::kUr10Urdf);
  ASSERT_TRUE(outcome.arm) << outcome.messages;
  expect_same_poses(*outcome.arm, example_arm("ur10"));
  EXPECT_EQ(outcome.messages, "");
  EXPECT_DOUBLE_EQ(outcome.arm->joints[2].max_rad, 3.14159265359);
  EXPECT_TRUE(std::isinf(outcome.arm->joints[3].min_rad));
  for (const Link& link : outcome.arm->links) EXPECT_EQ(link.beta_rad, 0.0);
}

TEST(UrdfFile, AMakersPandaHasThePosesOfItsDhTable) {
  const Outcome outcome = read_robot(testing::kPandaUrdf, "panda_link0:panda_link8");
  ASSERT_TRUE(outcome.arm) << outcome.messages;
  expect_same_poses(*outcome.arm, example_arm("panda"));
}

TEST(UrdfFile, TheChainMayBeAPartOfTheRobot) {
  const Outcome outcome = read_robot(testing::kUr10Urdf, "shoulder_link:wrist_2_link");
  ASSERT_TRUE(outcome.arm) << outcome.messages;
  EXPECT_EQ(outcome.arm->joint_count(), 4);
  EXPECT_EQ(outcome.arm->note,
            "URDF chain shoulder_link:wrist_2_link; joints shoulder_lift_joint, elbow_joint, "
            "wrist_1_joint, wrist_2_joint");
}

TEST(UrdfFile, AxesNeedNoUnitLengthAndAreXByDefault) {
  const Outcome slanted = read_robot(two_joints("<axis xyz='0 3 -4'/>", "<axis xyz='-1e-3 0 0'/>"));
  const Outcome unit = read_robot(two_joints("<axis xyz='0 0.6 -0.8'/>", "<axis xyz='-1 0 0'/>"));
  expect_same_poses(slanted.arm.value(), unit.arm.value());
  expect_same_poses(
      read_robot(two_joints("", "<axis xyz='0 0 1'/>")).arm.value(),
      read_robot(two_joints("<axis xyz='1 0 0'/>", "<axis xyz='0 0 1'/>")).arm.value());
}

TEST(UrdfFile, MillimetresHaveTheDigitsOfTheMetres) {
  const auto arm = read_robot(two_joints("<axis xyz='0 0 1'/>",
                                         "<origin xyz='0.747489 0 -5.25e-5' rpy='1.2 0 0'/>"
                                         "<axis xyz='0 0 1'/>"))
                       .arm.value();
  EXPECT_EQ(arm.links[0].a_mm, 747.489);
  EXPECT_EQ(arm.links[0].d_mm, -0.0525);
}

TEST(UrdfFile, SeveralEndsAreListed) {
  std::string forked = testing::kUr10Urdf;
  forked.insert(forked.rfind("</robot>"),
                "<link name='camera'/><joint name='mount' type='fixed'>"
                "<parent link='wrist_3_link'/><child link='camera'/></joint>");
  EXPECT_EQ(read_robot(forked).messages,
            "r.urdf:2:1: error: has 2 ends: camera, tool0\n"
            "  help: tell which is the tip: --chain base:camera\n");
  EXPECT_TRUE(read_robot(forked, "base:tool0").arm);
}

TEST(UrdfFile, AChainMustExist) {
  EXPECT_EQ(read_robot(testing::kUr10Urdf, "base").messages,
            "r.urdf: error: --chain base is not BASE:TIP\n  help: give the names of two links\n");
  EXPECT_EQ(read_robot(testing::kUr10Urdf, "base:tool1").messages,
            "r.urdf: error: --chain base:tool1: there is no link \"tool1\"\n"
            "  help: did you mean \"tool0\"?\n");
  EXPECT_EQ(read_robot(testing::kUr10Urdf, "tool0:base").messages,
            "r.urdf: error: no chain of joints leads from \"tool0\" out to \"base\"\n"
            "  help: the way back from \"base\" ends at \"base\"\n");
}

TEST(UrdfFile, OnlyTurningJointsMakeAnArm) {
  EXPECT_EQ(read_robot(testing::kPandaUrdf).messages,
            "r.urdf:45:43: error: joint \"panda_finger_joint1\" is prismatic\n"
            "  help: the joints of an arm here are revolute, continuous or fixed; choose a chain "
            "without it: --chain BASE:TIP\n");
  for (const char* type : {"floating", "planar", "ball"}) {
    EXPECT_THAT(read_robot(two_joints("", "", type)).messages,
                HasSubstr(fmt::format("r.urdf:3:25: error: joint \"one\" is {}", type)));
  }
  EXPECT_THAT(read_robot(two_joints("", "<mimic joint='one'/>")).messages,
              HasSubstr("r.urdf:4:72: error: joint \"two\" mimics joint \"one\""));
  EXPECT_THAT(read_robot(two_joints("", "", "fixed")).messages,
              HasSubstr("the chain has 1 turning joint: an arm here has 2 to 10"));
}

TEST(UrdfFile, AllBadNumbersAreToldAtOnce) {
  const Outcome outcome = read_robot(
      two_joints("<origin xyz='0 0 1,5'/><axis xyz='0 0 0'/><limit lower='2' upper='nan'/>",
                 "<origin xyz='747 0 0' rpy='90 0 0'/><axis xyz='1 0'/>", "revolute"));
  EXPECT_THAT(outcome.messages, HasSubstr("r.urdf:3:83: error: xyz=\"0 0 1,5\" is not three"));
  EXPECT_THAT(outcome.messages, HasSubstr("error: axis \"0 0 0\" has no direction"));
  EXPECT_THAT(outcome.messages, HasSubstr("error: upper=\"nan\" is not a number"));
  EXPECT_THAT(outcome.messages, HasSubstr("error: an offset of 747 m is no arm's"));
  EXPECT_THAT(outcome.messages, HasSubstr("are these millimetres?"));
  EXPECT_THAT(outcome.messages, HasSubstr("error: xyz=\"1 0\" is not three numbers"));
  EXPECT_THAT(read_robot(two_joints("<origin rpy='90 0 0'/>")).messages,
              HasSubstr("an angle of 90 rad is more than two turns"));
}

TEST(UrdfFile, LimitsAreInOrderOrMissing) {
  EXPECT_THAT(read_robot(two_joints("<limit upper='-1'/>", "", "revolute")).messages,
              HasSubstr("joint \"one\": lower limit 0 is not below upper limit -1"));
  const Outcome missing = read_robot(two_joints("", "", "revolute"));
  EXPECT_TRUE(missing.arm);
  EXPECT_THAT(missing.messages, HasSubstr("warning: joint \"one\" is revolute without <limit>"));
}

TEST(UrdfFile, LinksAndJointsMustHangTogether) {
  EXPECT_THAT(read_robot("<robot><link name='a'/><link name='a'/></robot>").messages,
              HasSubstr("second link \"a\""));
  EXPECT_THAT(read_robot("<robot><link/></robot>").messages,
              HasSubstr("<link> has no name=\"..\""));
  EXPECT_THAT(read_robot("<robot><link name='a'/></robot>").messages,
              HasSubstr("<robot> has no joint"));
  EXPECT_THAT(
      read_robot("<robot><link name='a'/><joint name='j'><parent link='a'/><child link='b'/>"
                 "</joint></robot>")
          .messages,
      HasSubstr("there is no link \"b\""));
  const std::string ring =
      "<robot><link name='a'/><link name='b'/>"
      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>"
      "<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint></robot>";
  EXPECT_THAT(read_robot(ring).messages, HasSubstr("its links make a ring"));
  EXPECT_THAT(read_robot(two_joints("", "<child link='b'/>")).messages, ::testing::IsEmpty());
  std::string twice = two_joints("");
  twice.replace(twice.find("<child link=\"c\"/>"), 17, "<child link=\"b\"/>");
  EXPECT_THAT(read_robot(twice).messages,
              HasSubstr("link \"b\" hangs on two joints, \"one\" and \"two\""));
}

TEST(UrdfFile, ALoopBehindTheTipEnds) {
  const std::string text =
      "<robot><link name='a'/><link name='b'/><link name='c'/>"
      "<joint name='j' type='fixed'><parent link='c'/><child link='b'/></joint>"
      "<joint name='k' type='fixed'><parent link='b'/><child link='c'/></joint></robot>";
  EXPECT_THAT(read_robot(text, "a:c").messages, HasSubstr("no chain of joints leads from \"a\""));
}

TEST(UrdfFile, XacroIsSentToXacro) {
  const Outcome macro = read_robot(
      "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\" name=\"x\">\n"
      "  <xacro:arg name=\"n\"/>\n</robot>");
  EXPECT_EQ(macro.messages,
            "r.urdf:2:3: error: <xacro:arg>: this is a xacro file, from which a URDF is made\n"
            "  help: run xacro first: xacro FILE > arm.urdf\n");
  EXPECT_THAT(read_robot(two_joints("<origin xyz='0 0 ${d}'/>")).messages,
              HasSubstr("run xacro first"));
  // What xacro leaves behind is no xacro.
  std::string made = two_joints("");
  made.replace(0, 7,
               "<!-- from <xacro:a/> --><robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\" ");
  EXPECT_TRUE(read_robot(made).arm);
}

TEST(UrdfFile, HostileFilesAreOnlyRefused) {
  const std::string bomb =
      "<!DOCTYPE r [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">]>"
      "<robot name=\"&b;&b;\"/>";
  EXPECT_THAT(read_robot(bomb).messages, HasSubstr("<robot> has no joint"));
  std::string deep = "<robot>";
  for (int i = 0; i < 500'000; ++i) deep += "<link>";
  EXPECT_THAT(read_robot(deep).messages, HasSubstr("is not XML"));
  std::string closed = deep;
  for (int i = 0; i < 500'000; ++i) closed += "</link>";
  EXPECT_THAT(read_robot(closed + "</robot>").messages, HasSubstr("<link> has no name"));
  std::string wide = "<robot>";
  for (int i = 0; i < 100'000; ++i) wide += "<joint name='j'/>";
  EXPECT_THAT(read_robot(wide + "</robot>").messages, HasSubstr("joint \"j\" has no <parent"));
}

TEST(UrdfFile, IsKnownByItsFirstCharacterOrItsName) {
  EXPECT_TRUE(looks_like_urdf({"-", "\n <?xml", "UTF-8", ""}));
  EXPECT_TRUE(looks_like_urdf({"a.urdf", "nonsense", "UTF-8", ""}));
  EXPECT_FALSE(looks_like_urdf({"a.arm.toml", "schema = ", "UTF-8", ""}));
}

TEST(UrdfFile, BrokenXmlHasAPlace) {
  EXPECT_EQ(read_robot("<robot name=\"x\">\n  <link name=\"a\">\n</robot>\n").messages,
            "r.urdf:3:3: error: is not XML: Start-end tags mismatch\n");
  EXPECT_THAT(read_robot("").messages, HasSubstr("error: is not XML"));
  EXPECT_THAT(read_robot("<sdf version='1.4'/>").messages,
              HasSubstr("r.urdf:1:1: error: <sdf> is no robot description"));
}

}  // namespace
}  // namespace armcal
