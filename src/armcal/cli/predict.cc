// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/workflow/prediction_job.h"

namespace armcal::cli {
namespace {

struct PredictFlags {
  std::string calibration;
  std::string angles;
  std::optional<std::string> output;
  TableFlags table;
};

int run_predict(const PredictFlags& flags, const Context& context) {
  if (flags.output) check_may_write(*flags.output, context.overwrite);
  InputFiles files(context.monitor);
  const PredictedTips predicted =
      predict_tips(files, flags.calibration, flags.angles, flags.table.options());
  std::string text = predicted_csv(predicted);
  if (flags.output) {
    context.save(*flags.output, text, files.records());
    text.clear();
  }
  Json json;
  json["calibration"] = flags.calibration;
  json["count"] = predicted.tips_mm.cols();
  json["tips_mm"] = json_of(Eigen::MatrixXd(predicted.tips_mm.transpose()));
  json["u_mm"] = json_of(Eigen::MatrixXd(predicted.u_mm.transpose()));
  context.emit(files.records(), files.diagnostics(), json, text);
  return kDone;
}

}  // namespace

Command predict_command() {
  const auto flags = std::make_shared<PredictFlags>();
  Command command;
  command.name = "predict";
  command.brief = "tip coordinates with standard uncertainties, from a saved calibration";
  command.description =
      "Reads what armcal calibrate --save wrote and joint angles; prints "
      "x_mm,y_mm,z_mm,u_x_mm,u_y_mm,u_z_mm, one row\n"
      "each. The uncertainties are those that the calibrated parameters bring, not the scatter of "
      "a single reading.";
  command.arguments =
      joined({{"CALIBRATION", "saved calibration (JSON)", &flags->calibration},
              {"ANGLES.csv", "table of joint angles; - for standard input", &flags->angles},
              {"-o,--output", "write the table here instead of to standard output", &flags->output,
               "FILE"}},
             flags->table.for_angles());
  command.examples = {
      "armcal predict examples/calibration/tracker.calibration.json "
      "examples/angles/six-joints.csv"};
  command.run = [flags](const Context& context) { return run_predict(*flags, context); };
  return command;
}

}  // namespace armcal::cli
