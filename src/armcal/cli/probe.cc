// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/core/units.h"
#include "armcal/io/arm_file.h"
#include "armcal/report/probe_report.h"
#include "armcal/workflow/probe_job.h"

namespace armcal::cli {
namespace {

struct ProbeFlags {
  ProbeRequest request;
  std::optional<double> u_mm, u_encoder_arcsec, tip_diameter_mm, limit_mm;
  std::optional<std::string> output;
  TableFlags table;
};

// What the readings were said to be.
Json json_of_stated(const ProbeRequest& request) {
  return {{"sphere_diameter_mm",
           request.sphere_diameter_mm ? Json(*request.sphere_diameter_mm) : Json(nullptr)},
          {"tip_diameter_mm", request.tip_diameter_mm},
          {"u_mm", request.u_mm},
          {"u_encoder_arcsec", arcseconds_from_radians(request.u_encoder_rad)}};
}

int run_probe_command(const ProbeFlags& flags, const Context& context) {
  if (flags.output) check_may_write(*flags.output, context.overwrite);
  ProbeRequest request = flags.request;
  request.u_mm = flags.u_mm.value_or(request.u_mm);
  request.u_encoder_rad = radians_from_arcseconds(flags.u_encoder_arcsec.value_or(0.0));
  request.tip_diameter_mm = flags.tip_diameter_mm.value_or(0.0);
  InputFiles files(context.monitor);
  const StylusQualification stylus = run_probe(files, request, flags.table.options());
  Json json = json_result(stylus, flags.limit_mm);
  json["stated"] = json_of_stated(request);
  if (flags.output) context.save(*flags.output, arm_text(stylus.calibration.arm), files.records());
  context.emit(files.records(), files.diagnostics(), json, text_result(stylus, flags.limit_mm));
  return verdict_of(stylus, flags.limit_mm) == Verdict::fail ? kDoesNotConform : kDone;
}

}  // namespace

Command probe_command() {
  const auto flags = std::make_shared<ProbeFlags>();
  Command command;
  command.name = "probe";
  command.brief = "the tip of an arm alone, for a new stylus: from a cone or a sphere";
  command.description =
      "Reads joint angles with the new stylus in one cone or seat (or, with --sphere-diameter, on "
      "a sphere) in many\n"
      "postures, and finds the tip; everything else of the arm stays. Exit code 1 where its "
      "uncertainty exceeds --limit.";
  command.arguments = joined(
      {{"ARM", "arm file (*.arm.toml)", &flags->request.arm},
       {"READINGS.csv", "table of joint angles; - for standard input", &flags->request.readings},
       {"--sphere-diameter", "the points lie on a sphere of this certified diameter, mm",
        &flags->request.sphere_diameter_mm, "MM", NumberRange::positive},
       {"--tip-diameter", "diameter of the stylus ball, mm, with --sphere-diameter",
        &flags->tip_diameter_mm, "MM", NumberRange::not_negative},
       {"--u", "standard uncertainty of a tip in the seat, mm; 0.02 if not given", &flags->u_mm,
        "MM", NumberRange::positive},
       {"--u-encoder-arcsec", "standard uncertainty of each encoder, arcsec, beside --u",
        &flags->u_encoder_arcsec, "ARCSEC", NumberRange::not_negative},
       {"--limit", "largest allowed expanded uncertainty of the tip (k = 2), mm", &flags->limit_mm,
        "MM", NumberRange::positive},
       {"-o,--output", "write the arm with its new tip here", &flags->output, "ARM"}},
      flags->table.for_angles());
  command.examples = {
      "armcal probe examples/arms/romer-infinite-2.0.arm.toml "
      "examples/sphere/five-articulations.csv "
      "--sphere-diameter 15.8754 --tip-diameter 6"};
  command.run = [flags](const Context& context) { return run_probe_command(*flags, context); };
  return command;
}

}  // namespace armcal::cli
