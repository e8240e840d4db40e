// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/symmetric_readings.h"
#include "armcal/comparison/wang2016_evaluation.h"
#include "armcal/simulation/symmetric_procedure.h"

namespace armcal {
namespace {

const char* const kPaper = "Wang, Wang, Lu, Zhang 2016";
const char* const kNeedsOfPaper = "a reference CMM, clamps for the joints";

TakenReadings take(const Bench& bench, FoundArm (*evaluate)(const SymmetricPointAnalysis&)) {
  constexpr int kJoints = 6;
  const int joints = bench.arm.nominal().joint_count();
  if (joints != kJoints)
    throw Impossible(fmt::format("the procedure is for six joints, this arm has {}", joints));
  Laboratory laboratory = bench.laboratory();
  SymmetricPointProcedure procedure =
      carry_out(laboratory, wang2016_procedure(), {.u_point_mm = bench.u_reference_mm});
  procedure.u_encoder_rad = bench.u_encoder_rad();
  return {count_readings(procedure),
          [nominal = bench.arm.nominal(), procedure = std::move(procedure), evaluate] {
            return evaluate(analysed(procedure, nominal));
          }};
}

Method method(const std::string& name, const std::string& title,
              FoundArm (*evaluate)(const SymmetricPointAnalysis&)) {
  return {.name = name,
          .title = title,
          .reference = kPaper,
          .needs = kNeedsOfPaper,
          .take = [=](const Bench& bench) { return take(bench, evaluate); }};
}

}  // namespace

std::vector<Method> paper_methods() {
  return {method("paper-as-printed", "symmetric points, as printed", wang2016_as_printed),
          method("paper-chain", "symmetric points, consistent chain", wang2016_chain),
          method("paper-adjusted", "symmetric points, adjusted", wang2016_adjusted)};
}

}  // namespace armcal
