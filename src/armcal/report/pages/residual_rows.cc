// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/residual_rows.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "armcal/core/utc_time.h"

namespace armcal {
namespace {

std::optional<Eigen::Vector3d> vector_if(const DocumentView& entry) {
  if (entry.json().is_null()) return std::nullopt;
  const std::vector<double> numbers = entry.as_numbers();
  if (numbers.size() != 3) entry.complain("is no vector of three numbers");
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

std::vector<double> numbers_if(const DocumentView& entry) {
  return entry.json().is_null() ? std::vector<double>() : entry.as_numbers();
}

// ISO 8601, or plain seconds.
std::optional<double> time_if(const DocumentView& entry) {
  if (!entry.json().is_string()) return entry.as_number_if();
  const auto time = parse_fractional_utc_time(entry.as_text());
  if (!time) entry.complain("is no time");
  return time;
}

// A column with as many entries as there are rows.
std::vector<DocumentView> column(const DocumentView& rows, const char* key, std::size_t count) {
  std::vector<DocumentView> entries = rows.list(key);
  if (entries.size() != count) {
    rows[key].complain(fmt::format("has {} entries, the column group {}", entries.size(), count));
  }
  return entries;
}

// Names of files without their folders, where that is enough to tell them apart.
class ShortNames {
 public:
  explicit ShortNames(const std::vector<DocumentView>& files) {
    for (const DocumentView& file : files) {
      const std::string path = file.as_text();
      paths_[name_in(path)].insert(path);
    }
  }
  [[nodiscard]] std::string of(const std::string& path) const {
    const std::string name = name_in(path);
    return paths_.at(name).size() == 1 ? name : path;
  }

 private:
  static std::string name_in(const std::string& path) {
    return path.substr(path.find_last_of("/\\") + 1);
  }
  std::map<std::string, std::set<std::string>> paths_;
};

}  // namespace

std::vector<ResidualRow> residual_rows(const DocumentView& document) {
  const DocumentView rows = document["rows"];
  const std::vector<DocumentView> group = rows.list("group");
  const std::size_t count = group.size();
  const auto file = column(rows, "file", count);
  const auto line = column(rows, "line", count);
  const auto check = column(rows, "check", count);
  const auto residual = column(rows, "residual_mm", count);
  const auto normalised = column(rows, "normalised", count);
  const auto u = column(rows, "u_mm", count);
  const auto time = column(rows, "time", count);
  const auto q = column(rows, "q_deg", count);
  const auto tip = column(rows, "tip_mm", count);
  const auto vector = column(rows, "residual_vector_mm", count);
  const auto components = column(rows, "components", count);
  const ShortNames names(file);
  std::vector<ResidualRow> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    ResidualRow& row = result[i];
    row.group = group[i].as_text();
    const std::string path = file[i].as_text();
    row.place = fmt::format("{}:{:.0f}", path, line[i].as_number());
    row.label = fmt::format("{}:{:.0f}", names.of(path), line[i].as_number());
    row.is_check = check[i].as_flag();
    row.residual_mm = residual[i].as_number();
    row.normalised = normalised[i].as_number();
    row.u_mm = u[i].as_number();
    row.time_s = time_if(time[i]);
    row.q_deg = numbers_if(q[i]);
    row.tip_mm = vector_if(tip[i]);
    row.residual_vector_mm = vector_if(vector[i]);
    row.components = numbers_if(components[i]);
  }
  return result;
}

}  // namespace armcal
