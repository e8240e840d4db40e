// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/document.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/core/version.h"

namespace armcal {
namespace {

constexpr int kIndent = 2;

Json diagnostic_json(const Diagnostic& diagnostic) {
  Json entry;
  entry["message"] = diagnostic.message;
  entry["help"] = diagnostic.remedy.empty() ? Json() : Json(diagnostic.remedy);
  entry["file"] = diagnostic.where.file.empty() ? Json() : Json(diagnostic.where.file);
  entry["line"] = diagnostic.where.line > 0 ? Json(diagnostic.where.line) : Json();
  entry["column"] = diagnostic.where.column > 0 ? Json(diagnostic.where.column) : Json();
  return entry;
}

Json head_of(const DocumentHead& head) {
  Json document;
  document["schema"] = "armcal.result/1";
  document["tool_version"] = kVersion;
  document["command"] = head.command;
  document["command_line"] = head.command_line;
  document["inputs"] = Json::array();
  for (const InputRecord& input : head.inputs) {
    document["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  document["seed"] = head.seed ? Json(*head.seed) : Json();
  document["warnings"] = Json::array();
  for (const Diagnostic& warning : head.diagnostics.warnings()) {
    document["warnings"].push_back(diagnostic_json(warning));
  }
  return document;
}

// Text that came from users may hold bytes that are no UTF-8 (file names): they are replaced, not
// refused.
std::string dump(const Json& document) {
  return document.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string json_document(const DocumentHead& head, const Json& result) {
  Json document = head_of(head);
  for (const auto& [key, value] : result.items()) document[key] = value;
  return dump(document);
}

std::string json_error(const DocumentHead& head, int exit_code, const std::string& message) {
  Json document = head_of(head);
  Json& error = document["error"];
  error["exit_code"] = exit_code;
  error["message"] = message;
  error["problems"] = Json::array();
  for (const Diagnostic& entry : head.diagnostics.entries()) {
    if (entry.severity == Severity::error) error["problems"].push_back(diagnostic_json(entry));
  }
  return dump(document);
}

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json json_of(const std::optional<double>& value) { return value ? json_number(*value) : Json(); }

Json json_of(const Eigen::VectorXd& vector) {
  Json array = Json::array();
  for (const double value : vector) array.push_back(json_number(value));
  return array;
}

Json json_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back(json_of(Eigen::VectorXd(matrix.row(i).transpose())));
  }
  return rows;
}

}  // namespace armcal
