// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/observation_tables.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "armcal/core/spelling.h"
#include "armcal/io/row_conditions.h"

namespace armcal {
namespace {

class GroupReader {
 public:
  GroupReader(const SessionGroup& session, const CsvTable& table, const CsvTable* artefact,
              int joint_count, Diagnostics& diagnostics)
      : session_(session),
        table_(table),
        artefact_(artefact),
        joint_count_(joint_count),
        diagnostics_(diagnostics) {}

  std::optional<ObservationGroup> read() {
    const std::size_t errors_before = diagnostics_.error_count();
    group_.name = session_.name;
    group_.kind = session_.kind;
    group_.where = session_.where;
    group_.file = table_.file().path;
    group_.radius_mm = session_.radius_mm;
    group_.tip_radius_mm = session_.tip_radius_mm;
    group_.lever_mm = session_.lever_mm;
    group_.u_encoder_rad = session_.u_encoder_rad;
    group_.offset_mm = session_.offset_mm;
    group_.target = session_.target;
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      group_.lines.push_back(table_.line(row));
    read_uncertainties();
    read_sets();
    read_conditions(table_, group_, diagnostics_);
    if (group_.kind != ReferenceKind::length) read_angles();
    read_kind();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return std::move(group_);
  }

 private:
  [[nodiscard]] std::size_t rows() const { return table_.row_count(); }

  void read_uncertainties() {
    group_.u_mm =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(rows()), session_.u_mm.value_or(1.0));
    const auto column = table_.find("u");
    if (!column) {
      if (!session_.u_mm) {
        diagnostics_.error(session_.where,
                           fmt::format("the readings of \"{}\" have no uncertainty", session_.name),
                           "give u_mm = .. here, or a column u_mm: what a reading scatters by, as "
                           "a standard deviation");
      }
      return;
    }
    const auto values = table_.numbers(*column, "uncertainty", diagnostics_);
    for (std::size_t row = 0; row < rows(); ++row) {
      group_.u_mm(static_cast<Eigen::Index>(row)) = values[row];
      if (std::isfinite(values[row]) && !(values[row] > 0.0)) {
        diagnostics_.error(table_.where(row, *column), "the uncertainty must be larger than 0");
      }
    }
  }

  void read_sets() {
    group_.is_check.assign(rows(), session_.set == "check");
    const auto column = table_.find("set");
    if (!column) return;
    for (std::size_t row = 0; row < rows(); ++row) {
      const std::string_view set = table_.field(row, *column);
      if (set != "fit" && set != "check") {
        diagnostics_.error(table_.where(row, *column),
                           fmt::format("set \"{}\" is neither fit nor check", set));
      }
      group_.is_check[row] = set == "check";
    }
  }

  void read_angles() {
    const auto angles = joint_readings(table_, joint_count_, session_.table, diagnostics_);
    if (!angles) return;
    group_.encoder_rad = angles->encoder_rad;
    check_postures();
  }

  // The same posture twice is a copied row - unless the reference says that the arm came back to
  // it.
  void check_postures() {
    const bool by_coordinates = group_.kind == ReferenceKind::reference_points ||
                                group_.kind == ReferenceKind::reference_poses;
    if (session_.table.keep_duplicates || by_coordinates) return;
    std::vector<Eigen::Index> order(rows());
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto less = [&](Eigen::Index one, Eigen::Index other) {
      const auto a = group_.encoder_rad.col(one);
      const auto b = group_.encoder_rad.col(other);
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::stable_sort(order.begin(), order.end(), less);
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (less(order[i - 1], order[i])) continue;
      diagnostics_.error(
          {group_.file, table_.line(static_cast<std::size_t>(order[i])), 0},
          fmt::format("has the same angles as line {}",
                      table_.line(static_cast<std::size_t>(order[i - 1]))),
          "delete the copy, or write keep_duplicates = true if the readings are real");
    }
  }

  void read_kind() {
    switch (group_.kind) {
      case ReferenceKind::reference_points:
        read_points();
        read_places("setup", "setup");
        break;
      case ReferenceKind::reference_poses:
        read_points();
        read_orientations();
        read_places("setup", "setup");
        break;
      case ReferenceKind::fixed_point:
        read_places("point", nullptr);
        break;
      case ReferenceKind::artefact:
        read_features();
        read_places("placement", "placement");
        break;
      case ReferenceKind::length:
        read_places("from", nullptr);
        read_places_to();
        read_values("length", "length");
        break;
      case ReferenceKind::reversal:
        read_joints();
        turn_joints();
        read_values("distance", "distance");
        break;
      case ReferenceKind::circle_radius:
        read_joints();
        read_values("radius", "radius");
        break;
      case ReferenceKind::sphere:
        read_places("sphere", "sphere");
        break;
      case ReferenceKind::plane:
        read_places("plane", "plane");
        break;
    }
  }

