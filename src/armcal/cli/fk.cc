// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/workflow/forward_kinematics_job.h"

namespace armcal::cli {
namespace {

struct FkFlags {
  std::string arm;
  std::string angles;
  std::optional<std::string> output;
  TableFlags table;
};

Json json_of_tips(const FkFlags& flags, const Eigen::Matrix3Xd& tips) {
  Json json;
  json["arm"] = flags.arm;
  json["count"] = tips.cols();
  json["tips_mm"] = json_of(Eigen::MatrixXd(tips.transpose()));
  return json;
}

int run_fk(const FkFlags& flags, const Context& context) {
  if (flags.output) check_may_write(*flags.output, context.overwrite);
  InputFiles files(context.monitor);
  const Eigen::Matrix3Xd tips = compute_tips(files, flags.arm, flags.angles, flags.table.options());
  std::string text = context.json && !flags.output ? "" : tips_csv(tips);
  if (flags.output) {
    context.save(*flags.output, text, files.records());
    text.clear();
  }
  context.emit(files.records(), files.diagnostics(),
               context.wants_document() ? json_of_tips(flags, tips) : Json(), text);
  return kDone;
}

}  // namespace

Command fk_command() {
  const auto flags = std::make_shared<FkFlags>();
  Command command;
  command.name = "fk";
  command.brief = "tip coordinates for joint angles";
  command.description =
      "Reads joint angles (columns q1_deg.. or q1_rad..) and prints x_mm,y_mm,z_mm in the base "
      "frame, one row each.";
  command.arguments =
      joined({{"ARM", "arm file (*.arm.toml)", &flags->arm},
              {"ANGLES.csv", "table of joint angles; - for standard input", &flags->angles},
              {"-o,--output", "write the table here instead of to standard output", &flags->output,
               "FILE"}},
             flags->table.for_angles());
  command.examples = {
      "armcal fk examples/arms/ur10.arm.toml examples/angles/six-joints.csv",
      "armcal fk examples/arms/ur10.arm.toml examples/angles/six-joints.csv --json -o tips.csv",
      "armcal fk examples/arms/panda.arm.toml examples/angles/seven-joints-german.csv "
      "--map q1_rad=A1,q2_rad=A2,q3_rad=A3,q4_rad=A4,q5_rad=A5,q6_rad=A6,q7_rad=A7"};
  command.run = [flags](const Context& context) { return run_fk(*flags, context); };
  return command;
}

}  // namespace armcal::cli
