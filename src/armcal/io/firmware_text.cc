// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/firmware_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/version.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

std::string include_guard(std::string_view name) {
  std::string guard = "ARMCAL";
  bool gap = true;
  for (const char c : name) {
    const bool is_lower = c >= 'a' && c <= 'z';
    if (!is_lower && !(c >= 'A' && c <= 'Z') && !(c >= '0' && c <= '9')) {
      gap = true;
      continue;
    }
    if (gap) guard += '_';
    gap = false;
    guard += is_lower ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return guard + (guard == "ARMCAL" ? "_ARM_H" : "_H");
}

/// Text within a comment: nothing that ends it, continues a line, starts a trigraph, or turns the
/// direction of reading (U+2000 to U+206F), any of which compilers warn of.
std::string c_comment(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == '\x7f';
    const bool is_punctuation =
        c == '\xE2' && i + 2 < text.size() && (text[i + 1] == '\x80' || text[i + 1] == '\x81');
    if (is_punctuation) i += 2;
    const bool is_unsafe = c == '*' || c == '\\' || c == '?' || is_punctuation;
    result += is_control ? ' ' : (is_unsafe ? '_' : c);
  }
  return result;
}

template <typename Items, typename Number>
std::string array(std::string_view declaration, const Items& items, const Number& number) {
  std::string text;
  for (const auto& item : items) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", number(item));
  }
  return fmt::format("static const double {} = {{{}}};\n", declaration, text);
}

std::string row(const Eigen::Vector3d& v) {
  return fmt::format("{}, {}, {}", shortest_text(v.x()), shortest_text(v.y()),
                     shortest_text(v.z()));
}

std::size_t harmonics_of(const ArmModel& arm) {
  std::size_t most = 0;
  for (const Joint& joint : arm.joints) most = std::max(most, joint.harmonics.size());
  return most;
}

std::string harmonic_constants(const ArmModel& arm, std::size_t most) {
  std::string text = fmt::format(
      "/* Harmonics of the encoders, rad: amplitudes of cos(k e), sin(k e) for k = 1, 2, .. */\n"
      "#define ARMCAL_HARMONICS {}\n"
      "static const double armcal_harmonics_rad[ARMCAL_JOINTS][ARMCAL_HARMONICS][2] = {{\n",
      most);
  for (const Joint& joint : arm.joints) {
    text += "    {";
    for (std::size_t k = 0; k < most; ++k) {
      const Harmonic harmonic = k < joint.harmonics.size() ? joint.harmonics[k] : Harmonic{};
      text += fmt::format("{}{{{}, {}}}", k == 0 ? "" : ", ", shortest_text(harmonic.cos_rad),
                          shortest_text(harmonic.sin_rad));
    }
    text += "},\n";
  }
  return text + "};\n";
}

std::string constants(const ArmModel& arm) {
  std::string text = fmt::format("#define ARMCAL_JOINTS {}\n\n", arm.joint_count());
  text += "/* Angle of a joint = direction * (encoder + zero) + harmonics. */\n";
  text += array("armcal_zero_rad[ARMCAL_JOINTS]", arm.joints,
                [](const Joint& joint) { return shortest_text(joint.zero_rad); });
  text += array("armcal_direction[ARMCAL_JOINTS]", arm.joints,
                [](const Joint& joint) { return shortest_text(joint.direction); });
  if (const std::size_t most = harmonics_of(arm); most > 0) text += harmonic_constants(arm, most);
  text +=
      "\n/* Links: RotZ(angle) Trans(a, b, d) RotX(alpha) RotY(beta), from each joint to the next. "
      "*/\n";
  const auto link_array = [&](const char* name, double Link::*member) {
    text += array(fmt::format("armcal_{}[ARMCAL_JOINTS - 1]", name), arm.links,
                  [member](const Link& link) { return shortest_text(link.*member); });
  };
  link_array("a_mm", &Link::a_mm);
  link_array("b_mm", &Link::b_mm);
  link_array("d_mm", &Link::d_mm);
  link_array("alpha_rad", &Link::alpha_rad);
  link_array("beta_rad", &Link::beta_rad);
  const RigidTransform& base = arm.base_from_first_joint;
  text += fmt::format(
      "\n/* Tip in the frame of the last joint; place of the first joint in the base frame. */\n"
      "static const double armcal_tip_abd_mm[3] = {{{}}};\n"
      "static const double armcal_base_mm[3] = {{{}}};\n"
      "static const double armcal_base_rotation[3][3] = {{{{{}}}, {{{}}}, {{{}}}}};\n",
      row({arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm}), row(base.translation_mm),
      row(base.rotation.row(0)), row(base.rotation.row(1)), row(base.rotation.row(2)));
  return text;
}

