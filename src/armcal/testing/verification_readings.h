// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal::testing {

/// Carries out the tests of the standards with a virtual arm: each function adds the rows of one
/// test, as a person writes them down. Angles are in degrees with four decimals, as arms show them.
class VerificationTable {
 public:
  /// @param columns  those before the angles, "position,point"
  VerificationTable(Laboratory& laboratory, const std::string& columns)
      : laboratory_(laboratory), text_(columns) {
    for (int joint = 1; joint <= laboratory.arm().truth().joint_count(); ++joint) {
      text_ += fmt::format(",q{}_deg", joint);
    }
    text_ += '\n';
  }

  /// A reading with the tip on a point, near a posture.
  void add(const std::string& fields, const Eigen::Vector3d& point_mm,
           const Eigen::VectorXd& near_rad) {
    const TakenReading reading = laboratory_.take_with_tip_at(point_mm, near_rad, fields);
    text_ += fields;
    for (const double angle : reading.encoder_rad) {
      text_ += fmt::format(",{:.4f}", degrees_from_radians(angle));
    }
    text_ += '\n';
  }
  /// The same in any posture.
  void add(const std::string& fields, const Eigen::Vector3d& point_mm) {
    add(fields, point_mm, laboratory_.postures_with_tip_at(point_mm, 1, fields).front());
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Laboratory& laboratory_;
  std::string text_;
};

/// Directions from the middle of a sphere to points spread over its upper three quarters.
inline std::vector<Eigen::Vector3d> probing_directions(int count) {
  std::vector<Eigen::Vector3d> directions;
  constexpr double kLowest = -0.5;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (1.0 - kLowest) * (i + 0.5) / count;
    const double r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return directions;
}

struct PlacedSphere {
  std::string name;
  Eigen::Vector3d center_mm;
};

/// @param radius_mm  of the sphere and of the probe's ball together
inline std::string probing_table(Laboratory& laboratory, const std::vector<PlacedSphere>& positions,
                                 double radius_mm, int points, const char* column = "position") {
  VerificationTable table(laboratory, fmt::format("{},point", column));
  for (const PlacedSphere& position : positions) {
    int number = 0;
    for (const Eigen::Vector3d& direction : probing_directions(points)) {
      table.add(fmt::format("{},{}", position.name, ++number),
                position.center_mm + radius_mm * direction);
    }
  }
  return table.text();
}

inline std::string articulation_table(Laboratory& laboratory, const Eigen::Vector3d& center_mm,
                                      double radius_mm, int articulations, int points) {
  VerificationTable table(laboratory, "articulation,point");
  int articulation = 0;
  for (const auto& posture :
       laboratory.postures_with_tip_at(center_mm, articulations, "the sphere")) {
    ++articulation;
    int number = 0;
    for (const Eigen::Vector3d& direction : probing_directions(points)) {
      table.add(fmt::format("{},{}", articulation, ++number), center_mm + radius_mm * direction,
                posture);
    }
  }
  return table.text();
}

inline std::string seat_table(Laboratory& laboratory, const std::vector<PlacedSphere>& seats,
                              int articulations) {
  VerificationTable table(laboratory, "position,articulation");
  for (const PlacedSphere& seat : seats) {
    int number = 0;
    for (const auto& posture :
         laboratory.postures_with_tip_at(seat.center_mm, articulations, seat.name)) {
      table.add(fmt::format("{},{}", seat.name, ++number), seat.center_mm, posture);
    }
  }
  return table.text();
}

/// A bar in the volume; seats of its lengths begin at one end.
struct PlacedBar {
  std::string name;
  Eigen::Vector3d start_mm;
  Eigen::Vector3d direction;       ///< unit
  std::vector<double> lengths_mm;  ///< calibrated
};

inline std::string length_table(Laboratory& laboratory, const std::vector<PlacedBar>& bars,
                                int repeats, const char* column = "position") {
  VerificationTable table(laboratory, fmt::format("{},length_mm,repeat,end", column));
  for (const PlacedBar& bar : bars) {
    for (const double length : bar.lengths_mm) {
      for (int repeat = 1; repeat <= repeats; ++repeat) {
        const std::string fields = fmt::format("{},{:.0f},{}", bar.name, length, repeat);
        table.add(fields + ",A", bar.start_mm);
        table.add(fields + ",B", bar.start_mm + length * bar.direction);
      }
    }
  }
  return table.text();
}

}  // namespace armcal::testing
