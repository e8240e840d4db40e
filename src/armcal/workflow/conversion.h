// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/workflow/input_files.h"

namespace armcal {

/// Descriptions of an arm with the same poses. The last two are for firmware and only written.
enum class ArmFormat { arm, dh_classic, dh_modified, urdf, c_header, csv_line };

/// Names of all formats, in the order above: "arm", "dh-classic", ..
[[nodiscard]] std::vector<std::string> arm_format_names();
[[nodiscard]] std::optional<ArmFormat> arm_format(std::string_view name);

struct ConversionRequest {
  std::string input;
  std::optional<ArmFormat> from;  ///< needed for a spreadsheet, which does not tell its convention
  ArmFormat to = ArmFormat::arm;
  bool as_csv = false;                    ///< a D-H table as theta_deg,d_mm,a_mm,alpha_deg
  std::optional<std::string> chain = {};  ///< of a URDF, "BASE:TIP"; default: root to only leaf
};

/// Text of the converted description. What the target cannot say is warned of. @throws InputError;
/// NumericalError where a D-H table would lose its digits (nearly parallel axes)
[[nodiscard]] std::string convert(InputFiles& files, const ConversionRequest& request,
                                  const TableOptions& options);

}  // namespace armcal
