// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/paper_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "armcal/comparison/symmetric_readings.h"
#include "armcal/comparison/task_queue.h"
#include "armcal/comparison/wang2016_evaluation.h"
#include "armcal/core/diagnostics.h"
#include "armcal/core/units.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/simulation/symmetric_procedure.h"
#include "armcal/verification/sphere_test.h"

namespace armcal {
namespace {

constexpr int kPoints = 25;
constexpr int kArticulations = 5;
constexpr double kTipRadius_mm = 3.0;

/// What is on while the arm is calibrated, and while it measures the sphere.
struct Effect {
  std::string name;
  std::string brief;
  ErrorSources calibrating;
  ErrorSources measuring;
};

Effect always(std::string name, std::string brief, const ErrorSources& errors) {
  return {std::move(name), std::move(brief), errors, errors};
}

ErrorSources with(const GeometryErrors& geometry) {
  ErrorSources errors;
  errors.geometry = geometry;
  return errors;
}

// One source of the virtual arm in its typical size.
Effect typical(std::string_view source_name, std::string name, std::string brief) {
  ErrorSources errors;
  for (const ErrorSource& source : error_source_list()) {
    if (source.name == source_name) source.switch_on(errors);
  }
  return always(std::move(name), std::move(brief), errors);
}

std::vector<Effect> effects() {
  const GeometryErrors all = GeometryErrors::typical();
  ErrorSources warm;
  warm.thermal_expansion = ThermalExpansion::typical();
  ErrorSources everything = ErrorSources::typical();
  everything.base_movement = {};
  everything.warm_up_drift = {};
  ErrorSources everything_cold = everything;
  everything_cold.thermal_expansion = {};
  return {
      always("lengths", "0.25 mm (what the procedure measures)",
             with({.u_length_mm = all.u_length_mm})),
      always("twists", "0.025 deg", with({.u_twist_rad = all.u_twist_rad})),
      always("zeros", "0.025 deg; those of joints 2 and 4 are searched",
             with({.u_zero_rad = all.u_zero_rad})),
      always("offsets", "0.03 mm of what should be 0", with({.u_offset_mm = all.u_offset_mm})),
      {"temperature", "sphere measured 3 K warmer, 1 K between links", {}, warm},
      typical("encoder_noise", "encoder noise", "2 arcsec"),
      typical("scale_eccentricity", "eccentric scales", "5 and 2 arcsec"),
      typical("bearing_run_out", "bearing run-out", "1 arcsec, 0.5 um"),
      typical("gravity_sag", "sag", "carbon-fibre tubes of 90 mm"),
      typical("probing_force", "probing force", "2 N on 6 + 4 um/N"),
      {"all of these", "", everything_cold, everything},
  };
}

// Over the upper half, at equal steps of height and turning by the golden angle.
std::vector<Eigen::Vector3d> outward_directions() {
  std::vector<Eigen::Vector3d> directions;
  const double golden_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kPoints; ++i) {
    const double height = (i + 0.5) / kPoints;
    const double radius = std::sqrt(1.0 - height * height);
    directions.emplace_back(radius * std::cos(golden_rad * i), radius * std::sin(golden_rad * i),
                            height);
  }
  return directions;
}

struct MeasuredSphere {
  double diameter_error_mm = 0.0;
  double form_mm = 0.0;
};

/// Touches the sphere, point i in the articulation i modulo their number.
/// @throws Impossible, NumericalError
MeasuredSphere measure_sphere(const ArmModel& calibrated, Laboratory& laboratory,
                              const Eigen::Vector3d& centre,
                              std::span<const Eigen::VectorXd> articulations) {
  const VirtualArm& arm = laboratory.arm();
  JointReadings readings;
  readings.encoder_rad.resize(arm.truth().joint_count(), kPoints);
  const auto directions = outward_directions();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d contact =
        centre + (kPaperSphere_mm / 2.0 + kTipRadius_mm) * directions[i];
    const auto posture =
        arm.posture_with_tip_at(contact, articulations[i % articulations.size()],
                                {.time_s = laboratory.time_s(), .push = -directions[i]});
    if (!posture) throw Impossible("a point of the sphere is out of reach");
    readings.encoder_rad.col(static_cast<Eigen::Index>(i)) =
        arm.shown(*posture, laboratory.random());
    readings.lines.push_back(static_cast<int>(i));
  }
  const SphereTest test =
      test_sphere(calibrated, readings,
                  {.certified_diameter_mm = kPaperSphere_mm, .tip_diameter_mm = 2 * kTipRadius_mm});
  if (!test.ok()) throw NumericalError("no sphere through the points");
  return {test.diameter_error_mm, test.form_error_mm.value_or(0.0)};
}

