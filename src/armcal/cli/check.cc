// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/workflow/check_job.h"

namespace armcal::cli {
namespace {

struct CheckFlags {
  CheckRequest request;
  std::optional<double> tip_diameter_mm, limit_mm, baseline;
  std::optional<std::string> note, time, export_csv;
  TableFlags table;
};

UtcSeconds time_of(const std::optional<std::string>& typed) {
  if (!typed) {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now())
        .time_since_epoch()
        .count();
  }
  const auto time = parse_utc_time(*typed);
  if (!time) {
    throw std::invalid_argument(fmt::format(
        "--time {}: is no time\n  help: as in 2026-03-02, 2026-03-02T09:15Z (UTC where no zone is "
        "given), 2026-03-02T10:15+01:00",
        *typed));
  }
  return *time;
}

void require_sense(const CheckFlags& flags) {
  const CheckRequest& request = flags.request;
  if (!request.readings && !request.history) {
    throw std::invalid_argument(
        "check: nothing to do\n  help: give READINGS.csv, or a history to look at: --history FILE");
  }
  if (flags.export_csv && !request.history) {
    throw std::invalid_argument("--export: there is no history\n  help: name it: --history FILE");
  }
  if (flags.baseline && *flags.baseline < 2.0) {
    throw std::invalid_argument("--baseline 1: two checks have the first range; 10 are usual");
  }
}

CheckRequest request_of(const CheckFlags& flags) {
  CheckRequest request = flags.request;
  request.options.tip_diameter_mm = flags.tip_diameter_mm.value_or(0.0);
  // The first number of a data sheet: of a sphere its diameter, of a seat the largest deviation.
  CheckLimits& limits = request.options.limits;
  (request.options.diameter_mm ? limits.diameter_mm : limits.deviation_mm) = flags.limit_mm;
  request.note = flags.note.value_or("");
  request.time = time_of(flags.time);
  request.baseline =
      static_cast<std::size_t>(count_or(flags.baseline, static_cast<int>(request.baseline)));
  return request;
}

int run_check_command(const CheckFlags& flags, const Context& context) {
  require_sense(flags);
  const CheckRequest request = request_of(flags);
  if (request.readings && request.history) check_folder_of(*request.history);
  if (flags.export_csv) {
    check_may_write(*flags.export_csv, context.overwrite);
    require_no_input(*flags.export_csv, std::vector<InputRecord>{{*request.history, ""}});
  }
  InputFiles files(context.monitor);
  const CheckSummary summary = run_check(files, request, flags.table.options());
  if (flags.export_csv)
    context.save(*flags.export_csv, history_as_table(*request.history), files.records());
  context.emit(files.records(), files.diagnostics(), json_result(summary), text_result(summary));
  const bool failed = summary.check && summary.check->verdict() == Verdict::fail;
  return failed ? kDoesNotConform : kDone;
}

std::vector<Argument> arguments_of(CheckFlags& flags) {
  InterimCheckOptions& options = flags.request.options;
  CheckLimits& limits = options.limits;
  const auto positive = NumberRange::positive;
  return {
      {"READINGS.csv", "joint angles (q1_deg..) or coordinates (x_mm..); - for standard input",
       &flags.request.readings},
      {"--arm", "arm file that turns joint angles into tips", &flags.request.arm, "ARM"},
      {"--diameter", "the points are of spheres of this certified diameter, mm",
       &options.diameter_mm, "MM", positive},
      {"--tip-diameter", "diameter of the probe's ball, mm, taken off with --diameter",
       &flags.tip_diameter_mm, "MM", NumberRange::not_negative},
      {"--length", "certified distance of the two seats or spheres, mm", &options.length_mm, "MM",
       positive},
      {"--limit", "largest allowed deviation in a seat, or diameter error of a sphere, mm",
       &flags.limit_mm, "MM", positive},
      {"--two-s-limit", "largest allowed 2 s in a seat, mm", &limits.twice_s_mm, "MM", positive},
      {"--half-range-limit", "largest allowed half range of each axis in a seat, mm",
       &limits.half_range_mm, "MM", positive},
      {"--form-limit", "largest allowed form error of a sphere, mm", &limits.form_mm, "MM",
       positive},
      {"--length-limit", "largest allowed length error, mm", &limits.length_mm, "MM", positive},
      {"--history", "save the check here (made where it does not exist); alone: show the trend",
       &flags.request.history, "FILE"},
      {"--arm-name", "name or serial number of the arm; that of the arm file if not given",
       &flags.request.arm_name, "TEXT"},
      {"--artefact", "what was measured, and where it stands", &flags.request.artefact, "TEXT"},
      {"--temperature", "of the room, deg C", &flags.request.temperature_c, "C"},
      {"--note", "anything worth knowing later", &flags.note, "TEXT"},
      {"--time", "when it was measured (ISO 8601; now if not given)", &flags.time, "TIME"},
      {"--baseline", "first checks that the centre line comes from; 10 if not given",
       &flags.baseline, "COUNT", NumberRange::count},
      {"--export", "write the whole history as a table here", &flags.export_csv, "CSV"}};
}

}  // namespace

Command check_command() {
  const auto flags = std::make_shared<CheckFlags>();
  Command command;
  command.name = "check";
  command.brief = "five-minute check between calibrations, with a history and its trend";
  command.description =
      "A cone or seat touched in many postures, or a sphere; with two of them (column point) also "
      "the length between.\n"
      "With --history the check is kept, and all checks of this arm with this artefact are judged "
      "by a control chart.\n"
      "Exit code 1 where a limit is exceeded; broken rules and drift are warnings.";
  command.arguments =
      joined(joined(arguments_of(*flags), flags->table.for_angles()), flags->table.for_suspects());
  command.examples = {
      "armcal check examples/check/week-12.csv --arm examples/arms/seven-joint.arm.toml "
      "--length 400 --limit 0.10 --length-limit 0.08",
      "armcal check examples/sphere/five-articulations.csv --arm "
      "examples/arms/romer-infinite-2.0.arm.toml --diameter 15.8754 --tip-diameter 6"};
  command.run = [flags](const Context& context) { return run_check_command(*flags, context); };
  return command;
}

}  // namespace armcal::cli
