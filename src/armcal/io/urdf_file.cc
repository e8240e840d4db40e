// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/urdf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "armcal/core/spelling.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
// Beyond these a number has another unit than URDF's metres and radians.
constexpr double kLargestOffset_m = 100.0;
constexpr double kLargestUrdfAngle_rad = 4.0 * std::numbers::pi;
constexpr std::size_t kNamesShown = 12;

template <typename Names>
std::string listed(const Names& names) {
  std::string text;
  std::size_t count = 0;
  for (const auto& name : names) {
    if (count++ == kNamesShown)
      return text + fmt::format(" and {} more", names.size() - kNamesShown);
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  }
  return text;
}

/// "0 0.612 0" as three numbers.
std::optional<Eigen::Vector3d> triple_of(std::string_view text) {
  Eigen::Vector3d result;
  for (Eigen::Index i = 0; i < 3; ++i) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    const auto word = text.substr(0, text.find_first_of(kBlanks));
    const auto number = parse_number(word);
    if (!number) return std::nullopt;
    result(i) = *number;
    text.remove_prefix(word.size());
  }
  if (text.find_first_not_of(kBlanks) != text.npos) return std::nullopt;
  return result;
}

/// The parsed file. Attributes know their place because they are parsed where they lie.
class XmlFile {
 public:
  explicit XmlFile(const TextFile& file) : path_(file.path), buffer_(file.text) {
    line_starts_.push_back(0);
    for (std::size_t at = 0; at < file.text.size(); ++at) {
      if (file.text[at] == '\n') line_starts_.push_back(at + 1);
    }
    // The text is UTF-8 by now, whatever its declaration says.
    result_ = document_.load_buffer_inplace(buffer_.data(), buffer_.size(), pugi::parse_default,
                                            pugi::encoding_utf8);
  }
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  [[nodiscard]] const pugi::xml_parse_result& result() const { return result_; }
  [[nodiscard]] const pugi::xml_document& document() const { return document_; }
  [[nodiscard]] SourcePosition whole() const { return {path_, 0, 0}; }

  [[nodiscard]] SourcePosition where(std::ptrdiff_t offset) const {
    if (offset < 0) return whole();
    const auto at = std::min(static_cast<std::size_t>(offset), buffer_.size());
    const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(), at) - 1;
    return {path_, static_cast<int>(line - line_starts_.begin()) + 1,
            static_cast<int>(at - *line) + 1};
  }
  [[nodiscard]] SourcePosition where(pugi::xml_node node) const {
    return where(std::max<std::ptrdiff_t>(node.offset_debug() - 1, -1));  // at its <
  }
  /// Of the value of an attribute; of the element that should have it where it is missing.
  [[nodiscard]] SourcePosition where(pugi::xml_node node, const char* attribute) const {
    const pugi::xml_attribute found = node.attribute(attribute);
    const char* const begin = buffer_.data();
    const char* const value = found.value();
    const bool inside =
        found && !std::less<>()(value, begin) && std::less<>()(value, begin + buffer_.size());
    return inside ? where(value - begin) : where(node);
  }

 private:
  std::string path_;
  std::string buffer_;  // pugixml writes into it: ends of words
  std::vector<std::size_t> line_starts_;
  pugi::xml_document document_;
  pugi::xml_parse_result result_;
};

class UrdfReader {
 public:
  UrdfReader(const XmlFile& xml, Diagnostics& diagnostics)
      : xml_(xml), robot_(xml.document().document_element()), diagnostics_(diagnostics) {}

  std::optional<JointChain> read(const std::optional<std::string>& chain) {
    const std::size_t errors_before = diagnostics_.error_count();
    if (!is_plain_urdf()) return std::nullopt;
    read_structure();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    const auto ends = chain ? told_ends(*chain) : only_ends();
    if (!ends) return std::nullopt;
    const auto joints = joints_between(ends->first, ends->second);
    if (!joints) return std::nullopt;
    JointChain result = chain_of(*joints);
    result.note = fmt::format("URDF chain {}:{}; joints{}", ends->first, ends->second, turning_);
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return result;
  }

 private:
  using Ends = std::pair<std::string, std::string>;

