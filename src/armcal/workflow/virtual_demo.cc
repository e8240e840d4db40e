// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/virtual_demo.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/report/calibration_report.h"
#include "armcal/report/calibration_rows.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"
#include "armcal/workflow/calibration_job.h"
#include "armcal/workflow/input_files.h"
#include "armcal/workflow/simulation_job.h"
#include "armcal/workflow/truth_check.h"

namespace armcal {
namespace {

constexpr int kDecimals = 4;

// One way to calibrate the arm: the readings that it has.
struct Kit {
  const char* name;
  std::vector<std::string> groups;
};

struct Attempt {
  std::string name;
  Eigen::Index readings = 0;
  Calibration calibration;
  TruthCheck truth;
  IntervalCount intervals;
};

std::vector<ObservationGroup> chosen(const Simulation& simulation, const Kit& kit) {
  std::vector<ObservationGroup> groups;
  for (const ObservationGroup& group : simulation.groups) {
    const bool wanted =
        std::find(kit.groups.begin(), kit.groups.end(), group.name) != kit.groups.end();
    if (wanted) groups.push_back(group);
  }
  return groups;
}

Attempt attempt(const Simulation& simulation, const Kit& kit, bool allow_rank_deficient) {
  Attempt result;
  result.name = kit.name;
  const std::vector<ObservationGroup> groups = chosen(simulation, kit);
  for (const ObservationGroup& group : groups) {
    if (group.kind != ReferenceKind::length) result.readings += group.count();
  }
  result.calibration =
      calibrate(simulation.nominal, groups, {.allow_rank_deficient = allow_rank_deficient});
  if (!result.calibration.ok()) {
    throw NumericalError(fmt::format("{}: {}", kit.name, explain(result.calibration.status)));
  }
  result.truth = check_against_truth(result.calibration.arm, simulation);
  result.intervals = count_intervals(result.calibration, simulation.truth);
  return result;
}

double micrometres_per_metre(double ratio) { return ratio * 1e6; }

std::string kits_text(const Simulation& simulation) {
  std::vector<std::string> parts;
  for (const ObservationGroup& group : simulation.groups) {
    parts.push_back(fmt::format("  {:<12} {:<18} {:>4} rows\n", group.name, to_string(group.kind),
                                group.count()));
  }
  return fmt::format("{}", fmt::join(parts, ""));
}

std::string result_text(const TruthCheck& drawing, const std::vector<Attempt>& attempts) {
  TextTable table({{"calibrated with", Align::left},
                   {"readings"},
                   {"error rms mm"},
                   {"max mm"},
                   {"over floor"},
                   {"scale um/m"},
                   {"within 95 %"},
                   {"sigma0"}});
  const auto add = [&](const std::string& name, const TruthCheck& truth,
                       const std::string& readings, const std::string& intervals,
                       const std::string& sigma0) {
    table.add_row({name, readings, fixed(truth.rms_mm, kDecimals), fixed(truth.max_mm, kDecimals),
                   fixed(truth.ratio(), 2), fixed(micrometres_per_metre(truth.scale), 1), intervals,
                   sigma0});
  };
  add("nothing: the drawing", drawing, "0", "", "");
  for (const Attempt& each : attempts) {
    add(each.name, each.truth, std::to_string(each.readings),
        fmt::format("{} of {}", each.intervals.inside, each.intervals.count),
        fixed(each.calibration.sigma0, 3));
  }
  return table.text();
}

Json json_of(const TruthCheck& truth) {
  return {{"rms_mm", truth.rms_mm},
          {"max_mm", truth.max_mm},
          {"ratio_to_floor", truth.ratio()},
          {"scale_um_per_m", micrometres_per_metre(truth.scale)}};
}

Json json_of(const Attempt& attempt) {
  Json json = json_of(attempt.truth);
  json["name"] = attempt.name;
  json["readings"] = attempt.readings;
  json["intervals"] = {{"inside", attempt.intervals.inside}, {"count", attempt.intervals.count}};
  json["sigma0"] = attempt.calibration.sigma0;
  return json;
}

// How the cone is blind: what it reads of the arm as calibrated, and of the same arm grown.
struct Blindness {
  std::string refusal;
  double rms_mm = 0.0;
  double rms_grown_mm = 0.0;
};

constexpr double kGrowth = 1e-3;

ArmModel grown(const ArmModel& arm) {
  const ParameterTable table(arm);
  Eigen::VectorXd values = parameter_values(arm);
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].unit == ParameterUnit::mm) values(i) *= 1.0 + kGrowth;
  }
  return with_parameter_values(arm, values);
}

