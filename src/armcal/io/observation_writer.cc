// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/observation_writer.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/core/utc_time.h"
#include "armcal/io/csv_text.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

template <typename Values>
bool all_equal(const Values& values) {
  return std::all_of(values.begin(), values.end(),
                     [&](const auto& value) { return value == *values.begin(); });
}

/// Columns of one table, and how each writes its field of a row.
class TableText {
 public:
  using Field = std::function<std::string(Eigen::Index row)>;

  void add(std::string header, Field field) {
    columns_.push_back({std::move(header), std::move(field)});
  }

  [[nodiscard]] std::string text(Eigen::Index rows) const {
    std::string text;
    for (const Column& column : columns_) {
      if (!text.empty()) text += ',';
      text += column.header;
    }
    text += '\n';
    for (Eigen::Index row = 0; row < rows; ++row) {
      std::string line;
      for (const Column& column : columns_) {
        if (!line.empty()) line += ',';
        line += column.field(row);
      }
      text += line;
      text += '\n';
    }
    return text;
  }

 private:
  struct Column {
    std::string header;
    Field field;
  };
  std::vector<Column> columns_;
};

class GroupWriter {
 public:
  explicit GroupWriter(const ObservationGroup& group) : group_(group) {}

  GroupTexts write() {
    start_entry();
    const bool in_place = group_.kind == ReferenceKind::length && group_.count() == 1;
    write_places();
    if (group_.kind != ReferenceKind::length) {
      table_.add(angle_header(group_.encoder_rad.rows()),
                 [this](auto row) { return angle_fields(group_.encoder_rad.col(row)); });
    }
    write_kind();
    write_uncertainties();
    write_sets();
    write_conditions();
    if (in_place) {
      texts_.entry.file.clear();
      texts_.entry.length_mm = group_.value_mm(0);
    } else {
      texts_.readings_csv = table_.text(group_.count());
      keep_repeats();
    }
    return std::move(texts_);
  }

 private:
  void start_entry() {
    SessionGroup& entry = texts_.entry;
    entry.name = group_.name;
    entry.kind = group_.kind;
    entry.file = group_.file.empty() ? group_.name + ".csv" : group_.file;
    entry.u_encoder_rad = group_.u_encoder_rad;
    entry.radius_mm = group_.radius_mm;
    entry.tip_radius_mm = group_.tip_radius_mm;
    entry.lever_mm = group_.lever_mm;
    entry.offset_mm = group_.offset_mm;
    entry.target = group_.target;
  }

  void add_names(const char* header, const std::vector<std::string>& names) {
    table_.add(header,
               [&names](auto row) { return text_field(names[static_cast<std::size_t>(row)]); });
  }
  void add_values(const char* header, const Eigen::VectorXd& values) {
    table_.add(header, [&values](auto row) { return length_field(values(row)); });
  }

  void write_places() {
    const char* key = place_key(group_.kind);
    if (key == nullptr) return;
    if (!all_equal(group_.place)) {
      add_names(key, group_.place);
    } else if (!group_.place.empty()) {
      texts_.entry.place = group_.place.front();
    }
    if (group_.kind != ReferenceKind::length) return;
    if (!all_equal(group_.place_to)) {
      add_names("to", group_.place_to);
    } else if (!group_.place_to.empty()) {
      texts_.entry.place_to = group_.place_to.front();
    }
  }

  void write_kind() {
    switch (group_.kind) {
      case ReferenceKind::reference_points:
        return write_points();
      case ReferenceKind::reference_poses:
        write_points();
        return write_orientations();
      case ReferenceKind::artefact:
        return write_features();
      case ReferenceKind::length:
        return add_values("length_mm", group_.value_mm);
      case ReferenceKind::reversal:
        write_joints();
        texts_.entry.turn_rad = common_turn_rad();
        return add_values("distance_mm", group_.value_mm);
      case ReferenceKind::circle_radius:
        write_joints();
        return add_values("radius_mm", group_.value_mm);
      case ReferenceKind::fixed_point:
      case ReferenceKind::sphere:
      case ReferenceKind::plane:
        return;
    }
  }

  void write_points() {
    table_.add("x_mm,y_mm,z_mm",
               [this](auto row) { return point_fields(group_.reference_mm.col(row)); });
  }

  void write_orientations() {
    table_.add("qx,qy,qz,qw", [this](auto row) {
      Eigen::Quaterniond q(group_.orientation[static_cast<std::size_t>(row)]);
      if (q.w() < 0.0) q.coeffs() = -q.coeffs();
      constexpr int kPlaces = 12;
      return fmt::format("{},{},{},{}", decimal_text(q.x(), kPlaces), decimal_text(q.y(), kPlaces),
                         decimal_text(q.z(), kPlaces), decimal_text(q.w(), kPlaces));
    });
  }