  bool is_plain_urdf() {
    if (xml_.result().status != pugi::status_ok) {
      diagnostics_.error(xml_.where(xml_.result().offset),
                         fmt::format("is not XML: {}", xml_.result().description()));
      return false;
    }
    const pugi::xml_node macro = robot_.find_node(
        [](pugi::xml_node node) { return std::string_view(node.name()).starts_with("xacro:"); });
    if (macro) {
      diagnostics_.error(
          xml_.where(macro),
          fmt::format("<{}>: this is a xacro file, from which a URDF is made", macro.name()),
          "run xacro first: xacro FILE > arm.urdf");
      return false;
    }
    if (std::string_view(robot_.name()) != "robot") {
      diagnostics_.error(
          xml_.where(robot_),
          fmt::format("<{}> is no robot description: a URDF starts with <robot>", robot_.name()));
      return false;
    }
    return true;
  }

  std::string named(pugi::xml_node node, const char* attribute) {
    std::string name = node.attribute(attribute).value();
    if (name.empty()) {
      diagnostics_.error(xml_.where(node),
                         fmt::format("<{}> has no {}=\"..\"", node.name(), attribute));
    }
    return name;
  }

  std::string linked(pugi::xml_node joint, const char* end) {
    const pugi::xml_node node = joint.child(end);
    const std::string link = node.attribute("link").value();
    if (link.empty()) {
      diagnostics_.error(xml_.where(joint), fmt::format("joint \"{}\" has no <{} link=\"..\">",
                                                        joint.attribute("name").value(), end));
    } else if (!links_.contains(link)) {
      diagnostics_.error(xml_.where(node, "link"), fmt::format("there is no link \"{}\"", link));
    }
    return link;
  }

  void read_structure() {
    for (const pugi::xml_node link : robot_.children("link")) {
      const std::string name = named(link, "name");
      if (!name.empty() && !links_.insert(name).second) {
        diagnostics_.error(xml_.where(link, "name"), fmt::format("second link \"{}\"", name));
      }
    }
    std::set<std::string, std::less<>> names;
    for (const pugi::xml_node joint : robot_.children("joint")) {
      const std::string name = named(joint, "name");
      if (!name.empty() && !names.insert(name).second) {
        diagnostics_.error(xml_.where(joint, "name"), fmt::format("second joint \"{}\"", name));
      }
      const std::string parent = linked(joint, "parent");
      const std::string child = linked(joint, "child");
      if (!child.empty() && !joint_into_.try_emplace(child, joint).second) {
        diagnostics_.error(xml_.where(joint.child("child"), "link"),
                           fmt::format("link \"{}\" hangs on two joints, \"{}\" and \"{}\"", child,
                                       joint_into_.at(child).attribute("name").value(), name));
      }
      parents_.insert(parent);
    }
    if (names.empty()) diagnostics_.error(xml_.where(robot_), "<robot> has no joint");
  }

  std::optional<Ends> only_ends() {
    std::vector<std::string> roots;
    std::vector<std::string> leaves;
    for (const std::string& link : links_) {
      if (!joint_into_.contains(link)) roots.push_back(link);
      if (!parents_.contains(link)) leaves.push_back(link);
    }
    if (roots.size() == 1 && leaves.size() == 1) return Ends(roots[0], leaves[0]);
    if (roots.empty() || leaves.empty()) {
      diagnostics_.error(xml_.where(robot_), "its links make a ring: there is no root or no end");
    } else if (roots.size() > 1) {
      diagnostics_.error(
          xml_.where(robot_),
          fmt::format("has {} links that hang on nothing: {}", roots.size(), listed(roots)),
          "tell which joints make the arm: --chain BASE:TIP");
    } else {
      diagnostics_.error(xml_.where(robot_),
                         fmt::format("has {} ends: {}", leaves.size(), listed(leaves)),
                         fmt::format("tell which is the tip: --chain {}:{}", roots[0], leaves[0]));
    }
    return std::nullopt;
  }

