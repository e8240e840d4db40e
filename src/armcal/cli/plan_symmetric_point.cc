// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/plan_commands.h"
#include "armcal/cli/room_flags.h"
#include "armcal/cli/table_flags.h"
#include "armcal/core/units.h"
#include "armcal/io/symmetric_point_writer.h"
#include "armcal/report/half_turn_plan_report.h"
#include "armcal/workflow/half_turn_plan_job.h"

namespace armcal::cli {
namespace {

struct HalfTurnFlags {
  std::string arm;
  std::optional<double> readings, candidates, starts, seed, threads, repeats;
  std::optional<std::string> grid, joints;
  RoomFlags room;
  std::optional<double> u_mm, u_encoder_arcsec, min_redundancy, detect_mm;
  std::optional<std::string> worksheet, output;
};

HalfTurnRoom room_of(const HalfTurnFlags& flags) {
  HalfTurnRoom room;
  const std::string grid = flags.grid.value_or("45");
  room.grid_rad = grid == "free" ? 0.0 : radians_from_degrees(grid == "90" ? 90.0 : 45.0);
  if (flags.joints) {
    for (const double joint : numbers_of("--joints", *flags.joints)) {
      if (joint != std::floor(joint) || joint < 1.0 || joint > kMaxJoints) {
        throw std::invalid_argument(
            fmt::format("--joints {}: {} is no joint; they count from 1", *flags.joints, joint));
      }
      room.joints.push_back(static_cast<int>(joint));
    }
  }
  room.volume = flags.room.measuring_volume();
  room.surroundings = flags.room.surroundings();
  return room;
}

HalfTurnWishes wishes_of(const HalfTurnFlags& flags) {
  HalfTurnWishes wishes;
  wishes.readings = count_or(flags.readings, wishes.readings);
  wishes.room = room_of(flags);
  wishes.candidates = count_or(flags.candidates, wishes.candidates);
  wishes.u_mm = flags.u_mm.value_or(wishes.u_mm);
  if (flags.u_encoder_arcsec) {
    wishes.u_encoder_rad = radians_from_arcseconds(*flags.u_encoder_arcsec);
  }
  wishes.repeats = count_or(flags.repeats, wishes.repeats);
  wishes.least_redundancy = flags.min_redundancy.value_or(wishes.least_redundancy);
  wishes.largest_unnamed_mm = flags.detect_mm.value_or(wishes.largest_unnamed_mm);
  wishes.starts = count_or(flags.starts, wishes.starts);
  wishes.seed = seed_or(flags.seed, 1);
  wishes.threads = threads_of(flags.threads);
  return wishes;
}

int run_half_turns(const HalfTurnFlags& flags, const Context& context) {
  std::vector<std::string> outputs;
  if (flags.output) outputs = {*flags.output, readings_path(*flags.output)};
  if (flags.worksheet) outputs.push_back(*flags.worksheet);
  for (const std::string& path : outputs) check_may_write(path, context.overwrite);
  InputFiles files(context.monitor);
  const HalfTurnPlan plan = run_half_turn_plan(files, flags.arm, wishes_of(flags));
  if (flags.output) {
    const auto procedure = planned_procedure(plan, *flags.output, flags.arm);
    context.save(*flags.output, symmetric_point_text(procedure, "Half turns of " + plan.arm.name),
                 files.records());
    context.save(readings_path(*flags.output), readings_form(plan), files.records());
  }
  if (flags.worksheet) {
    const bool markdown = flags.worksheet->ends_with(".md");
    context.save(*flags.worksheet, markdown ? worksheet_markdown(plan) : worksheet_csv(plan),
                 files.records());
  }
  context.emit(files.records(), files.diagnostics(), json_result(plan), text_result(plan));
  return kDone;
}

std::vector<Argument> flags_of_room(HalfTurnFlags& flags) {
  const std::vector<Argument> choice = {
      {"--grid",
       "posture angles: multiples of 90 or 45 deg, or free (default 45)",
       &flags.grid,
       "GRID",
       NumberRange::any,
       {"90", "45", "free"}},
      {"--joints", "joints that may be turned: 1,3,5 (default: all)", &flags.joints, "LIST"}};
  return joined(
      choice,
      flags.room.arguments("box of the reference machine in the base frame, mm: both tips of every "
                           "half turn lie inside (default: no limit)"));
}

std::vector<Argument> flags_of_readings(HalfTurnFlags& flags) {
  return {{"--u-mm", "standard uncertainty of a distance (default 0.005)", &flags.u_mm, "MM",
           NumberRange::positive},
          {"--u-encoder-arcsec", "standard uncertainty of one reading of one encoder (default 2)",
           &flags.u_encoder_arcsec, "ARCSEC", NumberRange::not_negative},
          {"--repeats", "readings of the encoders at each end, averaged (default 5)",
           &flags.repeats, "N", NumberRange::count},
          {"--min-redundancy", "least redundancy number of every reading (default 0.1)",
           &flags.min_redundancy, "SHARE", NumberRange::not_negative},
          {"--detect-mm", "an error of this size in any one reading must be found and named",
           &flags.detect_mm, "MM", NumberRange::positive}};
}

}  // namespace

Command plan_symmetric_point_command() {
  const auto flags = std::make_shared<HalfTurnFlags>();
  Command command;
  command.name = "symmetric-point";
  command.brief = "half turns that determine the whole arm, and a worksheet to read them by";
  command.description =
      "Chooses postures and joints for half turns of locked arms, so that the distances between "
      "the tip's two places\n"
      "determine all that an arm's lengths can tell (D-optimal exchange), orders them so that few "
      "joints are set between\n"
      "readings, and predicts rank, uncertainties, redundancy and length error.";
  command.arguments = joined(
      joined(joined({{"ARM", "arm file (*.arm.toml), with joint limits", &flags->arm},
                     {"--readings", "half turns to be read (default 40)", &flags->readings, "N",
                      NumberRange::count}},
                    flags_of_room(*flags)),
             flags_of_readings(*flags)),
      {{"--candidates", "half turns to choose from (default 4000)", &flags->candidates, "N",
        NumberRange::count},
       {"--starts", "random starts of the exchange (default 8)", &flags->starts, "N",
        NumberRange::count},
       {"--seed", "of chance (default 1)", &flags->seed, "N", NumberRange::seed},
       {"--threads", "never changes a digit (default: all cores)", &flags->threads, "N",
        NumberRange::count},
       {"--worksheet", "write the worksheet here, as Markdown (.md) or CSV", &flags->worksheet,
        "FILE"},
       {"-o,--output",
        "write the procedure (*.symmetric.toml) here, and beside it the table to be filled in",
        &flags->output, "FILE"}});
  command.examples = {
      "armcal plan symmetric-point examples/arms/romer-infinite-2.0.arm.toml --readings 40",
      "armcal plan symmetric-point examples/arms/romer-infinite-2.0.arm.toml --readings 30 --grid "
      "90 --worksheet worksheet.md -o half-turns.symmetric.toml"};
  command.run = [flags](const Context& context) { return run_half_turns(*flags, context); };
  return command;
}

}  // namespace armcal::cli
