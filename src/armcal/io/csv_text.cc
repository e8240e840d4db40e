// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/csv_text.h"

#include <fmt/format.h>

#include <stdexcept>

#include "armcal/core/units.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

constexpr int kLengthPlaces = 8;
constexpr int kAnglePlaces = 10;

}  // namespace

std::string length_field(double mm) { return decimal_text(mm, kLengthPlaces); }

std::string angle_field(double rad) {
  return decimal_text(degrees_from_radians(rad), kAnglePlaces);
}

std::string text_field(std::string_view text) {
  if (text.find_first_of("\";\t\r\n") != text.npos) {
    throw std::invalid_argument(
        fmt::format("the name {} cannot stand in a table: it holds a "
                    "quotation mark, semicolon, tab or line break",
                    text));
  }
  const bool is_plain = !text.empty() && text.front() != ' ' && text.back() != ' ' &&
                        text.front() != '#' && text.find(',') == text.npos;
  return is_plain ? std::string(text) : fmt::format("\"{}\"", text);
}

std::string angle_header(Eigen::Index joint_count) {
  std::string header;
  for (Eigen::Index joint = 1; joint <= joint_count; ++joint) {
    header += fmt::format("{}q{}_deg", joint == 1 ? "" : ",", joint);
  }
  return header;
}

std::string angle_fields(const Eigen::VectorXd& angles_rad) {
  std::string fields;
  for (Eigen::Index i = 0; i < angles_rad.size(); ++i) {
    if (i > 0) fields += ',';
    fields += angle_field(angles_rad(i));
  }
  return fields;
}

std::string point_fields(const Eigen::Vector3d& point_mm) {
  return fmt::format("{},{},{}", length_field(point_mm.x()), length_field(point_mm.y()),
                     length_field(point_mm.z()));
}

}  // namespace armcal
