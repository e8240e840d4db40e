// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace armcal::testing {

struct SvgPlace {
  double x = 0.0, y = 0.0;
};

/// An SVG drawing as read back by another program.
class SvgReader {
 public:
  explicit SvgReader(const std::string& svg) {
    const pugi::xml_parse_result parsed = document_.load_string(svg.c_str());
    EXPECT_TRUE(parsed) << parsed.description() << " at " << parsed.offset;
    std::string box = document_.child("svg").attribute("viewBox").value();
    std::sscanf(box.c_str(), "0 0 %lf %lf", &width_, &height_);
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] pugi::xml_node root() const { return document_.child("svg"); }

  /// Everything that is written in it, titles for hovering left out.
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> texts;
    for (const auto& each : root().select_nodes(".//text")) {
      texts.emplace_back(each.node().text().get());
    }
    return texts;
  }
  [[nodiscard]] bool says(const std::string& text) const {
    for (const std::string& each : texts()) {
      if (each == text) return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t count(const char* xpath) const {
    return root().select_nodes(xpath).size();
  }

  /// Starts of the pieces of the paths that an XPath finds: of marks, where they are.
  [[nodiscard]] std::vector<SvgPlace> starts(const char* xpath) const {
    std::vector<SvgPlace> places;
    for (const auto& each : root().select_nodes(xpath)) {
      const char* d = each.node().attribute("d").value();
      while ((d = std::strchr(d, 'M')) != nullptr) {
        char* after = nullptr;
        const double x = std::strtod(d + 1, &after);
        const double y = std::strtod(after, &after);
        places.push_back({x, y});
        d = after;
      }
    }
    return places;
  }

  /// Nothing begins, and no text stands, outside of the drawing; no id twice; no number is missing.
  void expect_sound() const {
    for (const SvgPlace& at : starts(".//path[not(ancestor::defs)]")) expect_inside(at.x, at.y);
    for (const auto& each : root().select_nodes("./text")) {
      expect_inside(each.node().attribute("x").as_double(), each.node().attribute("y").as_double());
    }
    std::vector<std::string> ids;
    for (const auto& each : root().select_nodes(".//@id")) {
      for (const std::string& other : ids) EXPECT_NE(other, each.attribute().value());
      ids.emplace_back(each.attribute().value());
    }
    for (const auto& each : root().select_nodes(".//@d | .//@x | .//@y")) {
      const std::string value = each.attribute().value();
      EXPECT_EQ(value.find("nan"), std::string::npos) << value;
      EXPECT_EQ(value.find("inf"), std::string::npos) << value;
    }
    EXPECT_STREQ(root().attribute("role").value(), "img");
    EXPECT_TRUE(root().child("title"));
  }

 private:
  void expect_inside(double x, double y) const {
    EXPECT_GE(x, 0.0);
    EXPECT_LE(x, width_);
    EXPECT_GE(y, 0.0);
    EXPECT_LE(y, height_);
  }

  pugi::xml_document document_;
  double width_ = 0.0, height_ = 0.0;
};

inline constexpr const char* kHostileName =
    "<script>alert('\"&')</script> \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \x01";

}  // namespace armcal::testing
