// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/calibration_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/io/arm_file.h"

namespace armcal {
namespace {

using Json = nlohmann::json;

std::optional<SavedCalibration> read_document(const Json& document, const TextFile& file,
                                              Diagnostics& diagnostics) {
  SavedCalibration saved;
  const auto arm =
      read_arm({file.path, document.at("arm").get<std::string>(), file.encoding, ""}, diagnostics);
  if (!arm) return std::nullopt;
  saved.arm = *arm;
  const ParameterTable table(saved.arm);
  for (const Json& entry : document.at("parameters")) {
    SavedParameter each;
    each.name = entry.at("name").get<std::string>();
    each.unit =
        entry.at("unit").get<std::string>() == "mm" ? ParameterUnit::mm : ParameterUnit::rad;
    each.value = entry.at("value").get<double>();
    each.u = entry.at("u").get<double>();
    each.is_held = entry.at("status").get<std::string>() == "held";
    saved.parameters.push_back(std::move(each));
  }
  for (const Json& name : document.at("covariance_of")) {
    const auto index = table.find(name.get<std::string>());
    if (!index) {
      diagnostics.error({file.path, 0, 0},
                        fmt::format("covariance of \"{}\", which its arm does not have",
                                    name.get<std::string>()));
      return std::nullopt;
    }
    saved.free.push_back(*index);
  }
  const auto rows = document.at("covariance").get<std::vector<std::vector<double>>>();
  const auto size = static_cast<Eigen::Index>(saved.free.size());
  saved.covariance.resize(size, size);
  bool square = static_cast<Eigen::Index>(rows.size()) == size;
  for (Eigen::Index i = 0; square && i < size; ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    square = static_cast<Eigen::Index>(row.size()) == size;
    if (square) saved.covariance.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), size);
  }
  if (!square) {
    diagnostics.error({file.path, 0, 0}, fmt::format("its covariance is not {0} x {0}", size));
    return std::nullopt;
  }
  return saved;
}

}  // namespace

bool looks_like_json(const TextFile& file) {
  const std::size_t first = file.text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && file.text[first] == '{';
}

std::optional<SavedCalibration> read_calibration(const TextFile& file, Diagnostics& diagnostics) {
  const Json document = Json::parse(file.text, nullptr, false);
  if (document.is_discarded() || !document.is_object()) {
    diagnostics.error({file.path, 0, 0}, "is not JSON",
                      "a calibration is what armcal calibrate --save writes");
    return std::nullopt;
  }
  try {
    return read_document(document, file, diagnostics);
  } catch (const Json::exception& problem) {
    diagnostics.error({file.path, 0, 0}, fmt::format("is no calibration: {}", problem.what()),
                      "a calibration is what armcal calibrate --save writes");
    return std::nullopt;
  }
}

}  // namespace armcal
