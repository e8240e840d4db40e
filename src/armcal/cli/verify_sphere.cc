// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/table_flags.h"
#include "armcal/cli/verify_commands.h"
#include "armcal/report/sphere_test_report.h"
#include "armcal/workflow/sphere_job.h"

namespace armcal::cli {
namespace {

struct SphereFlags {
  std::string readings;
  std::optional<std::string> arm;
  std::optional<double> diameter_mm;
  std::optional<double> tip_diameter_mm;
  std::optional<double> diameter_limit_mm;
  std::optional<double> form_limit_mm;
  TableFlags table;
};

int run_sphere(const SphereFlags& flags, const Context& context) {
  const SphereTestOptions options{flags.diameter_mm.value_or(0.0),
                                  flags.tip_diameter_mm.value_or(0.0), flags.diameter_limit_mm,
                                  flags.form_limit_mm};
  InputFiles files(context.monitor);
  const SphereTest test =
      run_sphere_test(files, flags.readings, flags.arm, options, flags.table.options());
  Json json = json_result(test, options);
  json["arm"] = flags.arm ? Json(*flags.arm) : Json(nullptr);
  context.emit(files.records(), files.diagnostics(), json, text_result(test, options));
  return test.verdict() == Verdict::fail ? kDoesNotConform : kDone;
}

}  // namespace

Command verify_sphere_command() {
  const auto flags = std::make_shared<SphereFlags>();
  Command command;
  command.name = "sphere";
  command.brief = "points on a sphere of certified diameter: diameter and form error";
  command.description =
      "With --arm the table holds joint angles, which are put through that arm; without it, "
      "coordinates. Limits are\n"
      "optional and compared with the values as they are. Exit code 1 where one is exceeded.";
  command.arguments = joined(
      joined(
          {{"READINGS.csv", "joint angles (q1_deg..) or coordinates (x_mm..); - for standard input",
            &flags->readings},
           {"--diameter",
            "certified diameter of the sphere, mm",
            &flags->diameter_mm,
            "MM",
            NumberRange::positive,
            {},
            true},
           {"--arm", "arm file that turns joint angles into tips", &flags->arm, "ARM"},
           {"--tip-diameter", "diameter of the probe's ball, mm, to be taken off (outside contact)",
            &flags->tip_diameter_mm, "MM", NumberRange::not_negative},
           {"--limit", "largest allowed diameter error, mm", &flags->diameter_limit_mm, "MM",
            NumberRange::positive},
           {"--form-limit", "largest allowed form error, mm", &flags->form_limit_mm, "MM",
            NumberRange::positive}},
          flags->table.for_angles()),
      flags->table.for_suspects());
  command.examples = {
      "armcal verify sphere examples/sphere/five-articulations.csv --arm "
      "examples/arms/romer-infinite-2.0.arm.toml --diameter 15.8754 --tip-diameter 6",
      "armcal verify sphere examples/sphere/still-wrist.csv --arm "
      "examples/arms/romer-infinite-2.0-as-printed.arm.toml --diameter 15.8754 --limit 0.15 "
      "--form-limit 0.05"};
  command.run = [flags](const Context& context) { return run_sphere(*flags, context); };
  return command;
}

}  // namespace armcal::cli