  void read_points() {
    TableOptions options = session_.table;
    const auto points = point_readings(table_, options, diagnostics_);
    if (!points) return;
    if (points->planar) {
      diagnostics_.error({group_.file, 0, 0}, "has no column z_mm",
                         "reference points need all three coordinates");
    }
    group_.reference_mm.resize(3, static_cast<Eigen::Index>(rows()));
    for (std::size_t row = 0; row < rows(); ++row) {
      group_.reference_mm.col(static_cast<Eigen::Index>(row)) = points->points_mm[row];
    }
  }

  [[nodiscard]] std::optional<std::size_t> required(const std::string& name,
                                                    const std::string& remedy) {
    const auto column = table_.find(name);
    if (!column) {
      diagnostics_.error({group_.file, 0, 0}, fmt::format("has no column {}", name),
                         fmt::format("its columns: {}; {}", table_.header_list(), remedy));
    }
    return column;
  }

  void read_orientations() {
    Eigen::Matrix4Xd quaternions(4, static_cast<Eigen::Index>(rows()));
    constexpr const char* kNames[] = {"qx", "qy", "qz", "qw"};
    for (Eigen::Index k = 0; k < 4; ++k) {
      const auto column = required(kNames[k], "poses need a quaternion qx, qy, qz, qw");
      if (!column) return;
      const auto values = table_.numbers(*column, "quaternion", diagnostics_);
      for (std::size_t row = 0; row < rows(); ++row)
        quaternions(k, static_cast<Eigen::Index>(row)) = values[row];
    }
    for (std::size_t row = 0; row < rows(); ++row) {
      const Eigen::Vector4d q = quaternions.col(static_cast<Eigen::Index>(row));
      constexpr double kUnit = 1e-3;
      if (std::abs(q.norm() - 1.0) > kUnit) {
        diagnostics_.error({group_.file, table_.line(row), 0},
                           fmt::format("the quaternion has length {:.4f}: must be 1", q.norm()));
      }
      group_.orientation.push_back(
          Eigen::Quaterniond(q(3), q(0), q(1), q(2)).normalized().toRotationMatrix());
    }
  }

  // Names of places by column, else the session's, else one that stands for "all of this file".
  void read_places(const char* column_name, const char* default_name) {
    const auto column = table_.find(column_name);
    if (!column && session_.place.empty() && default_name == nullptr) {
      diagnostics_.error(
          {group_.file, 0, 0}, fmt::format("has no column {}", column_name),
          fmt::format("write {} = \"NAME\" in the session where all rows share one", column_name));
      return;
    }
    for (std::size_t row = 0; row < rows(); ++row) {
      if (column) {
        group_.place.emplace_back(table_.field(row, *column));
        if (group_.place.back().empty()) {
          diagnostics_.error(table_.where(row, *column), fmt::format("{} is empty", column_name));
        }
      } else {
        group_.place.push_back(session_.place.empty() ? session_.name : session_.place);
      }
    }
  }

  void read_places_to() {
    const auto column = table_.find("to");
    if (!column && session_.place_to.empty()) {
      diagnostics_.error({group_.file, 0, 0}, "has no column to",
                         "a length leads from one fixed point to another");
      return;
    }
    for (std::size_t row = 0; row < rows(); ++row) {
      group_.place_to.emplace_back(column ? std::string(table_.field(row, *column))
                                          : session_.place_to);
    }
  }

  void read_values(const char* name, const char* quantity) {
    const auto column = required(name, fmt::format("it must be called {}_mm", name));
    if (!column) return;
    const auto values = table_.numbers(*column, quantity, diagnostics_);
    group_.value_mm =
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    for (std::size_t row = 0; row < rows(); ++row) {
      if (std::isfinite(values[row]) && !(values[row] > 0.0)) {
        diagnostics_.error(table_.where(row, *column),
                           fmt::format("the {} must be larger than 0", quantity));
      }
    }
  }

