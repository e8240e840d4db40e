// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace armcal {

/// A label of a drawing, and the lower left corner of its text; y grows downwards.
struct PlacedLabel {
  std::string text;
  double x = 0.0;
  double y = 0.0;
};

/// Finds places for labels beside their points, so that they cover neither each other nor leave the
/// drawing where that can be had: of eight places about the point, a little nearer before a little
/// farther, the first that is free; else the first.
class LabelPlaces {
 public:
  LabelPlaces(double width, double height) : width_(width), height_(height) {}

  /// Keeps labels off a box about a point.
  void reserve(double x, double y, double half_size);
  /// Keeps labels off a straight line.
  void reserve_line(double x1, double y1, double x2, double y2);
  [[nodiscard]] PlacedLabel place(const std::string& text, double x, double y);

 private:
  struct Box {
    double left, top, right, bottom;
  };
  [[nodiscard]] bool is_free(const Box& box) const;

  double width_;
  double height_;
  std::vector<Box> taken_;
};

/// Height of the text of labels, and about the width of a character.
inline constexpr double kLabelHeight = 12.0;
inline constexpr double kLabelCharacter = 6.6;

}  // namespace armcal
