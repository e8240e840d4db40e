// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/half_turn_plan_job.h"

#include <fmt/format.h>

#include "armcal/io/csv_text.h"

namespace armcal {

HalfTurnPlan run_half_turn_plan(InputFiles& files, const std::string& arm_path,
                                const HalfTurnWishes& wishes) {
  const auto arm = files.arm(arm_path);
  files.require_good();
  HalfTurnPlan plan = plan_half_turns(*arm, wishes, files.monitor());
  const int usual = 4 * arm->joint_count() - 3;
  if (plan.rank() < usual) {
    files.diagnostics().warning(
        {arm_path, 0, 0},
        fmt::format("half turns determine {} parameters of this arm, not the usual {}: as drawn, "
                    "some move no distance to first order (its tip lies on the last axis, say)",
                    plan.rank(), usual),
        "their errors come on top of what is predicted; a longer stylus off that axis shows them");
  }
  return plan;
}

std::string readings_path(const std::string& procedure_path) {
  std::string stem = procedure_path;
  for (const std::string ending : {".toml", ".symmetric"}) {
    if (stem.ends_with(ending)) stem.resize(stem.size() - ending.size());
  }
  return stem + ".csv";
}

SymmetricPointProcedure planned_procedure(const HalfTurnPlan& plan,
                                          const std::string& procedure_path,
                                          const std::string& arm_path) {
  SymmetricPointProcedure procedure = procedure_of(plan);
  procedure.file = procedure_path;
  procedure.arm_file = arm_path;
  for (SymmetricReading& reading : procedure.readings) {
    reading.raw = RawSymmetricPoints{};
    reading.raw->file = readings_path(procedure_path);
  }
  return procedure;
}

std::string readings_form(const HalfTurnPlan& plan) {
  const Eigen::Index joints = plan.arm.joint_count();
  std::string text = "reading,end,repeat,x_mm,y_mm,z_mm," + angle_header(joints) + "\n";
  const std::string blanks(static_cast<std::size_t>(2 + joints), ',');
  for (const PlannedReading& reading : plan.readings) {
    for (const char end : {'A', 'B'}) {
      for (int repeat = 1; repeat <= plan.wishes.repeats; ++repeat) {
        text += fmt::format("{},{},{},{}\n", text_field(reading.name), end, repeat, blanks);
      }
    }
  }
  return text;
}

}  // namespace armcal
