// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal::testing {

// URDFs as robot makers write them, by hand from their published dimensions: axes along y as well
// as z, fixed joints at both ends. The flange frames are those of the makers' D-H tables, so that
// the poses must be those of examples/arms, which come from the tables.

inline constexpr const char* kUr10Urdf = R"(<?xml version="1.0" encoding="utf-8"?>
<robot name="ur10">
  <link name="base"/>
  <link name="base_link"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="shoulder_link"/>
  <link name="upper_arm_link"/>
  <link name="forearm_link"/>
  <link name="wrist_1_link"/>
  <link name="wrist_2_link"/>
  <link name="wrist_3_link"/>
  <link name="tool0"/>
  <joint name="base_fixed_joint" type="fixed">
    <origin xyz="0 0 0" rpy="0 0 3.141592653589793"/>
    <parent link="base"/><child link="base_link"/>
  </joint>
  <joint name="shoulder_pan_joint" type="revolute">
    <parent link="base_link"/><child link="shoulder_link"/>
    <origin rpy="0.0 0.0 0.0" xyz="0.0 0.0 0.1273"/>
    <axis xyz="0 0 1"/>
    <limit effort="330.0" lower="-6.28318530718" upper="6.28318530718" velocity="2.16"/>
  </joint>
  <joint name="shoulder_lift_joint" type="revolute">
    <parent link="shoulder_link"/><child link="upper_arm_link"/>
    <origin rpy="0.0 1.5707963267948966 0.0" xyz="0.0 0.220941 0.0"/>
    <axis xyz="0 1 0"/>
    <limit effort="330.0" lower="-6.28318530718" upper="6.28318530718" velocity="2.16"/>
  </joint>
  <joint name="elbow_joint" type="revolute">
    <parent link="upper_arm_link"/><child link="forearm_link"/>
    <origin rpy="0.0 0.0 0.0" xyz="0.0 -0.1719 0.612"/>
    <axis xyz="0 1 0"/>
    <limit effort="150.0" lower="-3.14159265359" upper="3.14159265359" velocity="3.15"/>
  </joint>
  <joint name="wrist_1_joint" type="continuous">
    <parent link="forearm_link"/><child link="wrist_1_link"/>
    <origin rpy="0.0 1.5707963267948966 0.0" xyz="0.0 0.0 0.5723"/>
    <axis xyz="0 1 0"/>
  </joint>
  <joint name="wrist_2_joint" type="continuous">
    <parent link="wrist_1_link"/><child link="wrist_2_link"/>
    <origin rpy="0.0 0.0 0.0" xyz="0.0 0.1149 0.0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <joint name="wrist_3_joint" type="continuous">
    <parent link="wrist_2_link"/><child link="wrist_3_link"/>
    <origin rpy="0.0 0.0 0.0" xyz="0.0 0.0 0.1157"/>
    <axis xyz="0 1 0"/>
  </joint>
  <joint name="wrist_3_link-tool0_fixed_joint" type="fixed">
    <origin rpy="-1.5707963267948966 0 0" xyz="0 0.0922 0"/>
    <parent link="wrist_3_link"/><child link="tool0"/>
  </joint>
</robot>
)";

inline constexpr const char* kPandaUrdf = R"(<robot name="panda">
  <link name="panda_link0"/><link name="panda_link1"/><link name="panda_link2"/>
  <link name="panda_link3"/><link name="panda_link4"/><link name="panda_link5"/>
  <link name="panda_link6"/><link name="panda_link7"/><link name="panda_link8"/>
  <link name="panda_leftfinger"/>
  <joint name="panda_joint1" type="revolute">
    <origin rpy="0 0 0" xyz="0 0 0.333"/>
    <parent link="panda_link0"/><child link="panda_link1"/>
    <axis xyz="0 0 1"/><limit lower="-2.8973" upper="2.8973" effort="87" velocity="2.175"/>
  </joint>
  <joint name="panda_joint2" type="revolute">
    <origin rpy="-1.5707963267948966 0 0" xyz="0 0 0"/>
    <parent link="panda_link1"/><child link="panda_link2"/>
    <axis xyz="0 0 1"/><limit lower="-1.7628" upper="1.7628" effort="87" velocity="2.175"/>
  </joint>
  <joint name="panda_joint3" type="revolute">
    <origin rpy="1.5707963267948966 0 0" xyz="0 -0.316 0"/>
    <parent link="panda_link2"/><child link="panda_link3"/>
    <axis xyz="0 0 1"/><limit lower="-2.8973" upper="2.8973" effort="87" velocity="2.175"/>
  </joint>
  <joint name="panda_joint4" type="revolute">
    <origin rpy="1.5707963267948966 0 0" xyz="0.0825 0 0"/>
    <parent link="panda_link3"/><child link="panda_link4"/>
    <axis xyz="0 0 1"/><limit lower="-3.0718" upper="-0.0698" effort="87" velocity="2.175"/>
  </joint>
  <joint name="panda_joint5" type="revolute">
    <origin rpy="-1.5707963267948966 0 0" xyz="-0.0825 0.384 0"/>
    <parent link="panda_link4"/><child link="panda_link5"/>
    <axis xyz="0 0 1"/><limit lower="-2.8973" upper="2.8973" effort="12" velocity="2.61"/>
  </joint>
  <joint name="panda_joint6" type="revolute">
    <origin rpy="1.5707963267948966 0 0" xyz="0 0 0"/>
    <parent link="panda_link5"/><child link="panda_link6"/>
    <axis xyz="0 0 1"/><limit lower="-0.0175" upper="3.7525" effort="12" velocity="2.61"/>
  </joint>
  <joint name="panda_joint7" type="revolute">
    <origin rpy="1.5707963267948966 0 0" xyz="0.088 0 0"/>
    <parent link="panda_link6"/><child link="panda_link7"/>
    <axis xyz="0 0 1"/><limit lower="-2.8973" upper="2.8973" effort="12" velocity="2.61"/>
  </joint>
  <joint name="panda_joint8" type="fixed">
    <origin rpy="0 0 0" xyz="0 0 0.107"/>
    <parent link="panda_link7"/><child link="panda_link8"/>
  </joint>
  <joint name="panda_finger_joint1" type="prismatic">
    <origin xyz="0 0 0.0584"/>
    <parent link="panda_link8"/><child link="panda_leftfinger"/>
    <axis xyz="0 1 0"/><limit lower="0.0" upper="0.04" effort="20" velocity="0.2"/>
  </joint>
</robot>
)";

}  // namespace armcal::testing