struct Trial {
  MeasuredSphere one, five;
};

std::optional<Trial> trial_of(const Effect& effect, std::uint64_t seed) {
  const ArmModel nominal = romer_arm();
  try {
    Laboratory calibrating(VirtualArm(nominal, effect.calibrating, seed), seed);
    const SymmetricPointProcedure procedure =
        carry_out(calibrating, wang2016_procedure(), {.u_point_mm = 0.0, .repeats = 1});
    const FoundArm found = wang2016_chain(analysed(procedure, nominal));
    Laboratory measuring(VirtualArm(nominal, effect.measuring, seed), seed);
    measuring.begin(1);
    const Eigen::Vector3d centre = measuring.convenient_point();
    const auto articulations = measuring.postures_with_tip_at(centre, kArticulations, "sphere");
    const std::span<const Eigen::VectorXd> all(articulations);
    return Trial{measure_sphere(found.arm, measuring, centre, all.first(1)),
                 measure_sphere(found.arm, measuring, centre, all)};
  } catch (const Impossible&) {
  } catch (const NumericalError&) {
  }
  return std::nullopt;  // another arm stands for it
}

double quantile(std::vector<double> values, double probability) {
  std::sort(values.begin(), values.end());
  const double place = probability * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

DiameterErrors errors_of(const std::vector<MeasuredSphere>& spheres) {
  std::vector<double> magnitudes;
  std::vector<double> forms;
  DiameterErrors errors;
  for (const MeasuredSphere& sphere : spheres) {
    magnitudes.push_back(std::abs(sphere.diameter_error_mm));
    forms.push_back(sphere.form_mm);
    if (magnitudes.back() >= -kPaperSphereError_mm) errors.share_as_large += 1.0;
  }
  errors.share_as_large /= static_cast<double>(spheres.size());
  errors.median_mm = quantile(magnitudes, 0.5);
  errors.largest95_mm = quantile(magnitudes, 0.95);
  errors.median_form_mm = quantile(forms, 0.5);
  return errors;
}

NeglectedEffect summary_of(const Effect& effect, std::span<const std::optional<Trial>> trials) {
  NeglectedEffect summary{effect.name, effect.brief, 0, {}, {}};
  std::vector<MeasuredSphere> one;
  std::vector<MeasuredSphere> five;
  for (const auto& trial : trials) {
    if (!trial) continue;
    one.push_back(trial->one);
    five.push_back(trial->five);
  }
  summary.arms = static_cast<int>(one.size());
  if (one.empty()) return summary;
  summary.one_articulation = errors_of(one);
  summary.five_articulations = errors_of(five);
  return summary;
}

}  // namespace

std::vector<NeglectedEffect> study_paper_sphere(const PaperSphereOptions& options) {
  const std::vector<Effect> all = effects();
  const auto arms = static_cast<std::size_t>(options.arms);
  std::vector<std::optional<Trial>> trials(all.size() * arms);
  do_tasks(std::vector<double>(trials.size(), 1.0), options.threads, options.monitor,
           "measuring spheres", [&](std::size_t task) {
             trials[task] = trial_of(all[task / arms], options.seed + task % arms);
           });
  std::vector<NeglectedEffect> summaries;
  for (std::size_t e = 0; e < all.size(); ++e)
    summaries.push_back(summary_of(all[e], std::span(trials).subspan(e * arms, arms)));
  return summaries;
}

}  // namespace armcal