// From the tip inwards: only a point is carried from frame to frame, no matrices.
constexpr std::string_view kTipFunction = R"(
/* Tip in the base frame, mm, from the readings of the encoders, rad. */
static inline void armcal_tip(const double encoder_rad[ARMCAL_JOINTS], double tip_mm[3]) {
  double x = armcal_tip_abd_mm[0];
  double y = armcal_tip_abd_mm[1];
  double z = armcal_tip_abd_mm[2];
  int i;
  for (i = ARMCAL_JOINTS - 1; i >= 0; --i) {
    double angle = armcal_direction[i] * (encoder_rad[i] + armcal_zero_rad[i]);
@HARMONICS@    {
      const double c = cos(angle), s = sin(angle), turned_x = c * x - s * y;
      y = s * x + c * y;
      x = turned_x;
    }
    if (i > 0) {
      const double ca = cos(armcal_alpha_rad[i - 1]), sa = sin(armcal_alpha_rad[i - 1]);
      const double cb = cos(armcal_beta_rad[i - 1]), sb = sin(armcal_beta_rad[i - 1]);
      const double after_beta_x = cb * x + sb * z, after_beta_z = cb * z - sb * x;
      x = after_beta_x + armcal_a_mm[i - 1];
      z = sa * y + ca * after_beta_z + armcal_d_mm[i - 1];
      y = ca * y - sa * after_beta_z + armcal_b_mm[i - 1];
    }
  }
  for (i = 0; i < 3; ++i) {
    tip_mm[i] = armcal_base_rotation[i][0] * x + armcal_base_rotation[i][1] * y +
                armcal_base_rotation[i][2] * z + armcal_base_mm[i];
  }
}
)";

constexpr std::string_view kHarmonicSum = R"(    {
      int k;
      for (k = 1; k <= ARMCAL_HARMONICS; ++k) {
        angle += armcal_harmonics_rad[i][k - 1][0] * cos(k * encoder_rad[i]) +
                 armcal_harmonics_rad[i][k - 1][1] * sin(k * encoder_rad[i]);
      }
    }
)";

std::string tip_function(bool has_harmonics) {
  constexpr std::string_view kMark = "@HARMONICS@";
  std::string text(kTipFunction);
  text.replace(text.find(kMark), kMark.size(), has_harmonics ? kHarmonicSum : "");
  return text;
}

void note_limits_and_flange(const ArmModel& arm, std::vector<std::string>& lost) {
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    if (std::isfinite(joint.min_rad) || std::isfinite(joint.max_rad)) {
      lost.push_back(fmt::format("limits of joint {}", i + 1));
    }
  }
  if (!arm.tip.roll_pitch_yaw_rad.isZero(0.0)) lost.emplace_back("orientation of the tip");
}

}  // namespace

FirmwareText c_header_text(const ArmModel& arm) {
  FirmwareText result;
  note_limits_and_flange(arm, result.lost);
  const std::string guard = include_guard(arm.name);
  result.text = fmt::format(
      "/* Measuring arm \"{}\", written by armcal {}. Lengths in mm, angles in rad.\n"
      " * C99; link with the mathematics library (-lm). */\n"
      "#ifndef {}\n#define {}\n\n#include <math.h>\n\n{}{}\n#endif\n",
      c_comment(arm.name), kVersion, guard, guard, constants(arm),
      tip_function(harmonics_of(arm) > 0));
  return result;
}

FirmwareText csv_line_text(const ArmModel& arm) {
  FirmwareText result;
  note_limits_and_flange(arm, result.lost);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (arm.joints[i].direction != 1) {
      result.lost.push_back(fmt::format("counting direction -1 of joint {}", i + 1));
    }
  }
  const RigidTransform& base = arm.base_from_first_joint;
  if (!base.rotation.isIdentity(0.0) || !base.translation_mm.isZero(0.0)) {
    result.lost.emplace_back("place of the base");
  }
  const ParameterTable table(arm);
  std::string values;
  for (const Parameter& parameter : table.parameters()) {
    const char* separator = values.empty() ? "" : ",";
    result.text += fmt::format("{}{}_{}", separator, parameter.name, to_string(parameter.unit));
    values += fmt::format("{}{}", separator, shortest_text(parameter.nominal));
  }
  result.text += '\n' + values + '\n';
  return result;
}

}  // namespace armcal
