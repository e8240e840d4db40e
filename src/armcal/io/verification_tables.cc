// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/verification_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"
#include "armcal/io/number_text.h"

namespace armcal {
namespace {

class TestReader {
 public:
  TestReader(const CsvTable& table, const StatedTest& test, const StatedArtefact* artefact,
             int joint_count, Diagnostics& diagnostics)
      : table_(table),
        test_(test),
        artefact_(artefact),
        joint_count_(joint_count),
        diagnostics_(diagnostics) {}

  std::optional<VerificationRows> read() {
    const std::size_t errors_before = diagnostics_.error_count();
    rows_.file = table_.file().path;
    for (std::size_t row = 0; row < table_.row_count(); ++row) {
      rows_.lines.push_back(table_.line(row));
    }
    rows_.place = names(filled("position") ? "position" : "placement");
    rows_.articulation = names("articulation");
    rows_.repeat = names("repeat");
    if (test_.kind == StatedTestKind::articulated_location && rows_.articulation.empty()) {
      missing("articulation", "it says which of the five ways of holding the arm a point is of");
    }
    if (measures_lengths(test_.kind)) read_lengths();
    read_measured();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return std::move(rows_);
  }

 private:
  void missing(const char* column, const std::string& remedy) {
    diagnostics_.error({rows_.file, 0, 0}, fmt::format("has no column {}", column),
                       fmt::format("{}; {}", table_.columns_in_words(), remedy));
  }

  // A column that says something of these rows: tables that tests share leave others' empty.
  [[nodiscard]] std::optional<std::size_t> filled(const char* name) const {
    const auto column = table_.find(name);
    for (std::size_t row = 0; column && row < table_.row_count(); ++row) {
      if (!table_.field(row, *column).empty()) return column;
    }
    return std::nullopt;
  }

  // The fields of a column; none where there is no such column.
  std::vector<std::string> names(const char* name) {
    std::vector<std::string> fields;
    const auto column = filled(name);
    for (std::size_t row = 0; column && row < table_.row_count(); ++row) {
      fields.emplace_back(table_.field(row, *column));
      if (fields.back().empty()) {
        diagnostics_.error(table_.where(row, *column), fmt::format("{} is empty", name));
      }
    }
    return fields;
  }

  void read_measured() {
    if (measures_lengths(test_.kind) && filled("measured")) {
      read_measured_lengths();
    } else if (joint_count_ > 0) {
      read_angles();
    } else {
      read_points();
    }
    if (measures_lengths(test_.kind) && rows_.measured_mm.empty()) read_ends();
  }

  void read_angles() {
    if (!table_.find("q1") && table_.find("x")) {
      diagnostics_.error({rows_.file, 0, 0}, "holds coordinates, but the file names an arm",
                         "joint angles are put through it; to judge coordinates that the arm's own "
                         "software gave, name no arm");
      return;
    }
    if (auto angles = joint_readings(table_, joint_count_, test_.table, diagnostics_)) {
      rows_.encoder_rad = std::move(angles->encoder_rad);
    }
  }

  void read_points() {
    if (!table_.find("x") && table_.find("q1")) {
      diagnostics_.error({rows_.file, 0, 0}, "holds joint angles, no coordinates",
                         "name the arm that turns them into tips: arm = \"ARM.arm.toml\", or "
                         "--arm ARM");
      return;
    }
    auto points = point_readings(table_, test_.table, diagnostics_);
    if (!points) return;
    if (points->planar) missing("z_mm", "a test needs all three coordinates");
    rows_.points_mm = std::move(points->points_mm);
  }

  void read_measured_lengths() {
    const std::size_t column = *table_.find("measured");
    rows_.measured_mm = table_.numbers(column, "measured length", diagnostics_);
    if (table_.columns()[column].unit != "mm") {
      diagnostics_.error({rows_.file, 0, 0},
                         fmt::format("{} is not in mm", table_.column_in_words(column)),
                         "call it measured_mm, and give lengths in mm");
    }
    for (std::size_t row = 0; row < rows_.measured_mm.size(); ++row) {
      if (std::isfinite(rows_.measured_mm[row]) && !(rows_.measured_mm[row] > 0.0)) {
        diagnostics_.error(table_.where(row, column), "a measured length must be larger than 0");
      }
    }
  }

  void read_ends() {
    const auto column = filled("end");
    if (!column) {
      missing("end",
              "a length is measured_mm, or the points at its two ends in rows with end A and B");
      return;
    }
    for (std::size_t row = 0; row < table_.row_count(); ++row) {
      const std::string_view text = table_.field(row, *column);
      const bool is_a = text == "A" || text == "a";
      if (!is_a && text != "B" && text != "b") {
        diagnostics_.error(table_.where(row, *column),
                           fmt::format("end \"{}\" is neither A nor B", text));
      }
      rows_.end.push_back(is_a ? 'A' : 'B');
    }
  }

