// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"

namespace armcal {

/// A standard that the readings were held against, and where its value comes from.
struct ReferenceStandard {
  std::string name;
  std::string serial;
  std::string certificate;
  std::string traceable_to;
  std::string uncertainty;
  std::string due;  ///< date until which its calibration counts
};

/// What a report says beside the result: ISO/IEC 17025:2017, 7.8.2 and 7.8.4. All of it is text as
/// typed; what is empty is not printed. docs/files/report-details.md
struct ReportDetails {
  std::string title;
  std::string number;  ///< unique; empty: made from the result
  struct Party {
    std::string name, address, accreditation;
  } laboratory, customer;
  std::string place;  ///< where the work was done, if not at the laboratory
  struct Item {
    std::string description, maker, model, serial, probe, condition;
  } item;
  struct Dates {
    std::string received, performed, issued;
  } dates;
  struct Environment {
    std::string temperature, humidity, mounting, remarks;
  } environment;
  std::vector<ReferenceStandard> references;
  struct Method {
    std::string name, edition, deviations;
  } method;
  struct Statements {
    std::string uncertainty, decision_rule, remarks;
  } statements;
  struct Release {
    std::string name, role;
  } released_by;
  std::string source;  ///< text of the file that all this came from
};

/// Reads a details file (*.details.toml, schema armcal.details/1). Problems, unknown keys among
/// them, go to `diagnostics`.
[[nodiscard]] std::optional<ReportDetails> read_report_details(const TextFile& file,
                                                               Diagnostics& diagnostics);

}  // namespace armcal
