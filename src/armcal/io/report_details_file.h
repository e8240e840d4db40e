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

/// A laboratory that results come from, other than the one that reports.
struct ExternalProvider {
  std::string name;
  std::string results;  ///< which ones
};

/// What a report says beside the result: ISO/IEC 17025:2017, 7.8.2, 7.8.4 and 7.8.8. All of it is
/// text as typed, maybe of several lines; what is empty is not printed.
/// docs/files/report-details.md
struct ReportDetails {
  std::string title;
  std::string number;    ///< unique; empty: made from the result
  std::string replaces;  ///< number of the report in whose place this one is issued
  struct Laboratory {
    std::string name, address, accreditation;
  } laboratory;
  struct Customer {
    std::string name, address;
  } customer;
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
  std::vector<ExternalProvider> externals;
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
/// them, go to `diagnostics`; dates in an order that cannot be, as warnings.
[[nodiscard]] std::optional<ReportDetails> read_report_details(const TextFile& file,
                                                               Diagnostics& diagnostics);

}  // namespace armcal