  // Which calibrated length each row measures: by name, by nominal value, or the only one.
  void read_lengths() {
    const auto column = filled("length");
    if (!column) {
      if (artefact_->lengths.size() == 1) {
        rows_.length.assign(table_.row_count(), 0);
      } else {
        missing("length_mm", fmt::format("\"{}\" has {} lengths: say which one a row measures",
                                         artefact_->name, artefact_->lengths.size()));
      }
      return;
    }
    const std::string& unit = table_.columns()[*column].unit;
    if (!unit.empty() && unit != "mm") {
      diagnostics_.error({rows_.file, 0, 0},
                         fmt::format("{} is not in mm", table_.column_in_words(*column)),
                         "call it length_mm and give nominal lengths in mm, or length and give "
                         "their names");
      return;
    }
    const std::vector<double> nominal =
        unit == "mm" ? table_.numbers(*column, "nominal length", diagnostics_)
                     : std::vector<double>{};
    for (std::size_t row = 0; row < table_.row_count(); ++row) {
      rows_.length.push_back(nominal.empty() ? length_named(row, *column)
                                             : length_near(nominal[row], row, *column));
    }
  }

  std::size_t length_named(std::size_t row, std::size_t column) {
    const std::string name(table_.field(row, column));
    std::vector<std::string> known;
    for (std::size_t i = 0; i < artefact_->lengths.size(); ++i) {
      if (artefact_->lengths[i].name == name) return i;
      known.push_back(artefact_->lengths[i].name);
    }
    diagnostics_.error(table_.where(row, column),
                       fmt::format("\"{}\" has no length \"{}\"", artefact_->name, name),
                       did_you_mean(name, known));
    return 0;
  }

  std::size_t length_near(double nominal_mm, std::size_t row, std::size_t column) {
    if (!std::isfinite(nominal_mm)) return 0;  // told as no number
    const auto distance = [&](const CertifiedLength& length) {
      return std::abs(length.length_mm - nominal_mm);
    };
    const auto nearest = std::min_element(
        artefact_->lengths.begin(), artefact_->lengths.end(),
        [&](const auto& one, const auto& other) { return distance(one) < distance(other); });
    if (distance(*nearest) > kNominalWithin_mm) {
      diagnostics_.error(
          table_.where(row, column),
          fmt::format("\"{}\" has no length near {} mm", artefact_->name, nominal_mm),
          fmt::format("the nearest is {} mm; are these mm?", nearest->length_mm));
    }
    return static_cast<std::size_t>(nearest - artefact_->lengths.begin());
  }

  const CsvTable& table_;
  const StatedTest& test_;
  const StatedArtefact* artefact_;
  int joint_count_;
  Diagnostics& diagnostics_;
  VerificationRows rows_;
};

// Of a table that several tests share, the rows of this one.
std::optional<CsvTable> rows_of_test(const CsvTable& table, const StatedTest& test,
                                     Diagnostics& diagnostics) {
  const auto column = table.find("test");
  if (!column) return table;
  std::vector<std::size_t> rows;
  std::set<std::string> others;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string_view name = table.field(row, *column);
    if (name == test.name || name == to_string(test.kind)) {
      rows.push_back(row);
    } else {
      others.emplace(name);
    }
  }
  if (rows.empty()) {
    diagnostics.error({table.file().path, 0, 0},
                      fmt::format("has no rows of the test \"{}\"", test.name),
                      fmt::format("its column test holds: {}", fmt::join(others, ", ")));
    return std::nullopt;
  }
  return table.with_rows(rows);
}

}  // namespace

std::optional<std::vector<CertifiedLength>> certified_lengths(const CsvTable& table,
                                                              Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto length = table.find("length");
  const auto u = table.find("u");
  const std::string& path = table.file().path;
  for (const auto& [column, unit, header] :
       {std::tuple{length, "mm", "length_mm"}, std::tuple{u, "um", "U_um"}}) {
    if (!column || table.columns()[*column].unit != unit) {
      diagnostics.error({path, 0, 0}, fmt::format("has no column {}", header),
                        fmt::format("{}; calibrated lengths are a table name, length_mm, U_um",
                                    table.columns_in_words()));
    }
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  const auto lengths = table.numbers(*length, "length", diagnostics);
  const auto uncertainties = table.numbers(*u, "U", diagnostics);
  const auto names = table.find("name");
  std::vector<CertifiedLength> result;
  std::set<std::string> seen;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    result.push_back({names ? std::string(table.field(row, *names)) : fmt::format("{}", row + 1),
                      lengths[row], millimetres_from_micrometres(uncertainties[row])});
    if (!seen.insert(result.back().name).second) {
      diagnostics.error(table.where(row, *names),
                        fmt::format("the length \"{}\" is there twice", result.back().name));
    }
    if (lengths[row] <= 0.0) {
      diagnostics.error(table.where(row, *length), "a length must be larger than 0");
    }
    if (uncertainties[row] < 0.0) {
      diagnostics.error(table.where(row, *u), "U must not be negative");
    }
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return result;
}

std::optional<VerificationRows> verification_rows(const CsvTable& table, const StatedTest& test,
                                                  const StatedArtefact* artefact, int joint_count,
                                                  Diagnostics& diagnostics) {
  const auto own = rows_of_test(table, test, diagnostics);
  if (!own) return std::nullopt;
  return TestReader(*own, test, artefact, joint_count, diagnostics).read();
}

}  // namespace armcal