  void read_joints() {
    const auto column = table_.find("joint");
    if (!column && !session_.joint) {
      diagnostics_.error(session_.where, "joint is missing here",
                         "say which joint turns, or give a column joint");
      return;
    }
    std::vector<double> values(rows(), session_.joint.value_or(0));
    if (column) values = table_.numbers(*column, "joint", diagnostics_);
    for (std::size_t row = 0; row < rows(); ++row) {
      const bool known =
          values[row] >= 1 && values[row] <= joint_count_ && values[row] == std::floor(values[row]);
      if (!known) {
        diagnostics_.error(column ? table_.where(row, *column) : session_.where,
                           fmt::format("joint {} is none of 1 to {}", values[row], joint_count_));
      }
      group_.joint.push_back(known ? static_cast<int>(values[row]) : 1);
    }
  }

  void turn_joints() {
    if (group_.encoder_rad.cols() == 0 || group_.joint.size() != rows()) return;
    group_.encoder_end_rad = group_.encoder_rad;
    for (std::size_t row = 0; row < rows(); ++row) {
      group_.encoder_end_rad(group_.joint[row] - 1, static_cast<Eigen::Index>(row)) +=
          session_.turn_rad;
    }
  }

  void read_features() {
    const auto column = required("feature", "it says which point of the artefact was probed");
    const auto names = artefact_->find("feature");
    if (!names) {
      diagnostics_.error({artefact_->file().path, 0, 0}, "has no column feature",
                         "an artefact is a table feature, x_mm, y_mm, z_mm");
      return;
    }
    TableOptions options;
    options.keep_zero_points = true;  // one of its points may well be the origin
    const auto points = point_readings(*artefact_, options, diagnostics_);
    if (!points || !column) return;
    std::map<std::string, Eigen::Vector3d> known;
    for (std::size_t row = 0; row < artefact_->row_count(); ++row) {
      const std::string name(artefact_->field(row, *names));
      if (!known.emplace(name, points->points_mm[row]).second) {
        diagnostics_.error(artefact_->where(row, *names),
                           fmt::format("the feature \"{}\" is there twice", name));
      }
    }
    std::vector<std::string> all;
    for (const auto& entry : known) all.push_back(entry.first);
    group_.reference_mm.setZero(3, static_cast<Eigen::Index>(rows()));
    for (std::size_t row = 0; row < rows(); ++row) {
      const std::string name(table_.field(row, *column));
      group_.feature.push_back(name);
      const auto at = known.find(name);
      if (at == known.end()) {
        diagnostics_.error(
            table_.where(row, *column),
            fmt::format("the artefact {} has no feature \"{}\"", artefact_->file().path, name),
            did_you_mean(name, all));
        continue;
      }
      group_.reference_mm.col(static_cast<Eigen::Index>(row)) = at->second;
    }
  }

  const SessionGroup& session_;
  const CsvTable& table_;
  const CsvTable* artefact_;
  int joint_count_;
  Diagnostics& diagnostics_;
  ObservationGroup group_;
};

// A length given in the session itself: a group of one row.
std::optional<ObservationGroup> length_in_place(const SessionGroup& session,
                                                Diagnostics& diagnostics) {
  if (session.place.empty() || session.place_to.empty()) {
    diagnostics.error(session.where, "a length needs from and to",
                      "name two fixed points: from = \"A\", to = \"B\"");
  }
  if (!session.u_mm) {
    diagnostics.error(session.where,
                      fmt::format("the length \"{}\" has no uncertainty", session.name),
                      "give u_mm: that of its certificate");
  }
  if (session.place.empty() || session.place_to.empty() || !session.u_mm) return std::nullopt;
  ObservationGroup group;
  group.name = session.name;
  group.kind = session.kind;
  group.where = session.where;
  group.file = session.where.file;
  group.lines = {session.where.line};
  group.is_check = {session.set == "check"};
  group.u_mm = Eigen::VectorXd::Constant(1, *session.u_mm);
  group.value_mm = Eigen::VectorXd::Constant(1, session.length_mm.value_or(0.0));
  group.place = {session.place};
  group.place_to = {session.place_to};
  return group;
}

}  // namespace

std::optional<ObservationGroup> observation_group(const SessionGroup& session,
                                                  const CsvTable* table, const CsvTable* artefact,
                                                  int joint_count, Diagnostics& diagnostics) {
  if (table == nullptr) return length_in_place(session, diagnostics);
  return GroupReader(session, *table, artefact, joint_count, diagnostics).read();
}

}  // namespace armcal