  void write_joints() {
    if (all_equal(group_.joint)) {
      if (!group_.joint.empty()) texts_.entry.joint = group_.joint.front();
      return;
    }
    table_.add("joint", [this](auto row) {
      return std::to_string(group_.joint[static_cast<std::size_t>(row)]);
    });
  }

  [[nodiscard]] double common_turn_rad() const {
    constexpr double kRounding_rad = 1e-12;
    if (group_.count() == 0) return 0.0;
    const Eigen::MatrixXd difference = group_.encoder_end_rad - group_.encoder_rad;
    const double turn_rad = difference(group_.joint.front() - 1, 0);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(difference.rows(), difference.cols());
    for (Eigen::Index row = 0; row < expected.cols(); ++row) {
      expected(group_.joint[static_cast<std::size_t>(row)] - 1, row) = turn_rad;
    }
    if ((difference - expected).cwiseAbs().maxCoeff() > kRounding_rad) {
      throw std::invalid_argument(
          fmt::format("the turns of \"{}\" differ: a table of reversals has one turn of one joint "
                      "for all rows",
                      group_.name));
    }
    return turn_rad;
  }

  void write_features() {
    add_names("feature", group_.feature);
    const std::filesystem::path path = texts_.entry.file;
    texts_.entry.artefact_file =
        (path.parent_path() / (path.stem().string() + "-coordinates.csv")).string();
    std::map<std::string, Eigen::Index> first;
    std::string text = "feature,x_mm,y_mm,z_mm\n";
    for (Eigen::Index row = 0; row < group_.count(); ++row) {
      const std::string& name = group_.feature[static_cast<std::size_t>(row)];
      const auto [at, is_new] = first.emplace(name, row);
      if (is_new) {
        text += text_field(name) + "," + point_fields(group_.reference_mm.col(row)) + "\n";
      } else if (group_.reference_mm.col(at->second) != group_.reference_mm.col(row)) {
        throw std::invalid_argument(
            fmt::format("the feature \"{}\" of \"{}\" has two places", name, group_.name));
      }
    }
    texts_.artefact_csv = text;
  }

  void write_uncertainties() {
    if (all_equal(group_.u_mm)) {
      if (group_.count() > 0) texts_.entry.u_mm = group_.u_mm(0);
      return;
    }
    table_.add("u_mm", [this](auto row) { return fmt::format("{:.6g}", group_.u_mm(row)); });
  }

  void write_sets() {
    if (all_equal(group_.is_check)) {
      if (group_.count() > 0 && group_.is_check.front()) texts_.entry.set = "check";
      return;
    }
    table_.add("set", [this](auto row) {
      return group_.is_check[static_cast<std::size_t>(row)] ? "check" : "fit";
    });
  }

  void write_conditions() {
    const auto field = [](double value, const auto& text) {
      return std::isnan(value) ? std::string() : text(value);
    };
    if (group_.time_s.size() > 0) {
      table_.add("time", [this, field](auto row) {
        return field(group_.time_s(row), [this](double time_s) {
          return group_.time_is_utc ? fractional_utc_text(time_s) : decimal_text(time_s, 3);
        });
      });
    }
    if (group_.temperature_c.size() > 0) {
      table_.add("temperature_c", [this, field](auto row) {
        return field(group_.temperature_c(row),
                     [](double temperature_c) { return decimal_text(temperature_c, 4); });
      });
    }
  }

  // A reader takes equal postures, points and rows for copies, and 0 0 0 for a missing point.
  void keep_repeats() {
    const bool has_points = group_.kind == ReferenceKind::reference_points ||
                            group_.kind == ReferenceKind::reference_poses;
    std::set<std::string> distinct;
    bool has_zero = false;
    for (Eigen::Index row = 0; row < group_.count(); ++row) {
      if (has_points) {
        const std::string point = point_fields(group_.reference_mm.col(row));
        has_zero = has_zero || point == "0,0,0";
        distinct.insert(point);
      } else if (group_.kind != ReferenceKind::length) {
        distinct.insert(angle_fields(group_.encoder_rad.col(row)));
      } else {
        return;
      }
    }
    texts_.entry.table.keep_duplicates =
        static_cast<Eigen::Index>(distinct.size()) < group_.count();
    texts_.entry.table.keep_zero_points = has_zero;
  }

  const ObservationGroup& group_;
  TableText table_;
  GroupTexts texts_;
};

}  // namespace

GroupTexts group_texts(const ObservationGroup& group) { return GroupWriter(group).write(); }

}  // namespace armcal
