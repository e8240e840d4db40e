// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/plan_commands.h"
#include "armcal/cli/room_flags.h"
#include "armcal/cli/table_flags.h"
#include "armcal/report/verification_plan_picture.h"
#include "armcal/report/verification_plan_report.h"
#include "armcal/report/verification_worksheet.h"
#include "armcal/workflow/verification_plan_job.h"

namespace armcal::cli {
namespace {

struct VerificationFlags {
  std::string arm;
  std::optional<std::string> standard, lengths, bars;
  std::optional<double> reach_mm, sphere_diameter_mm, tip_diameter_mm, seed;
  RoomFlags room;
  std::optional<std::string> worksheet, picture;
};

std::array<double, 2> bars_of(const VerificationFlags& flags) {
  if (!flags.bars) return {};
  const std::vector<double> bars = numbers_of("--bars", *flags.bars);
  if (bars.size() != 2 || bars[0] <= 0.0 || bars[0] >= bars[1]) {
    throw std::invalid_argument(fmt::format(
        "--bars {}: expected two lengths in mm, the first one smaller and above 0", *flags.bars));
  }
  return {bars[0], bars[1]};
}

VerificationPlanWishes wishes_of(const VerificationFlags& flags) {
  VerificationPlanWishes wishes;
  wishes.iso10360_12 = flags.standard.value_or("both") != "b89.4.22";
  wishes.b89_4_22 = flags.standard.value_or("both") != "iso10360-12";
  wishes.room = {flags.room.surroundings(), flags.room.measuring_volume()};
  wishes.reach_mm = flags.reach_mm;
  wishes.sphere_diameter_mm = flags.sphere_diameter_mm.value_or(wishes.sphere_diameter_mm);
  wishes.tip_diameter_mm = flags.tip_diameter_mm.value_or(wishes.tip_diameter_mm);
  if (flags.lengths) wishes.lengths_mm = numbers_of("--lengths", *flags.lengths);
  wishes.bars_mm = bars_of(flags);
  wishes.seed = seed_or(flags.seed, wishes.seed);
  return wishes;
}

int run_verification(const VerificationFlags& flags, const Context& context) {
  for (const auto* path : {&flags.worksheet, &flags.picture}) {
    if (*path) check_may_write(**path, context.overwrite);
  }
  InputFiles files(context.monitor);
  const VerificationPlan plan = run_verification_plan(files, flags.arm, wishes_of(flags));
  if (flags.worksheet) {
    const bool markdown = flags.worksheet->ends_with(".md");
    context.save(*flags.worksheet, markdown ? worksheet_markdown(plan) : worksheet_csv(plan),
                 files.records());
  }
  if (flags.picture) context.save(*flags.picture, verification_picture(plan), files.records());
  context.emit(files.records(), files.diagnostics(), json_result(plan), text_result(plan),
               plan.wishes.seed);
  return kDone;
}

std::vector<Argument> flags_of_artefacts(VerificationFlags& flags) {
  return {
      {"--standard",
       "whose tests (default: both)",
       &flags.standard,
       "NAME",
       NumberRange::any,
       {"iso10360-12", "b89.4.22", "both"}},
      {"--reach",
       "of the arm as its maker states it, mm: zones and lengths are shares of it (default: all "
       "links and the tip stretched out)",
       &flags.reach_mm, "MM", NumberRange::positive},
      {"--sphere-diameter", "of the test sphere, mm (default 25)", &flags.sphere_diameter_mm, "MM",
       NumberRange::positive},
      {"--tip-diameter", "of the ball of the stylus, mm (default 6)", &flags.tip_diameter_mm, "MM",
       NumberRange::positive},
      {"--lengths",
       "calibrated lengths of ISO 10360-12, rising, mm (default: fifths of 66 % of the reach)",
       &flags.lengths, "MM,MM,.."},
      {"--bars", "short and long bar of B89.4.22, mm (default: about 60 and 120 % of the reach)",
       &flags.bars, "MM,MM"}};
}

}  // namespace

Command plan_verification_command() {
  const auto flags = std::make_shared<VerificationFlags>();
  Command command;
  command.name = "verification";
  command.brief = "where to put spheres, seats and bars to verify an arm, and how to stand at them";
  command.description =
      "Finds places for the artefacts of ISO 10360-12 and ASME B89.4.22 within reach, clear of "
      "bench "
      "and column, and for every\n"
      "point a posture within the joint limits with the stylus on the free side; postures differ "
      "as "
      "much as can be. Says what\n"
      "is covered: zones, directions, and how much of the range of every joint.";
  command.arguments =
      joined(joined(joined({{"ARM", "arm file (*.arm.toml), with joint limits", &flags->arm}},
                           flags_of_artefacts(*flags)),
                    flags->room.arguments("box in the base frame, mm: every point lies inside "
                                          "(default: no limit)")),
             {{"--seed", "of chance (default 1)", &flags->seed, "N", NumberRange::seed},
              {"--worksheet",
               "write all postures here: Markdown (.md), or CSV to be filled in for armcal verify",
               &flags->worksheet, "FILE"},
              {"--picture", "write a drawing here, as SVG", &flags->picture, "FILE"}});
  command.examples = {
      "armcal plan verification examples/arms/seven-joint.arm.toml --bench -200 --column-radius 60",
      "armcal plan verification examples/arms/romer-infinite-2.0.arm.toml --standard b89.4.22 "
      "--worksheet verification.csv --picture verification.svg"};
  command.run = [flags](const Context& context) { return run_verification(*flags, context); };
  return command;
}

}  // namespace armcal::cli