// Scatter of the tips that an arm says were all in one place.
double scatter_mm(const ArmModel& arm, const ObservationGroup& cone) {
  const ForwardKinematics kinematics(arm);
  Eigen::Matrix3Xd tips_mm(3, cone.count());
  for (Eigen::Index i = 0; i < cone.count(); ++i) {
    tips_mm.col(i) = kinematics.tip_in_base(as_span(cone.encoder_rad.col(i)));
  }
  const Eigen::Vector3d mean_mm = tips_mm.rowwise().mean();
  return (tips_mm.colwise() - mean_mm).norm() / std::sqrt(static_cast<double>(cone.count()));
}

Blindness blindness_of(const Simulation& simulation, const Kit& cone, const Attempt& forced) {
  const auto groups = chosen(simulation, cone);
  Blindness result;
  result.refusal = explain(calibrate(simulation.nominal, groups, {}).status);
  result.rms_mm = scatter_mm(forced.calibration.arm, groups.front());
  result.rms_grown_mm = scatter_mm(grown(forced.calibration.arm), groups.front());
  return result;
}

std::string blindness_text(const Blindness& blindness, const Attempt& cone, const Attempt& kit) {
  return fmt::format(
      "  - armcal calibrate refuses the cone alone: {}.\n"
      "  - By that calibration the tips in the cone scatter by {} mm rms; with every length larger "
      "by one in a thousand, by {} mm.\n"
      "  - Told to go on, it holds one length as drawn: wrong by {} um/m everywhere, of which its "
      "intervals know nothing.\n  - With the bar it is {} um/m.\n",
      blindness.refusal, fixed(blindness.rms_mm, 5), fixed(blindness.rms_grown_mm, 5),
      fixed(micrometres_per_metre(cone.truth.scale), 1),
      fixed(micrometres_per_metre(kit.truth.scale), 1));
}

}  // namespace

VirtualDemo run_virtual_demo() {
  InputFiles files({}, FileSource::embedded);
  const LoadedScenario loaded = load_scenario(files, built_in_scenario("demo").path);
  const Simulation simulation = simulate(loaded, loaded.scenario.seed);
  const Kit cone{"cone", {"cone"}};
  const Kit cone_and_bar{"cone and bar", {"cone", "bar", "bar-length"}};
  const Kit cmm{"reference CMM", {"cmm"}};
  const TruthCheck drawing = check_against_truth(simulation.nominal, simulation);
  const std::vector<Attempt> attempts = {attempt(simulation, cone, true),
                                         attempt(simulation, cone_and_bar, false),
                                         attempt(simulation, cmm, false)};
  const Blindness blindness = blindness_of(simulation, cone, attempts[0]);

  VirtualDemo demo;
  demo.seed = simulation.seed;
  demo.inputs = files.records();
  demo.text = fmt::format(
      "A virtual arm: {}\nIts errors are drawn (seed {}), so its truth is known.\n"
      "\nReadings, with encoders of {} arcsec\n{}"
      "\nWhat the truth says, on {} postures that no calibration has seen\n{}"
      "  Floor: the true geometry itself, read by these encoders, misses by {} mm rms.\n"
      "\nThe cone does not know how long a millimetre is\n{}"
      "\nThe same by hand: armcal simulate --scenario demo -o demo, then armcal calibrate "
      "demo/demo.session.toml\n",
      loaded.scenario.name, simulation.seed,
      fixed(arcseconds_from_radians(loaded.scenario.errors.encoder_noise.u_rad), 1),
      kits_text(simulation), simulation.check->count(), result_text(drawing, attempts),
      fixed(drawing.floor_mm, kDecimals), blindness_text(blindness, attempts[0], attempts[1]));

  demo.json["floor_mm"] = drawing.floor_mm;
  demo.json["drawing"] = json_of(drawing);
  demo.json["calibrations"] = Json::array();
  for (const Attempt& each : attempts) demo.json["calibrations"].push_back(json_of(each));
  demo.json["reference_cmm"] = json_result(attempts[2].calibration);
  demo.json["reference_cmm"]["rows"] =
      json_of_rows(attempts[2].calibration, chosen(simulation, cmm));
  demo.json["cone"] = {{"refusal", blindness.refusal},
                       {"rms_mm", blindness.rms_mm},
                       {"rms_mm_of_grown_arm", blindness.rms_grown_mm},
                       {"growth", kGrowth}};
  return demo;
}

}  // namespace armcal
