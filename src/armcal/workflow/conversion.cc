// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "armcal/arm/dh_table.h"
#include "armcal/io/arm_file.h"
#include "armcal/io/dh_file.h"
#include "armcal/io/firmware_text.h"
#include "armcal/io/urdf_file.h"
#include "armcal/io/urdf_writer.h"

namespace armcal {
namespace {

// In the order of ArmFormat.
constexpr std::array<std::string_view, 6> kFormatNames = {"arm",  "dh-classic", "dh-modified",
                                                          "urdf", "c-header",   "csv-line"};

bool looks_like_toml(const TextFile& file) {
  return file.text.find("schema") != std::string::npos && file.text.find('=') != std::string::npos;
}

DhConvention convention_of(ArmFormat format) {
  return format == ArmFormat::dh_classic ? DhConvention::classic : DhConvention::modified;
}

std::optional<ArmModel> read_arm_only(const TextFile& file, const ConversionRequest& request,
                                      Diagnostics& diagnostics) {
  if (request.from && *request.from != ArmFormat::arm) {
    diagnostics.error({file.path, 0, 0}, "is an arm file, which has no D-H convention",
                      "leave --from away");
  }
  return read_arm(file, diagnostics);
}

// The file's own word for its convention stands; another one from the user is a contradiction.
std::optional<ArmModel> read_dh_arm(const TextFile& file, const ConversionRequest& request,
                                    Diagnostics& diagnostics) {
  const auto table = read_dh(file, diagnostics);
  if (!table) return std::nullopt;
  if (request.from && convention_of(*request.from) != table->convention) {
    diagnostics.error({file.path, 0, 0},
                      fmt::format("says convention = \"{}\", which --from contradicts",
                                  to_string(table->convention)),
                      "leave --from away, or correct the file");
  }
  return arm_from_dh(*table);
}

std::optional<ArmModel> read_any(InputFiles& files, const ConversionRequest& request,
                                 const TableOptions& options) {
  auto file = files.text(request.input, kLargestConfiguration_bytes);
  if (!file) return std::nullopt;
  Diagnostics& diagnostics = files.diagnostics();
  if (looks_like_urdf(*file)) return read_urdf(*file, request.chain, diagnostics);
  if (request.chain) {
    diagnostics.error({request.input, 0, 0}, "is no URDF: --chain has no meaning for it");
    return std::nullopt;
  }
  if (looks_like_toml(*file)) {
    const bool is_dh = file->text.find("armcal.dh/") != std::string::npos;
    return is_dh ? read_dh_arm(*file, request, diagnostics)
                 : read_arm_only(*file, request, diagnostics);
  }
  if (request.from != ArmFormat::dh_classic && request.from != ArmFormat::dh_modified) {
    diagnostics.error({request.input, 0, 0},
                      "is no arm file and no URDF; is it a D-H table? then its convention must be "
                      "told",
                      "give --from dh-classic or --from dh-modified");
    return std::nullopt;
  }
  const auto csv = CsvTable::parse(std::move(*file), options.map, diagnostics);
  if (!csv) return std::nullopt;
  const auto table = dh_from_csv(*csv, convention_of(*request.from), diagnostics);
  return table ? std::optional(arm_from_dh(*table)) : std::nullopt;
}

bool is_identity(const RigidTransform& pose) {
  return pose.rotation.isIdentity(0.0) && pose.translation_mm.isZero(0.0);
}

void warn_of_losses(InputFiles& files, const std::string& input, std::string_view target,
                    const std::vector<std::string>& losses) {
  for (const std::string& lost : losses) {
    files.diagnostics().warning({input, 0, 0},
                                fmt::format("{} has no place for the {}: left out", target, lost));
  }
}

std::string table_text(InputFiles& files, const ConversionRequest& request, const ArmModel& arm) {
  const auto convention =
      request.to == ArmFormat::dh_classic ? DhConvention::classic : DhConvention::modified;
  const DhConversion conversion = dh_from_arm(arm, convention);
  warn_of_losses(files, request.input, "a D-H table", conversion.lost);
  if (!request.as_csv) return dh_text(conversion.table);
  if (!is_identity(conversion.table.base_from_first) ||
      !is_identity(conversion.table.last_from_tool)) {
    files.diagnostics().error({request.input, 0, 0},
                              "has a base or tool pose, for which a table of rows has no place",
                              "write it as *.dh.toml, or give --to arm");
    files.require_good();
  }
  return dh_csv_text(conversion.table);
}

}  // namespace

std::vector<std::string> arm_format_names() { return {kFormatNames.begin(), kFormatNames.end()}; }

std::optional<ArmFormat> arm_format(std::string_view name) {
  const auto found = std::find(kFormatNames.begin(), kFormatNames.end(), name);
  if (found == kFormatNames.end()) return std::nullopt;
  return static_cast<ArmFormat>(found - kFormatNames.begin());
}

std::string convert(InputFiles& files, const ConversionRequest& request,
                    const TableOptions& options) {
  const auto arm = read_any(files, request, options);
  files.require_good();
  switch (request.to) {
    case ArmFormat::arm:
      return arm_text(*arm);
    case ArmFormat::urdf: {
      const UrdfText urdf = urdf_text(*arm);
      warn_of_losses(files, request.input, "a URDF", urdf.lost);
      return urdf.text;
    }
    case ArmFormat::c_header: {
      const FirmwareText header = c_header_text(*arm);
      warn_of_losses(files, request.input, "the C header", header.lost);
      return header.text;
    }
    case ArmFormat::csv_line: {
      const FirmwareText line = csv_line_text(*arm);
      warn_of_losses(files, request.input, "the line of parameters", line.lost);
      return line.text;
    }
    case ArmFormat::dh_classic:
    case ArmFormat::dh_modified:
      break;
  }
  return table_text(files, request, *arm);
}

}  // namespace armcal
