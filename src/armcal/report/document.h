// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"

namespace armcal {

using Json = nlohmann::ordered_json;

/// One file that a result was computed from.
struct InputRecord {
  std::string path;
  std::string sha256;
};

/// What every result says of its making.
struct DocumentHead {
  std::string command;
  std::vector<std::string> command_line;  ///< as typed, without the program's name
  std::vector<InputRecord> inputs;
  std::optional<std::uint64_t> seed;  ///< nothing where no random number was drawn
  Diagnostics diagnostics;            ///< its warnings go into the document
};

/// The object that `--json` prints: head first, then the keys of `result`. Numbers have the fewest
/// digits that read back the same; what is not a number is null.
[[nodiscard]] std::string json_document(const DocumentHead& head, const Json& result);

/// The same for a command that failed: key `error` with message and every problem found.
[[nodiscard]] std::string json_error(const DocumentHead& head, int exit_code,
                                     const std::string& message);

// Pieces of documents.
[[nodiscard]] Json json_of(const Eigen::VectorXd& vector);
[[nodiscard]] Json json_of(const Eigen::MatrixXd& matrix);  ///< rows of numbers
[[nodiscard]] Json json_of(const std::optional<double>& value);
/// null for NaN and infinities, which JSON does not know.
[[nodiscard]] Json json_number(double value);

}  // namespace armcal
