// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "armcal/geometry/sphere.h"

namespace armcal {
namespace {

struct Group {
  std::string name;
  std::vector<std::size_t> rows;
};

// Rows of equal keys, in the order in which each key first occurs.
template <typename Key>
std::vector<std::vector<std::size_t>> grouped(std::size_t count, const Key& key_of) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<decltype(key_of(std::size_t{})), std::size_t> known;
  for (std::size_t row = 0; row < count; ++row) {
    const auto [at, is_new] = known.emplace(key_of(row), groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(row);
  }
  return groups;
}

// What a table without such a column says of every row.
std::string field(const std::vector<std::string>& column, std::size_t row) {
  return column.empty() ? std::string("1") : column[row];
}

std::string place(const VerificationRows& rows, std::size_t row) {
  return fmt::format("{}:{}", rows.file, rows.lines[row]);
}

std::vector<Eigen::Vector3d> points(const RowsWithTips& tips,
                                    const std::vector<std::size_t>& rows) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(rows.size());
  for (const std::size_t row : rows) result.push_back(tips.tips_mm[row]);
  return result;
}

std::vector<Group> by_column(const VerificationRows& rows, const std::vector<std::string>& column) {
  std::vector<Group> groups;
  for (auto& members : grouped(rows.count(), [&](std::size_t row) { return field(column, row); })) {
    groups.push_back({field(column, members.front()), std::move(members)});
  }
  return groups;
}

std::vector<Group> by_place_and_repeat(const VerificationRows& rows) {
  std::vector<Group> groups;
  const auto key = [&](std::size_t row) {
    return std::pair(field(rows.place, row), field(rows.repeat, row));
  };
  for (auto& members : grouped(rows.count(), key)) {
    const auto [name, repeat] = key(members.front());
    groups.push_back({rows.repeat.empty()  ? name
                      : rows.place.empty() ? repeat
                                           : fmt::format("{}, repeat {}", name, repeat),
                      std::move(members)});
  }
  return groups;
}

std::vector<SpherePoints> spheres_of(const RowsWithTips& tips, const std::vector<Group>& groups) {
  std::vector<SpherePoints> spheres;
  for (const Group& group : groups) {
    spheres.push_back({group.name, points(tips, group.rows), place(tips.rows, group.rows.front())});
  }
  return spheres;
}

/// Takes the rows of one measurement of one length after the other.
class LengthReader {
 public:
  LengthReader(const RowsWithTips& tips, const LengthReading& reading, Diagnostics& diagnostics)
      : tips_(tips), rows_(tips.rows), reading_(reading), diagnostics_(diagnostics) {}

  std::vector<MeasuredLength> read() {
    if (rows_.has_measured_lengths()) {
      for (std::size_t row = 0; row < rows_.count(); ++row) add(row, rows_.measured_mm[row]);
      return std::move(lengths_);
    }
    const auto key = [&](std::size_t row) {
      return std::tuple(field(rows_.place, row), rows_.length[row], field(rows_.repeat, row));
    };
    for (const auto& members : grouped(rows_.count(), key)) {
      if (const auto measured = distance_of_ends(members)) add(members.front(), *measured);
    }
    return std::move(lengths_);
  }

 private:
  // Repeats count in the order in which they were measured.
  void add(std::size_t row, double measured_mm) {
    const std::size_t length = rows_.length[row];
    MeasuredLength entry;
    entry.position = field(rows_.place, row);
    entry.calibrated_mm = reading_.calibrated_mm[length];
    entry.measured_mm = measured_mm;
    entry.repeat = ++repeats_[{entry.position, length}];
    entry.where = place(rows_, row);
    lengths_.push_back(std::move(entry));
  }

  std::optional<double> distance_of_ends(const std::vector<std::size_t>& members) {
    std::vector<std::size_t> of_a;
    std::vector<std::size_t> of_b;
    for (const std::size_t row : members) (rows_.end[row] == 'A' ? of_a : of_b).push_back(row);
    if (of_a.empty() || of_b.empty()) {
      complain(members.front(), of_a.empty() ? 'A' : 'B', "is missing",
               "a length has two ends, in rows of the same position, length and repeat");
      return std::nullopt;
    }
    const auto a = end_of(of_a, 'A');
    const auto b = end_of(of_b, 'B');
    if (!a || !b) return std::nullopt;
    return (*a - *b).norm() - reading_.probe_mm;
  }

  std::optional<Eigen::Vector3d> end_of(const std::vector<std::size_t>& members, char end) {
    if (members.size() == 1) return tips_.tips_mm[members.front()];
    if (reading_.opposite_ends) {
      complain(members.front(), end, fmt::format("has {} points", members.size()),
               "a bidirectional length has one point at each end; distances of sphere centres are "
               "unidirectional (length_uni)");
      return std::nullopt;
    }
    constexpr std::size_t kOfSphere = 4;
    if (members.size() < kOfSphere) {
      complain(members.front(), end, fmt::format("has {} points", members.size()),
               "an end is one point in a seat or on a face, or at least 4 on a sphere; a column "
               "repeat tells repeats apart");
      return std::nullopt;
    }
    const SphereFit fit = fit_sphere(points(tips_, members));
    if (!fit.ok()) {
      complain(members.front(), end, "is no sphere", std::string(explain(fit.status)));
      return std::nullopt;
    }
    return fit.center_mm;
  }

  void complain(std::size_t row, char end, const std::string& what, const std::string& remedy) {
    diagnostics_.error({rows_.file, rows_.lines[row], 0},
                       fmt::format("end {} of {:.4f} mm at position {}, repeat {}: {}", end,
                                   reading_.calibrated_mm[rows_.length[row]],
                                   field(rows_.place, row), field(rows_.repeat, row), what),
                       remedy);
  }

  const RowsWithTips& tips_;
  const VerificationRows& rows_;
  const LengthReading& reading_;
  Diagnostics& diagnostics_;
  std::map<std::pair<std::string, std::size_t>, int> repeats_;
  std::vector<MeasuredLength> lengths_;
};

}  // namespace

std::vector<SpherePoints> spheres_by_place(const RowsWithTips& tips) {
  return spheres_of(tips, by_column(tips.rows, tips.rows.place));
}

std::vector<SpherePoints> spheres_by_repeat(const RowsWithTips& tips) {
  return spheres_of(tips, by_place_and_repeat(tips.rows));
}

std::vector<SpherePoints> spheres_by_articulation(const RowsWithTips& tips,
                                                  Diagnostics& diagnostics) {
  const VerificationRows& rows = tips.rows;
  for (std::size_t row = 1; row < rows.place.size(); ++row) {
    if (rows.place[row] == rows.place.front()) continue;
    diagnostics.error({rows.file, rows.lines[row], 0},
                      fmt::format("position {} after position {}: the sphere must stand still",
                                  rows.place[row], rows.place.front()),
                      "articulated location is measured at one position; write a test for each");
    break;
  }
  return spheres_of(tips, by_column(rows, rows.articulation));
}

std::vector<b89_4_22::SeatPoints> seats_by_place(const RowsWithTips& tips) {
  std::vector<b89_4_22::SeatPoints> seats;
  for (const Group& group : by_column(tips.rows, tips.rows.place)) {
    seats.push_back({group.name, points(tips, group.rows), place(tips.rows, group.rows.front())});
  }
  return seats;
}

std::vector<MeasuredLength> measured_lengths(const RowsWithTips& tips, const LengthReading& reading,
                                             Diagnostics& diagnostics) {
  return LengthReader(tips, reading, diagnostics).read();
}

}  // namespace armcal
