// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/circle_points.h"

#include "armcal/comparison/methods/registry.h"
#include "armcal/core/diagnostics.h"
#include "armcal/simulation/instruments/joint_arcs.h"

namespace armcal {
namespace {

TakenReadings take(const Bench& bench) {
  Laboratory laboratory = bench.laboratory();
  const auto groups =
      measure(laboratory, JointArcs{.points = bench.readings / bench.arm.nominal().joint_count(),
                                    .u_mm = bench.u_reference_mm});
  const ObservationGroup& arcs = groups.front();
  return {static_cast<int>(arcs.count()), [nominal = bench.arm.nominal(), arcs] {
            const CirclePointAnalysis analysis = analyse_circle_points(nominal, arcs);
            if (!analysis.ok()) {
              throw NumericalError(analysis.detail.empty() ? std::string(explain(analysis.status))
                                                           : analysis.detail);
            }
            return FoundArm{.arm = analysis.arm};
          }};
}

}  // namespace

std::vector<Method> circle_point_methods() {
  return {{.name = "circle-points",
           .title = "circle-point analysis",
           .reference = "Vorotnikov et al. 2016",
           .needs = "a reference CMM or tracker",
           .take = take}};
}

}  // namespace armcal