  std::optional<Ends> told_ends(const std::string& chain) {
    const std::size_t colon = chain.find(':');
    if (colon == chain.npos) {
      diagnostics_.error(xml_.whole(), fmt::format("--chain {} is not BASE:TIP", chain),
                         "give the names of two links");
      return std::nullopt;
    }
    Ends ends(chain.substr(0, colon), chain.substr(colon + 1));
    bool known = true;
    for (const std::string& end : {ends.first, ends.second}) {
      if (links_.contains(end)) continue;
      known = false;
      const std::vector<std::string> names(links_.begin(), links_.end());
      diagnostics_.error(
          xml_.whole(), fmt::format("--chain {}: there is no link \"{}\"", chain, end),
          names.size() <= kNamesShown ? did_you_mean(end, names) : "links: " + listed(names));
    }
    return known ? std::optional(std::move(ends)) : std::nullopt;
  }

  std::optional<std::vector<pugi::xml_node>> joints_between(const std::string& base,
                                                            const std::string& tip) {
    std::vector<pugi::xml_node> joints;
    std::string link = tip;
    while (link != base) {
      const auto joint = joint_into_.find(link);
      if (joint == joint_into_.end() || joints.size() > joint_into_.size()) {
        diagnostics_.error(
            xml_.whole(),
            fmt::format("no chain of joints leads from \"{}\" out to \"{}\"", base, tip),
            fmt::format("the way back from \"{}\" ends at \"{}\"", tip, link));
        return std::nullopt;
      }
      joints.push_back(joint->second);
      link = joint->second.child("parent").attribute("link").value();
    }
    std::reverse(joints.begin(), joints.end());
    return joints;
  }

  void number_error(pugi::xml_node node, const char* attribute, std::string_view meant) {
    const std::string_view text = node.attribute(attribute).value();
    diagnostics_.error(
        xml_.where(node, attribute), fmt::format("{}=\"{}\" is not {}", attribute, text, meant),
        text.find("${") != text.npos ? "run xacro first: xacro FILE > arm.urdf" : "");
  }

  Eigen::Vector3d triple(pugi::xml_node node, const char* attribute,
                         const Eigen::Vector3d& otherwise) {
    if (!node.attribute(attribute)) return otherwise;
    const auto numbers = triple_of(node.attribute(attribute).value());
    if (!numbers) number_error(node, attribute, "three numbers");
    return numbers.value_or(otherwise);
  }

  RigidTransform origin(pugi::xml_node joint) {
    const pugi::xml_node node = joint.child("origin");
    const Eigen::Vector3d xyz_m = triple(node, "xyz", Eigen::Vector3d::Zero());
    const Eigen::Vector3d rpy_rad = triple(node, "rpy", Eigen::Vector3d::Zero());
    if (const double largest = xyz_m.cwiseAbs().maxCoeff(); largest > kLargestOffset_m) {
      diagnostics_.error(xml_.where(node, "xyz"),
                         fmt::format("an offset of {} m is no arm's", largest),
                         "lengths of a URDF are metres; are these millimetres?");
      return {};
    }
    if (const double largest = rpy_rad.cwiseAbs().maxCoeff(); largest > kLargestUrdfAngle_rad) {
      diagnostics_.error(xml_.where(node, "rpy"),
                         fmt::format("an angle of {} rad is more than two turns", largest),
                         "angles of a URDF are radians; are these degrees?");
      return {};
    }
    return {rotation_from_roll_pitch_yaw(rpy_rad),
            xyz_m.unaryExpr([](double m) { return with_point_moved(m, 3); })};
  }

  Eigen::Vector3d axis(pugi::xml_node joint) {
    const pugi::xml_node node = joint.child("axis");
    const Eigen::Vector3d given = triple(node, "xyz", Eigen::Vector3d::UnitX());
    const double length = given.stableNorm();
    if (length > 1e-6 && length < 1e6) return given / length;
    diagnostics_.error(xml_.where(node, "xyz"),
                       fmt::format("axis \"{}\" has no direction", node.attribute("xyz").value()));
    return Eigen::Vector3d::UnitX();
  }

  double limit(pugi::xml_node node, const char* attribute) {
    if (!node.attribute(attribute)) return 0.0;  // as the definition of URDF has it
    const auto number = parse_number(node.attribute(attribute).value());
    if (!number) number_error(node, attribute, "a number");
    return number.value_or(0.0);
  }

  void read_limits(pugi::xml_node joint, ChainJoint& out) {
    const std::string_view name = joint.attribute("name").value();
    const pugi::xml_node node = joint.child("limit");
    if (!node) {
      diagnostics_.warning(
          xml_.where(joint),
          fmt::format("joint \"{}\" is revolute without <limit>: taken as without stops", name));
      return;
    }
    const std::size_t errors_before = diagnostics_.error_count();
    out.min_rad = limit(node, "lower");
    out.max_rad = limit(node, "upper");
    if (diagnostics_.error_count() == errors_before && !(out.min_rad < out.max_rad)) {
      diagnostics_.error(xml_.where(node),
                         fmt::format("joint \"{}\": lower limit {} is not below upper limit {}",
                                     name, out.min_rad, out.max_rad),
                         "a joint without stops has type=\"continuous\"");
    }
  }

  // Problems of a joint that must turn or be fixed; its type.
  std::string_view type_of(pugi::xml_node joint) {
    const std::string_view type = joint.attribute("type").value();
    const std::string_view name = joint.attribute("name").value();
    constexpr std::array<std::string_view, 3> kTaken = {"revolute", "continuous", "fixed"};
    if (std::find(kTaken.begin(), kTaken.end(), type) == kTaken.end()) {
      diagnostics_.error(xml_.where(joint, "type"),
                         type.empty() ? fmt::format("joint \"{}\" has no type=\"..\"", name)
                                      : fmt::format("joint \"{}\" is {}", name, type),
                         "the joints of an arm here are revolute, continuous or fixed; choose a "
                         "chain without it: --chain BASE:TIP");
    } else if (type != "fixed" && joint.child("mimic")) {
      diagnostics_.error(xml_.where(joint.child("mimic")),
                         fmt::format("joint \"{}\" mimics joint \"{}\": each joint of an arm here "
                                     "has a reading of its own",
                                     name, joint.child("mimic").attribute("joint").value()));
    }
    return type;
  }

  JointChain chain_of(const std::vector<pugi::xml_node>& joints) {
    JointChain chain;
    chain.name = robot_.attribute("name").value();
    RigidTransform before;
    int count = 0;
    for (const pugi::xml_node joint : joints) {
      const std::string_view type = type_of(joint);
      before = before * origin(joint);
      if (type != "revolute" && type != "continuous") continue;
      turning_ += fmt::format("{} {}", count++ == 0 ? "" : ",", joint.attribute("name").value());
      ChainJoint& out = chain.joints.emplace_back();
      out.parent_from_joint = before;
      out.axis_in_joint = axis(joint);
      if (type == "revolute") read_limits(joint, out);
      before = {};
    }
    chain.last_from_tip = before;
    if (count < kMinJoints || count > kMaxJoints) {
      diagnostics_.error(xml_.where(robot_),
                         fmt::format("the chain has {} turning joint{}: an arm here has {} to {}",
                                     count, count == 1 ? "" : "s", kMinJoints, kMaxJoints));
    }
    return chain;
  }

  const XmlFile& xml_;
  pugi::xml_node robot_;
  Diagnostics& diagnostics_;
  std::set<std::string, std::less<>> links_;
  std::set<std::string, std::less<>> parents_;
  std::map<std::string, pugi::xml_node, std::less<>> joint_into_;  // by the link that it carries
  std::string turning_;
};

}  // namespace

bool looks_like_urdf(const TextFile& file) {
  const std::size_t first = file.text.find_first_not_of(kBlanks);
  return (first != file.text.npos && file.text[first] == '<') || file.path.ends_with(".urdf") ||
         file.path.ends_with(".xacro");
}

std::optional<JointChain> read_urdf_chain(const TextFile& file,
                                          const std::optional<std::string>& chain,
                                          Diagnostics& diagnostics) {
  const XmlFile xml(file);
  return UrdfReader(xml, diagnostics).read(chain);
}

std::optional<ArmModel> read_urdf(const TextFile& file, const std::optional<std::string>& chain,
                                  Diagnostics& diagnostics) {
  const auto joints = read_urdf_chain(file, chain, diagnostics);
  return joints ? std::optional(arm_from_chain(*joints)) : std::nullopt;
}

}  // namespace armcal
